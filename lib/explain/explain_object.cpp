#include <fmt/format.h>

#include "catalogue/objects.hpp"
#include "config/configuration.hpp"
#include "config/numbers.hpp"
#include "dictionary/data_types.hpp"
#include "explain/device_objects.hpp"
#include "explain/entries.hpp"
#include "explain/wording.hpp"
#include "profile/gateway.hpp"

namespace cgw::explain {

namespace {

using catalogue::ObjectDescription;
using parameter::Catalogue;
using parameter::Device;

// Settings with every object in use whose existence depends on them, apart from the analogue outputs.
parameter::Settings telling_settings(const Catalogue& catalogue) {
    namespace numbers = config::governor;
    struct Setting {
        std::uint16_t number;
        double value;
    };
    const Setting settings_of_governor[] = {
        {numbers::send_errors, 1},
        {numbers::send_status, 1},
        {numbers::first_switch, 1},
        {numbers::type_of(numbers::first_switch), numbers::canopen_type},
        {numbers::first_sensor, config::sensor_channels},
        {numbers::type_of(numbers::first_sensor), numbers::canopen_type},
    };
    parameter::Settings settings;
    for (const Setting& setting : settings_of_governor) {
        parameter::Assignment assignment;
        assignment.row = catalogue.find(Device::governor, setting.number);
        assignment.value = setting.value;
        if (assignment.row != nullptr) {
            settings.governor.assign(assignment);
        }
    }
    return settings;
}

// 2001h and 2002h have no entries here that could say their type (D43).
object::DataType type_of(std::uint16_t index, const dictionary::Variable* variable) {
    if (variable != nullptr) {
        return variable->type;
    }
    return index == config::object::signed_outputs ? object::DataType::integer16
                                                   : object::DataType::unsigned16;
}

std::string_view access_text(const dictionary::Variable* variable) {
    const bool by_rpdo = variable != nullptr && variable->access == object::Access::rww;
    return by_rpdo ? "read by SDO, written by RPDO only" : "read by SDO, cannot be written";
}

// A value that no parameter decides: vendor number, transmission type.
std::string value_text(const ObjectDescription& description, const dictionary::Variable& variable) {
    const std::uint64_t value = variable.default_value.number;
    return description.source.empty() && value != 0 ? fmt::format("{} (0x{:X})", value, value) : "";
}

std::string entries_text(const dictionary::Object& object) {
    std::string text;
    for (const dictionary::Variable& variable : object.variables) {
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", variable.sub_index, variable.name);
    }
    return text;
}

// The names of these entries are those of the parameters that a configuration puts there.
bool has_configured_names(std::uint16_t index) {
    return index == config::object::unsigned_outputs || index == config::object::signed_outputs ||
           index == config::object::sensors;
}

}  // namespace

DeviceObjects::DeviceObjects(const Catalogue& catalogue)
    : dictionary_(profile::gateway_dictionary(config::resolve(telling_settings(catalogue), catalogue), {})) {}

std::optional<Entry> object_entry(const ObjectName& name, const Catalogue& catalogue) {
    const DeviceObjects objects(catalogue);
    const dictionary::Object* object = objects.find(name.index);
    const std::uint8_t sub = name.sub.value_or(0);
    if (object == nullptr || !objects.has(name.index, sub)) {
        return std::nullopt;
    }
    const bool is_variable = object->code == object::ObjectCode::var;
    const bool whole = !name.sub && !is_variable;
    const ObjectDescription& description =
        whole ? *catalogue::find_object(name.index) : *catalogue::find_object(name.index, sub);
    const dictionary::Variable* variable = object->find(sub);
    const bool own_name = variable != nullptr && !is_variable && !has_configured_names(name.index);

    Entry entry{"object", fmt::format("object {} {}", object_text(name.index), object->name), {}};
    if (!whole && !is_variable) {
        entry.title = fmt::format("object {} {}{}{}", object_text(name.index, sub), object->name,
                                  own_name ? ", " : "", own_name ? variable->name : "");
    }
    if (sub == 0 && !whole && !is_variable) {
        entry.add("holds", "how many entries are in use, or the highest one");
    } else {
        entry.add("holds", description.text);
    }
    if (whole) {
        entry.add("entries", has_configured_names(name.index) ? "0 is their number, 1 upward the values"
                                                              : entries_text(*object));
    } else {
        entry.add("type", fmt::format("{}, {}", dictionary::row_of(type_of(name.index, variable)).name,
                                      access_text(variable)));
        if (variable != nullptr && (sub != 0 || is_variable)) {
            entry.add("value", value_text(description, *variable));
        }
        entry.add("bits", bit_lines(catalogue::object_bits(name.index, sub, catalogue)));
    }
    entry.add("comes from", description.source);
    entry.add("source", description.section);
    return entry;
}

}  // namespace cgw::explain
