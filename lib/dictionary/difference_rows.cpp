#include "dictionary/difference_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "base/canopen_text.hpp"
#include "base/utf8.hpp"
#include "dictionary/data_types.hpp"
#include "dictionary/value_text.hpp"

namespace cgw::dictionary {
namespace {

constexpr std::string_view none = "none";

std::string yes_or_no(bool value) {
    return value ? "yes" : "no";
}
std::string hexadecimal(std::uint32_t number) {
    return fmt::format("0x{:X}", number);
}
std::string decimal(std::uint64_t number) {
    return fmt::format("{}", number);
}

using DeviceRow = AspectRow<DeviceInformation>;

constexpr std::array of_device{
    DeviceRow{"vendor-name", "vendor name", false, [](const auto& d) { return d.vendor_name; }},
    DeviceRow{"vendor-number", "vendor number", false,
              [](const auto& d) { return hexadecimal(d.vendor_number); }},
    DeviceRow{"product-name", "product name", false, [](const auto& d) { return d.product_name; }},
    DeviceRow{"product-number", "product number", false,
              [](const auto& d) { return hexadecimal(d.product_number); }},
    DeviceRow{"revision-number", "revision number", false,
              [](const auto& d) { return hexadecimal(d.revision_number); }},
    DeviceRow{"order-code", "order code", false, [](const auto& d) { return d.order_code; }},
    DeviceRow{"bit-rates", "bit rates, kbit/s", false,
              [](const auto& d) {
                  std::vector<unsigned> rates = d.bit_rates_kbit;
                  std::sort(rates.begin(), rates.end());
                  return fmt::format("{}", fmt::join(rates, " "));
              }},
    DeviceRow{"boot-up-master", "simple boot-up master", false,
              [](const auto& d) { return yes_or_no(d.simple_boot_up_master); }},
    DeviceRow{"boot-up-slave", "simple boot-up slave", false,
              [](const auto& d) { return yes_or_no(d.simple_boot_up_slave); }},
    DeviceRow{"granularity", "granularity of mapping, bits", false,
              [](const auto& d) { return decimal(d.granularity); }},
    DeviceRow{"dynamic-channels", "dynamic channels", false,
              [](const auto& d) { return yes_or_no(d.dynamic_channels); }},
    DeviceRow{"group-messaging", "group messaging", false,
              [](const auto& d) { return yes_or_no(d.group_messaging); }},
    DeviceRow{"receive-pdos", "number of RPDOs", false,
              [](const auto& d) { return decimal(d.receive_pdos); }},
    DeviceRow{"transmit-pdos", "number of TPDOs", false,
              [](const auto& d) { return decimal(d.transmit_pdos); }},
    DeviceRow{"lss", "LSS", false, [](const auto& d) { return yes_or_no(d.lss_supported); }},
};

using NodeRow = AspectRow<Commissioning>;

constexpr std::array of_node{
    NodeRow{"node-id", "node-ID", false, [](const auto& n) { return decimal(n.node_id); }},
    NodeRow{"node-name", "node name", false, [](const auto& n) { return n.node_name; }},
    NodeRow{
        "bit-rate", "bit rate, kbit/s", false,
        [](const auto& n) { return n.bit_rate_kbit ? decimal(*n.bit_rate_kbit) : std::string(not_stated); }},
    NodeRow{"net-number", "network number", false, [](const auto& n) { return decimal(n.net_number); }},
    NodeRow{"network-name", "network name", false, [](const auto& n) { return n.network_name; }},
    NodeRow{"manager", "CANopen manager", false, [](const auto& n) { return yes_or_no(n.canopen_manager); }},
    NodeRow{"serial-number", "serial number", false,
            [](const auto& n) { return hexadecimal(n.serial_number); }},
    NodeRow{"connected-modules", "connected modules", false,
            [](const auto& n) {
                return n.connected_modules.empty() ? std::string(none)
                                                   : fmt::format("{}", fmt::join(n.connected_modules, " "));
            }},
};

using ModuleRow = AspectRow<Module>;

constexpr std::array of_module{
    ModuleRow{"product-name", "product name", false, [](const auto& m) { return m.product_name; }},
    ModuleRow{"product-version", "product version", false,
              [](const auto& m) { return decimal(m.product_version); }},
    ModuleRow{"product-revision", "product revision", false,
              [](const auto& m) { return decimal(m.product_revision); }},
    ModuleRow{"order-code", "order code", false, [](const auto& m) { return m.order_code; }},
};

using ObjectRow = AspectRow<Object>;

constexpr std::array of_object{
    ObjectRow{"object-type", "object type", false,
              [](const auto& o) { return std::string(object_code_text(o.code)); }},
    ObjectRow{"links", "object links", false,
              [](const auto& o) {
                  std::string links;
                  for (const std::uint16_t index : o.object_links) {
                      links += (links.empty() ? "" : " ") + base::object_text(index);
                  }
                  return links;
              }},
};
constexpr std::array of_sub_objects{
    ObjectRow{"name", "name", false, [](const auto& o) { return base::to_utf8(o.name); }},
    ObjectRow{"flags", "ObjFlags", false, [](const auto& o) { return hexadecimal(o.flags); }},
};

Value resolved(const Place& place, const Value& value) {
    return place.node_id && value.node_id_relative ? Value{value.resolve(*place.node_id), false} : value;
}

std::string shown(const Place& place, const Value& stated) {
    const Value value = resolved(place, stated);
    const bool mapping = is_mapping_entry(place.index, place.variable.sub_index) && !value.node_id_relative &&
                         place.variable.type == object::DataType::unsigned32;
    return mapping ? mapping_text(static_cast<std::uint32_t>(value.number))
                   : value_text(place.variable.type, value);
}

std::string limit_text(const Place& place, const std::optional<Value>& limit) {
    return limit ? value_text(place.variable.type, resolved(place, *limit)) : std::string(not_stated);
}

using VariableRow = AspectRow<Place>;

constexpr std::array of_variable{
    VariableRow{"name", "name", false, [](const auto& p) { return base::to_utf8(p.variable.name); }},
    VariableRow{"data-type", "data type", true,
                [](const auto& p) { return std::string(row_of(p.variable.type).name); }},
    VariableRow{"access", "access", true,
                [](const auto& p) { return std::string(access_text(p.variable.access)); }},
    VariableRow{"pdo-mapping", "PDO mapping", true,
                [](const auto& p) { return yes_or_no(p.variable.pdo_mapping); }},
    VariableRow{"default", "default value", true,
                [](const auto& p) {
                    return p.variable.no_default ? std::string(not_stated)
                                                 : shown(p, p.variable.default_value);
                }},
    VariableRow{"low-limit", "low limit", false,
                [](const auto& p) { return limit_text(p, p.variable.low_limit); }},
    VariableRow{"high-limit", "high limit", false,
                [](const auto& p) { return limit_text(p, p.variable.high_limit); }},
    VariableRow{"flags", "ObjFlags", false, [](const auto& p) { return hexadecimal(p.variable.flags); }},
};

// Of two configuration files.
constexpr std::array of_set_value{
    VariableRow{"value", "value set", false,
                [](const auto& p) {
                    const Variable& variable = p.variable;
                    return variable.parameter_value ? shown(p, *variable.parameter_value)
                           : variable.no_default    ? std::string(not_stated)
                                                    : shown(p, variable.default_value);
                }},
};

// Of two configuration files as well, whether they set a value or not.
constexpr std::array of_configured_object{
    ObjectRow{"denotation", "denotation", false, [](const auto& o) { return o.denotation; }},
};
constexpr std::array of_configured_variable{
    VariableRow{"denotation", "denotation", false, [](const auto& p) { return p.variable.denotation; }},
    VariableRow{"upload-file", "upload file", false, [](const auto& p) { return p.variable.upload_file; }},
    VariableRow{"download-file", "download file", false,
                [](const auto& p) { return p.variable.download_file; }},
};

}  // namespace

std::span<const AspectRow<DeviceInformation>> device_rows() {
    return of_device;
}
std::span<const AspectRow<Commissioning>> node_rows() {
    return of_node;
}
std::span<const AspectRow<Module>> module_rows() {
    return of_module;
}
std::span<const AspectRow<Object>> object_rows() {
    return of_object;
}
std::span<const AspectRow<Object>> sub_object_rows() {
    return of_sub_objects;
}
std::span<const AspectRow<Place>> variable_rows() {
    return of_variable;
}
std::span<const AspectRow<Place>> set_value_rows() {
    return of_set_value;
}
std::span<const AspectRow<Object>> configured_object_rows() {
    return of_configured_object;
}
std::span<const AspectRow<Place>> configured_variable_rows() {
    return of_configured_variable;
}

bool sets_value(const Place& place) {
    const Variable& variable = place.variable;
    return variable.parameter_value && (variable.no_default || !(resolved(place, *variable.parameter_value) ==
                                                                 resolved(place, variable.default_value)));
}

std::string dummies_text(const Dictionary& dictionary) {
    std::string text;
    for (const std::uint8_t number : dictionary.supported_dummies) {
        const TypeRow* const type = find_type(number);
        text += fmt::format("{}{}", text.empty() ? "" : " ",
                            type != nullptr ? std::string(type->name) : hexadecimal(number));
    }
    return text.empty() ? "none" : text;
}

}  // namespace cgw::dictionary
