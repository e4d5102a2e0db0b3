// The words that pass through: from the governor to objects and transmit PDOs, from receive PDOs to the
// governor.
#include "device/gateway.hpp"
#include "wire/little_endian.hpp"

namespace cgw::device {
namespace {

using facts::word_bytes;
using facts::words_per_pdo;

constexpr std::uint16_t engine_state_bits = 0x00FF;          // D22: the low byte
constexpr std::uint8_t error_register_generic = 0x01;        // D58: any error
constexpr std::uint8_t error_register_communication = 0x10;  // D58: 2005h is not 0

}  // namespace

void Gateway::request_transmit_pdos(unsigned elapsed) {
    for (std::size_t position = 0; position < binary_pdos; ++position) {
        slave_.request_if_changed(position);
    }
    for (std::size_t position = binary_pdos; position < transmit_pdos; ++position) {
        Rhythm& rhythm = rhythms_[position];
        if (rhythm.cycles == 0) {
            continue;
        }
        if (rhythm.left < elapsed) {
            slave_.request(position);
            const unsigned late = (elapsed - 1 - rhythm.left) % rhythm.cycles;
            rhythm.left = static_cast<std::uint16_t>(rhythm.cycles - 1 - late);
        } else {
            rhythm.left = static_cast<std::uint16_t>(rhythm.left - elapsed);
        }
    }
}

void Gateway::store(const GovernorData& data) {
    governor_errors_ = data.errors;
    store_errors();
    if (places_.has_engine_state) {
        set(places_.engine_state, data.engine_state & engine_state_bits);
    }
    for (std::size_t position = binary_pdos; position < transmit_pdos; ++position) {
        store_analogue(position, data.analogue[position - binary_pdos]);
    }
}

// D58: an error bit is set when either device has the error.
void Gateway::store_errors() {
    bool any_error = false;
    for (std::size_t word = 0; word < error_words; ++word) {
        const unsigned both = unsigned{governor_errors_[word]} | errors_.words()[word];
        set(places_.errors[word], both);
        any_error = any_error || both != 0;
    }
    set(places_.canopen_errors, errors_.canopen_errors());
    set(places_.error_register,
        static_cast<std::uint32_t>((any_error ? error_register_generic : 0) |
                                   (errors_.canopen_errors() != 0 ? error_register_communication : 0)));
}

void Gateway::store_analogue(std::size_t position, const PdoWords& words) {
    canopen::PdoData data;
    for (std::size_t word = 0; word < words_per_pdo; ++word) {
        wire::store_u16(&data[word * word_bytes], words[word]);
    }
    canopen::scatter(rows_[position], data, values_);
}

void Gateway::set(const object::ObjectEntry& entry, std::uint32_t value) {
    object::store_value(values_, entry, value);
}

void Gateway::forward(std::size_t rpdo_row) {
    canopen::PdoData data{};
    canopen::gather(rows_[transmit_pdos + rpdo_row], values_, data);
    PdoWords words;
    for (std::size_t word = 0; word < words_per_pdo; ++word) {
        words[word] = wire::load_u16(&data[word * word_bytes]);
    }
    governor_->process_data(static_cast<std::uint8_t>(rpdo_row + 1), words);
}

}  // namespace cgw::device
