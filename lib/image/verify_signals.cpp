// Signals, and the switches and sensors that the RPDOs carry.
#include "facts/gateway.hpp"
#include "image/bytes.hpp"
#include "image/verify.hpp"

namespace cgw::image {
namespace {

constexpr std::size_t first_rpdo = facts::tpdo_count;  // position in the PDO table

bool signal_fits(const Signal& signal) {
    if (signal.width != 8 && signal.width != 16) {
        return false;
    }
    const std::int32_t span = std::int32_t{1} << signal.width;
    const std::int32_t lowest = signal.is_signed ? -span / 2 : 0;
    return signal.internal_minimum >= lowest && signal.internal_maximum < lowest + span &&
           signal.internal_minimum < signal.internal_maximum;
}

bool has_signal(const Image& image, std::uint16_t number) {
    Signal ignored;
    return image.find_signal(number, ignored);
}

// TPDO4..16 carry a parameter in every word, TPDO1..3 and RPDO1 in none.
bool parameters_fit(const Image& image, const Pdo& pdo) {
    const bool analogue = pdo.receive ? pdo.number != 1 : pdo.number > facts::binary_tpdos;
    for (std::size_t word = 0; word < pdo.word_count; ++word) {
        const MappedObject& mapped = pdo.mapping[word];
        const bool wanted = analogue && !(pdo.receive && mapped.index != facts::object::sensors);
        if (wanted ? !has_signal(image, mapped.parameter) : mapped.parameter != 0) {
            return false;
        }
    }
    return true;
}

bool maps(const Pdo& pdo, std::size_t word, std::uint16_t index, std::uint8_t sub_index) {
    return word < pdo.word_count && pdo.mapping[word].index == index &&
           pdo.mapping[word].sub_index == sub_index;
}

}  // namespace

bool signals_fit(const Image& image) {
    for (std::size_t i = 0; i < image.signal_count(); ++i) {
        if (!signal_fits(image.signal(i))) {
            return false;
        }
    }
    for (std::size_t i = 0; i < pdo::count; ++i) {
        if (!parameters_fit(image, image.pdo(i))) {
            return false;
        }
    }
    return true;
}

bool inputs_fit(const Image& image) {
    if (image.switch_count() != 0 &&
        !maps(image.pdo(first_rpdo), 0, facts::object::binary_inputs, facts::object::switches_sub)) {
        return false;
    }
    for (std::size_t i = 0; i < image.sensor_count(); ++i) {
        const Sensor sensor = image.sensor(i);
        const Pdo pdo = image.pdo(first_rpdo + facts::rpdo_of_channel(sensor.channel) - 1U);
        if (!maps(pdo, facts::word_of_channel(sensor.channel) - 1U, facts::object::sensors, sensor.channel) ||
            !has_signal(image, sensor.number)) {
            return false;
        }
    }
    return true;
}

}  // namespace cgw::image
