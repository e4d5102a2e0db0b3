#include "link/governor_half.hpp"

#include "facts/gateway.hpp"

namespace cgw::link {
namespace {

constexpr std::uint16_t words = facts::analogue_tpdos * facts::words_per_pdo;
constexpr std::uint16_t low_active = 0x100;

// The fixed items, in order: how many of each kind.
struct Part {
    ItemKind kind;
    std::uint16_t count;
};
constexpr Part fixed[] = {
    {ItemKind::version, 1},
    {ItemKind::governor_node, 1},
    {ItemKind::gateway_node, 1},
    {ItemKind::send_errors, 1},
    {ItemKind::send_status, 1},
    {ItemKind::main_cycle, 2},
    {ItemKind::assignment, words},
    {ItemKind::cycles, facts::analogue_tpdos},
    {ItemKind::monitoring, facts::rpdo_count},
};
constexpr std::uint16_t fixed_count() {
    std::uint16_t count = 0;
    for (const Part& part : fixed) {
        count = static_cast<std::uint16_t>(count + part.count);
    }
    return count;
}

std::uint16_t assignment(const image::Image& image, std::uint8_t position) {
    const image::Pdo pdo = image.pdo(facts::binary_tpdos + position / facts::words_per_pdo);
    const std::size_t word = position % facts::words_per_pdo;
    return word < pdo.word_count ? pdo.mapping[word].parameter : std::uint16_t{0};
}

std::uint16_t fixed_value(const image::Image& image, ItemKind kind, std::uint8_t position) {
    const image::Governor governor = image.governor();
    switch (kind) {
        case ItemKind::version:
            return GovernorHalf::format;
        case ItemKind::governor_node:
            return governor.own_node;
        case ItemKind::gateway_node:
            return governor.gateway_node;
        case ItemKind::send_errors:
            return governor.send_errors ? 1 : 0;
        case ItemKind::send_status:
            return governor.send_status ? 1 : 0;
        case ItemKind::main_cycle:
            return static_cast<std::uint16_t>(governor.main_cycle_us >>
                                              (position == 0 ? 0 : facts::word_bits));
        case ItemKind::assignment:
            return assignment(image, position);
        case ItemKind::cycles:
            return image.pdo(facts::binary_tpdos + position).cycles;
        case ItemKind::monitoring:
            return image.pdo(facts::tpdo_count + position).cycles;
        default:
            return 0;
    }
}

}  // namespace

GovernorHalf::GovernorHalf(const image::Image& image)
    : image_(&image),
      switches_(static_cast<std::uint16_t>(image.switch_count())),
      sensors_(static_cast<std::uint16_t>(image.sensor_count())) {
    count_ = static_cast<std::uint16_t>(fixed_count() + 1 + 2 * switches_ + 1 + 2 * sensors_);
}

Item GovernorHalf::item(std::uint16_t index) const {
    std::uint16_t rest = index;
    for (const Part& part : fixed) {
        if (rest < part.count) {
            const auto position = static_cast<std::uint8_t>(rest);
            return {part.kind, position, fixed_value(*image_, part.kind, position)};
        }
        rest = static_cast<std::uint16_t>(rest - part.count);
    }
    return input_item(rest);
}

// Behind the fixed items: switches and sensors, each with a count before the pairs.
Item GovernorHalf::input_item(std::uint16_t index) const {
    if (index == 0) {
        return {ItemKind::switches, 0, switches_};
    }
    const std::uint16_t of_switch = static_cast<std::uint16_t>(index - 1);
    const auto position = static_cast<std::uint8_t>(of_switch / 2);
    if (position < switches_) {
        const image::SwitchFunction function = image_->switch_function(position);
        const auto bit = static_cast<std::uint16_t>(function.bit + (function.low_active ? low_active : 0));
        return of_switch % 2 == 0 ? Item{ItemKind::switch_number, position, function.number}
                                  : Item{ItemKind::switch_bit, position, bit};
    }
    const auto rest = static_cast<std::uint16_t>(of_switch - 2 * switches_);
    if (rest == 0) {
        return {ItemKind::sensors, 0, sensors_};
    }
    const auto of_sensor = static_cast<std::uint8_t>((rest - 1) / 2);
    const image::Sensor sensor = image_->sensor(of_sensor);
    return (rest - 1) % 2 == 0 ? Item{ItemKind::sensor_number, of_sensor, sensor.number}
                               : Item{ItemKind::sensor_channel, of_sensor, sensor.channel};
}

}  // namespace cgw::link
