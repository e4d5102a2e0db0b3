#include "runtime/event_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "device/gateway_errors.hpp"
#include "runtime/measurements.hpp"

namespace cgw::runtime {
namespace {

using link::ItemKind;

// 12421..12424 say again what 3070..3073 say.
bool repeats_own_error(std::uint16_t canopen_error) {
    const auto rows = device::fault_rows();
    return std::any_of(rows.begin(), rows.end(), [canopen_error](const device::FaultRow& row) {
        return row.canopen_error == canopen_error && row.error != 0;
    });
}

std::set<std::uint16_t> numbers_of(const device::GatewayStatus& status) {
    std::set<std::uint16_t> numbers;
    for (unsigned bit = 0; bit < facts::error_bits; ++bit) {
        const unsigned word = status.errors[bit / facts::word_bits];
        const std::uint16_t number = facts::error_number(bit);
        if (((word >> (bit % facts::word_bits)) & 1U) != 0 &&
            number != device::GatewayErrors::can_open_error) {
            numbers.insert(number);
        }
    }
    for (std::uint16_t number = facts::first_canopen_error; number <= facts::last_canopen_error; ++number) {
        const unsigned bit = number - unsigned{facts::first_canopen_error};
        if (((unsigned{status.canopen_errors} >> bit) & 1U) != 0 && !repeats_own_error(number)) {
            numbers.insert(number);
        }
    }
    return numbers;
}

std::string line_of_error(std::uint16_t number) {
    const parameter::Row* const row = gateway_row(number);
    return row == nullptr ? fmt::format("error {}", number)
                          : fmt::format("error {}: {}", parameter::label(*row), row->text);
}

struct ItemText {
    ItemKind kind;
    std::string_view text;
};

// What an item of the governor's half is, by the parameters it comes from.
constexpr ItemText item_texts[] = {
    {ItemKind::version, "version of the governor link"},
    {ItemKind::governor_node, "401 of the governor"},
    {ItemKind::gateway_node, "403 of the governor"},
    {ItemKind::send_errors, "14401"},
    {ItemKind::send_status, "14402"},
    {ItemKind::main_cycle, "main cycle of the governor"},
    {ItemKind::assignment, "parameter sent in a TPDO"},
    {ItemKind::cycles, "cycle of a TPDO"},
    {ItemKind::monitoring, "monitoring of an RPDO"},
    {ItemKind::switches, "number of switch functions"},
    {ItemKind::switch_number, "switch function"},
    {ItemKind::switch_bit, "bit of a switch function"},
    {ItemKind::sensors, "number of sensors"},
    {ItemKind::sensor_number, "sensor"},
    {ItemKind::sensor_channel, "channel of a sensor"},
};

// The item's place in words, where its kind has several.
std::string place_of(const link::Item& item) {
    switch (item.kind) {
        case ItemKind::assignment:
            return fmt::format(" (word {} of TPDO{})", item.position % facts::words_per_pdo + 1,
                               facts::first_analogue_tpdo + item.position / facts::words_per_pdo);
        case ItemKind::cycles:
            return fmt::format(" (TPDO{})", facts::first_analogue_tpdo + item.position);
        case ItemKind::monitoring:
            return fmt::format(" (RPDO{})", item.position + 1);
        case ItemKind::switch_number:
        case ItemKind::switch_bit:
        case ItemKind::sensor_number:
        case ItemKind::sensor_channel:
            return fmt::format(" (the {}. in the list)", item.position + 1);
        default:
            return {};
    }
}

}  // namespace

std::string_view state_text(device::GatewayState state) {
    constexpr std::string_view texts[] = {"Undefined", "Init", "Pre-Operational", "Operational", "Stopped"};
    return texts[static_cast<std::size_t>(state)];
}

std::vector<std::string> lines_of_change(const device::GatewayStatus& before,
                                         const device::GatewayStatus& now) {
    std::vector<std::string> lines;
    const std::set<std::uint16_t> old_errors = numbers_of(before);
    const std::set<std::uint16_t> new_errors = numbers_of(now);
    for (const std::uint16_t number : new_errors) {
        if (!old_errors.contains(number)) {
            lines.push_back(line_of_error(number));
        }
    }
    if (before.state != now.state) {
        lines.push_back(fmt::format("state {}", state_text(now.state)));
    }
    for (const std::uint16_t number : old_errors) {
        if (!new_errors.contains(number)) {
            lines.push_back(fmt::format("cleared {}", gateway_label(number)));
        }
    }
    return lines;
}

std::string line_of_refusal(const link::Refusal& refusal) {
    constexpr std::string_view begin = "the governor's configuration is refused: ";
    if (refusal.incomplete) {
        return std::string(begin) + "telegrams of it are missing";
    }
    const link::Item& item = refusal.expected;
    const auto* const row = std::ranges::find(item_texts, item.kind, &ItemText::kind);
    return fmt::format("{}{}{}: governor {}, gateway {}", begin,
                       row == std::end(item_texts) ? "an item" : row->text, place_of(item), refusal.received,
                       item.value);
}

}  // namespace cgw::runtime
