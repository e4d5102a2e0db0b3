// The object dictionary model of any CANopen device, with what an EDS says about the device.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "object/vocabulary.hpp"

namespace cgw::dictionary {

// A number as an EDS writes it: `$NODEID+0x180` is {0x180, true}.
struct Value {
    std::uint32_t number = 0;
    bool node_id_relative = false;

    std::uint32_t resolve(std::uint8_t node_id) const { return number + (node_id_relative ? node_id : 0U); }
    friend bool operator==(const Value&, const Value&) = default;
};

// One VAR: either a whole object or one sub-object.
struct Variable {
    std::uint8_t sub_index = 0;
    std::string name;
    object::DataType type = object::DataType::unsigned8;
    object::Access access = object::Access::ro;
    bool pdo_mapping = false;
    Value default_value;
    std::optional<std::uint32_t> low_limit;
    std::optional<std::uint32_t> high_limit;
    bool run_time = false;  // the device changes it while it runs, so that no file can say what it is
};

struct Object {
    std::uint16_t index = 0;
    std::string name;
    object::ObjectCode code = object::ObjectCode::var;
    std::vector<Variable> variables;  // var: exactly one, sub-index 0; else ascending sub-indices from 0

    const Variable* find(std::uint8_t sub_index) const;
};

// [FileInfo]; dates and times as the EDS prints them (mm-dd-yyyy, hh:mmAM).
struct FileInformation {
    std::string file_name;
    unsigned file_version = 1;   // 0..255
    unsigned file_revision = 0;  // 0..255
    std::string description;
    std::string creation_date;
    std::string creation_time;
    std::string created_by;
    std::string modification_date;
    std::string modification_time;
    std::string modified_by;
};

// [DeviceInfo]
struct DeviceInformation {
    std::string vendor_name;
    std::uint32_t vendor_number = 0;
    std::string product_name;
    std::uint32_t product_number = 0;
    std::uint32_t revision_number = 0;
    std::string order_code;
    std::vector<unsigned> bit_rates_kbit;  // supported ones
    bool simple_boot_up_master = false;
    bool simple_boot_up_slave = false;
    unsigned granularity = 0;
    unsigned receive_pdos = 0;
    unsigned transmit_pdos = 0;
    bool lss_supported = false;
};

struct Dictionary {
    FileInformation file;
    DeviceInformation device;
    std::vector<std::string> comments;            // [Comments]
    std::vector<std::uint8_t> supported_dummies;  // data type numbers with DummyUsage 1
    std::vector<Object> objects;                  // ascending index

    // nullptr when the dictionary has no such object or sub-index.

    const Object* find(std::uint16_t index) const;
    const Variable* find(std::uint16_t index, std::uint8_t sub_index) const;
};

}  // namespace cgw::dictionary
