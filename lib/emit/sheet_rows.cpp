#include "emit/sheet_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "base/sheet_words.hpp"
#include "base/text_cells.hpp"
#include "config/numbers.hpp"
#include "emit/pdo_rows.hpp"

namespace cgw::emit {

namespace governor = config::governor;
namespace gateway = config::gateway;
using parameter::Device;
using parameter::ParameterSet;
using parameter::Role;
using parameter::Row;

const std::array<std::string_view, 4> closing_steps = {
    "Save the parameters in the governor.",
    "Save the parameters in the gateway.",
    "Reset BOTH devices: neither takes over a new configuration before its reset (GWM 7).",
    "Read all parameters back and compare them with this sheet.",
};

const std::string_view switches_remark =
    "Switch functions and sensors that are not listed do not come over CANopen: their 48nn and 49nn must "
    "not be 3.";

const std::string_view tables_remark =
    "The table \"set these\" holds only what differs from the default: it is enough for a device whose other "
    "values are 0. Into any other device type the table \"all that concern CANopen\".";

const std::string_view defaults_remark = "Default 0 is an assumption: the manuals print no defaults.";

namespace {

// Parameters on which the Gateway's work depends, assigned or not.
struct Range {
    Device device;
    std::uint16_t first;
    std::uint16_t last;
    std::uint16_t only_with = 0;     // this one is 1
    std::uint16_t only_without = 0;  // this one is not 1
};

constexpr Range deciding[] = {
    {Device::governor, governor::start_up_delay, governor::gateway_node},
    {Device::governor, governor::prescaler, governor::bit_rate - 1, governor::manual_timing},
    {Device::governor, governor::bit_rate, governor::bit_rate, 0, governor::manual_timing},
    {Device::governor, governor::gateway_communication, governor::gateway_communication},
    {Device::governor, governor::manual_timing, governor::manual_timing},
    {Device::governor, governor::send_errors, governor::send_status},
    {Device::governor, governor::tpdo_assignment, governor::last_tpdo_assignment},
    {Device::governor, governor::tpdo_cycle, governor::last_tpdo_cycle},
    {Device::governor, governor::rpdo_monitoring, governor::last_rpdo_monitoring},
    {Device::gateway, gateway::start_up_delay, gateway::governor_node},
    {Device::gateway, gateway::hzm_prescaler, gateway::hzm_bit_rate - 1, gateway::hzm_manual_timing},
    {Device::gateway, gateway::hzm_bit_rate, gateway::hzm_bit_rate, 0, gateway::hzm_manual_timing},
    {Device::gateway, gateway::canopen_prescaler, gateway::canopen_bit_rate - 1,
     gateway::canopen_manual_timing},
    {Device::gateway, gateway::canopen_bit_rate, gateway::canopen_bit_rate, 0,
     gateway::canopen_manual_timing},
    {Device::gateway, gateway::canopen_bit_rate + 1, gateway::heartbeat_consumer},
    {Device::gateway, gateway::governor_communication, gateway::governor_communication},
    {Device::gateway, gateway::hzm_manual_timing, gateway::hzm_manual_timing},
    {Device::gateway, gateway::canopen_manual_timing, gateway::canopen_manual_timing},
    {Device::gateway, gateway::tpdo_identifier, gateway::last_tpdo_identifier},
};

// 8nn of a 48nn and the reverse, 0 for other parameters.
std::uint16_t counterpart(const Row& row) {
    switch (row.role) {
        case Role::none:
            return 0;
        case Role::switch_assignment:
        case Role::sensor_assignment:
            return governor::type_of(row.number);
        case Role::switch_type:
        case Role::sensor_type:
            return governor::assignment_of(row.number);
    }
    return 0;
}

bool is_concerned(const Row& row, const ParameterSet& set) {
    if (!row.settable()) {
        return false;
    }
    if (set.find(row.number) != nullptr || set.find(counterpart(row)) != nullptr) {
        return true;
    }
    return std::any_of(std::begin(deciding), std::end(deciding), [&](const Range& range) {
        return range.device == row.device && row.number >= range.first && row.number <= range.last &&
               (range.only_with == 0 || set.value(range.only_with) == 1) &&
               (range.only_without == 0 || set.value(range.only_without) != 1);
    });
}

// Never exactly three decimals behind a digit other than 0: "12.345" would be a thousand things to a reader
// who writes decimals with a comma, and cgw itself refuses to read it back.
std::string decimal_text(double value) {
    std::string text = base::to_text(value);
    if (text.find('e') != std::string::npos) {
        text = fmt::format("{:.15f}", value);
        text.erase(text.find_last_not_of('0') + 1);
        text.erase(text.ends_with('.') ? text.size() - 1 : text.size());
    }
    const std::size_t point = text.find('.');
    return point != std::string::npos && text.size() - point == 4 ? text + "0" : text;
}

SheetRow sheet_row(const Row& row, double value) {
    SheetRow result;
    result.row = &row;
    const bool is_hexadecimal = row.base == parameter::Base::hexadecimal && value >= 0;
    result.value =
        is_hexadecimal ? fmt::format("{:X}", static_cast<std::uint32_t>(value)) : decimal_text(value);
    result.unit = is_hexadecimal ? "Hex" : std::string(row.unit);
    result.default_value = row.minimum && *row.minimum > 0 ? "-" : "0";
    result.differs = value != 0;
    return result;
}

DeviceSheet device_sheet(const Plant& plant, Device device) {
    DeviceSheet sheet;
    sheet.device = device;
    const ParameterSet& set = plant.settings.of(device);
    for (const Row* row : concerned_rows(plant.catalogue, device, set)) {
        sheet.rows.push_back(sheet_row(*row, set.value(row->number)));
    }
    return sheet;
}

// It decides how times are rounded (D8), and no parameter says it.
std::string main_cycle_remark(const parameter::Settings& settings) {
    return settings.main_cycle_us == parameter::Settings{}.main_cycle_us
               ? ""
               : fmt::format("{}{} us. It is no parameter: nothing to type.", base::sheet_main_cycle,
                             settings.main_cycle_us);
}

}  // namespace

std::vector<const Row*> concerned_rows(const parameter::Catalogue& catalogue, Device device,
                                       const ParameterSet& set) {
    std::vector<const Row*> rows;
    for (const Row* row : catalogue.rows(device)) {
        if (is_concerned(*row, set)) {
            rows.push_back(row);
        }
    }
    return rows;
}

EntrySheet entry_sheet(const Plant& plant) {
    return {plant.settings.title,
            plant.configuration_id_text,
            plant.configuration.node_id,
            main_cycle_remark(plant.settings),
            plant.settings.main_cycle_us,
            {device_sheet(plant, Device::governor), device_sheet(plant, Device::gateway)}};
}

std::string heading_of(const EntrySheet& sheet) {
    return sheet.title.empty() ? "Entry sheet"
                               : fmt::format("{}{}", base::sheet_heading, base::one_line(sheet.title));
}

std::string_view device_heading(Device device) {
    return device == Device::governor ? "Governor" : "Gateway";
}

}  // namespace cgw::emit
