#include "profile/gateway.hpp"

#include <fmt/format.h>
#include <array>

#include "dictionary/ascii.hpp"
#include "facts/communication.hpp"
#include "facts/gateway.hpp"
#include "facts/identifiers.hpp"
#include "profile/gateway_objects.hpp"

namespace cgw::profile {
namespace {

using dictionary::Dictionary;
using dictionary::Object;
using dictionary::Variable;
using object::DataType;
using object::ObjectCode;

constexpr std::string_view vendor_name = "Heinzmann GmbH & Co. KG";
constexpr std::string_view product_name = "CANopen Gateway";
constexpr std::size_t description_length = 243;  // CiA 306, [FileInfo]
constexpr std::string_view creation_time = "12:00AM";

using facts::object::consumer_heartbeat;
using facts::object::identity;
using facts::object::producer_heartbeat;

constexpr std::array device_type{VariableRow{0, "Device Type", DataType::unsigned32}};
constexpr std::array error_register{VariableRow{0, "Error Register", DataType::unsigned8, 0, false, true}};
constexpr std::array consumer_heartbeat_entries{
    VariableRow{0, number_of_entries, DataType::unsigned8, 1},
    VariableRow{1, "Consumer Heartbeat Time", DataType::unsigned32},
};
constexpr std::array producer_heartbeat_time{VariableRow{0, "Producer Heartbeat Time", DataType::unsigned16}};
constexpr std::array identity_entries{
    VariableRow{0, "Number of entries", DataType::unsigned8, 4},
    VariableRow{1, "Vendor ID", DataType::unsigned32, facts::vendor_number},
    VariableRow{2, "Product Code", DataType::unsigned32, facts::product_number},
    VariableRow{3, "Revision Number", DataType::unsigned32},
    VariableRow{4, "Serial Number", DataType::unsigned32},
};
constexpr std::array sdo_entries{
    VariableRow{0, number_of_entries, DataType::unsigned8, 2},
    VariableRow{1, "COB-ID Client -> Server", DataType::unsigned32, facts::cob::sdo_request, true},
    VariableRow{2, "COB-ID Server -> Client", DataType::unsigned32, facts::cob::sdo_answer, true},
};

// The communication profile without the PDOs. D42: nothing else of CiA 301 exists in the device.
constexpr std::array communication_objects{
    ObjectRow{facts::object::device_type, "Device Type", ObjectCode::var, device_type},
    ObjectRow{facts::object::error_register, "Error Register", ObjectCode::var, error_register},
    ObjectRow{consumer_heartbeat, "Consumer Heartbeat Time", ObjectCode::array, consumer_heartbeat_entries},
    ObjectRow{producer_heartbeat, "Producer Heartbeat Time", ObjectCode::var, producer_heartbeat_time},
    ObjectRow{identity, "Identity Object", ObjectCode::record, identity_entries},
    ObjectRow{facts::object::sdo_server, "Server SDO Parameter", ObjectCode::record, sdo_entries},
};

constexpr std::array<std::string_view, 2> notes{
    "2003h and 2004h are written by receive PDOs only: the SDO server refuses to write them",
    "Entries of 2001h, 2002h and 2004h carry the names of the governor parameters behind them",
};

// The values of D32; every other default stands in the rows.
struct Setting {
    std::uint16_t index;
    std::uint8_t sub_index;
    std::uint32_t value;
};

std::array<Setting, 4> configured_values(const config::Configuration& configuration) {
    const config::CyclicTime& monitored = configuration.heartbeat_consumer;
    const std::uint32_t partner = std::uint32_t{configuration.partner_node_id} << 16U;
    const parameter::Identity& who = configuration.identity;
    return {{
        {consumer_heartbeat, 1, monitored.cycles != 0 ? partner | monitored.effective_ms() : 0},
        {producer_heartbeat, 0, configuration.heartbeat_producer.effective_ms()},
        {identity, 3, who.software_version},
        {identity, 4, who.serial_date << 16U | who.serial_number},
    }};
}

void append(std::vector<Object>& objects, std::vector<Object> more) {
    objects.insert(objects.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

std::vector<Object> all_objects(const config::Configuration& configuration) {
    std::vector<Object> objects;
    objects.reserve(communication_objects.size());
    for (const ObjectRow& row : communication_objects) {
        objects.push_back(object_of(row));
    }
    for (const Setting& setting : configured_values(configuration)) {
        for (Object& object : objects) {
            if (object.index == setting.index) {
                object.variables[setting.sub_index].default_value.number = setting.value;
            }
        }
    }
    append(objects, pdo_objects(configuration, config::Direction::receive));
    append(objects, pdo_objects(configuration, config::Direction::transmit));
    append(objects, process_data_objects(configuration));
    return objects;
}

// Title and configuration id; a long title gives way, the id stays whole.
std::string description_of(const GatewayDocument& document) {
    const std::string id =
        document.configuration_id.empty() ? "" : fmt::format(", configuration {}", document.configuration_id);
    const std::string title =
        document.title.empty() ? untitled_description() : dictionary::to_ascii(document.title);
    return dictionary::shortened(title, description_length - id.size()) + id;
}

dictionary::FileInformation file_information(const GatewayDocument& document) {
    const parameter::Date& created = document.created;
    dictionary::FileInformation file;
    file.file_name = document.file_name;
    file.file_revision = document.revision;
    file.description = description_of(document);
    file.creation_date = fmt::format("{:02}-{:02}-{:04}", created.month, created.day, created.year);
    file.creation_time = creation_time;
    file.created_by = document.author.empty() ? fmt::format("cgw {}", document.tool_version)
                                              : dictionary::to_ascii(document.author);
    file.modification_date = file.creation_date;
    file.modification_time = file.creation_time;
    file.modified_by = file.created_by;
    return file;
}

dictionary::DeviceInformation device_information(const config::Configuration& configuration) {
    dictionary::DeviceInformation device;
    device.vendor_name = vendor_name;
    device.vendor_number = facts::vendor_number;
    device.product_name = product_name;
    device.product_number = facts::product_number;
    device.revision_number = configuration.identity.software_version;
    device.order_code = product_name;
    device.bit_rates_kbit.assign(facts::bit_rates_kbit.begin(), facts::bit_rates_kbit.end());
    device.simple_boot_up_slave = true;
    for (const config::Pdo& pdo : configuration.pdos) {
        (pdo.direction == config::Direction::receive ? device.receive_pdos : device.transmit_pdos) += 1;
    }
    return device;
}

}  // namespace

Object object_of(const ObjectRow& row) {
    Object object;
    object.index = row.index;
    object.name = row.name;
    object.code = row.code;
    for (const VariableRow& from : row.variables) {
        Variable& variable = object.variables.emplace_back();
        variable.sub_index = from.sub_index;
        variable.name = from.name;
        variable.type = from.type;
        variable.default_value = {from.value, from.node_id_relative};
        variable.run_time = from.run_time;
    }
    return object;
}

Variable entry_count(std::string_view name, std::size_t count, Limits limits) {
    Variable variable;
    variable.name = name;
    variable.default_value.number = static_cast<std::uint32_t>(count);
    variable.low_limit = dictionary::Value{limits.low, false};
    variable.high_limit = dictionary::Value{limits.high, false};
    return variable;
}

std::string untitled_description() {
    return fmt::format("EDS for Heinzmann {}", product_name);
}

Dictionary gateway_dictionary(const config::Configuration& configuration, const GatewayDocument& document) {
    Dictionary dictionary;
    dictionary.file = file_information(document);
    dictionary.device = device_information(configuration);
    dictionary.comments.assign(notes.begin(), notes.end());
    dictionary.supported_dummies = {static_cast<std::uint8_t>(config::dummy_index)};
    dictionary.objects = all_objects(configuration);
    return dictionary;
}

}  // namespace cgw::profile
