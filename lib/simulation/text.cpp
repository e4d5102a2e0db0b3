#include "simulation/text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/canopen_text.hpp"
#include "canopen/words.hpp"
#include "simulation/scaling.hpp"

namespace cgw::simulation {
namespace {

using link::ItemKind;

// What an item is of: nothing, TPDO4..16, a word of those, RPDO1..4, a place in a list.
enum class ItemOf : std::uint8_t { plant, tpdo, word, rpdo, list };

struct ItemText {
    ItemKind kind;
    std::string_view text;
    ItemOf of = ItemOf::plant;
};

constexpr ItemText item_texts[] = {
    {ItemKind::version, "format of the list"},
    {ItemKind::governor_node, "401 of the governor"},
    {ItemKind::gateway_node, "403 of the governor"},
    {ItemKind::send_errors, "14401"},
    {ItemKind::send_status, "14402"},
    {ItemKind::main_cycle, "main cycle"},
    {ItemKind::assignment, "parameter in", ItemOf::word},
    {ItemKind::cycles, "main cycles of", ItemOf::tpdo},
    {ItemKind::monitoring, "monitoring cycles of", ItemOf::rpdo},
    {ItemKind::switches, "number of switch functions"},
    {ItemKind::switch_number, "switch function", ItemOf::list},
    {ItemKind::switch_bit, "bit of switch function", ItemOf::list},
    {ItemKind::sensors, "number of sensors"},
    {ItemKind::sensor_number, "sensor", ItemOf::list},
    {ItemKind::sensor_channel, "channel of sensor", ItemOf::list},
};

std::string item_text(const link::Item& item) {
    const unsigned position = item.position;
    for (const ItemText& row : item_texts) {
        if (row.kind != item.kind) {
            continue;
        }
        switch (row.of) {
            case ItemOf::plant:
                return std::string(row.text);
            case ItemOf::tpdo:
                return fmt::format("{} TPDO{}", row.text, facts::first_analogue_tpdo + position);
            case ItemOf::word:
                return fmt::format("{} word {} of TPDO{}", row.text, position % facts::words_per_pdo + 1,
                                   facts::first_analogue_tpdo + position / facts::words_per_pdo);
            case ItemOf::rpdo:
                return fmt::format("{} RPDO{}", row.text, position + 1);
            case ItemOf::list:
                return fmt::format("{} {} of the list", row.text, position + 1);
        }
    }
    return "unknown item";
}

bool continues(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

// Digits after the point that still mean something for a range of this width.
int decimals(double span) {
    if (span > 2000) {
        return 0;
    }
    return span > 20 ? 1 : 2;
}

}  // namespace

std::string_view to_text(canopen::NmtState state) {
    for (const canopen::NmtStateText& row : canopen::nmt_states) {
        if (row.state == state) {
            return row.text;
        }
    }
    return "unknown";
}

std::string_view to_text(canopen::NmtCommand command) {
    for (const canopen::NmtCommandWords& row : canopen::nmt_commands) {
        if (row.command == command) {
            return row.word;
        }
    }
    return "";
}

std::string clipped(std::string_view text, std::size_t width) {
    std::size_t columns = 0;
    std::size_t cut = 0;  // where the text ends if "..." must follow
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (continues(text[i])) {
            continue;
        }
        if (columns + 3 == width) {
            cut = i;
        }
        if (columns == width) {
            return std::string(text.substr(0, cut)) + "...";
        }
        ++columns;
    }
    return std::string(text);
}

std::string parameter_text(const image::Image& image, std::uint16_t number) {
    image::Label label;
    if (image.find_label(number, label) && !label.name.empty()) {
        return fmt::format("{} {}", number, label.name);
    }
    return fmt::format("{}", number);
}

std::string_view unit_text(const image::Image& image, std::uint16_t number) {
    if (!has_scaling(image, number)) {
        return "% of range";
    }
    image::Label label;
    if (image.find_label(number, label) && !label.unit.empty()) {
        return label.unit;
    }
    return facts::is_sensor(number) && image.find_label(facts::measurement_of(number), label) ? label.unit
                                                                                              : "";
}

std::string value_text(const image::Image& image, std::uint16_t number, std::uint16_t word) {
    const Scale scale = scale_of(image, number, 0, 100);
    const int digits =
        has_scaling(image, number) ? decimals(std::abs(scale.external_maximum - scale.external_minimum)) : 1;
    const std::string_view unit = unit_text(image, number);
    return fmt::format("{:.{}f}{}{}", scale.to_engineering(word), digits, unit.empty() ? "" : " ", unit);
}

std::string pdo_text(const image::Pdo& pdo) {
    return base::pdo_name(!pdo.receive, pdo.number);
}

std::string refusal_text(const link::Refusal& refusal) {
    return refusal.incomplete
               ? "telegrams of the governor's configuration are missing"
               : fmt::format("{}: {} at the governor, {} at the gateway", item_text(refusal.expected),
                             refusal.received, refusal.expected.value);
}

}  // namespace cgw::simulation
