// The object dictionary model of any CANopen device, with what an EDS says about the device.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "object/vocabulary.hpp"

namespace cgw::dictionary {

// What an object holds, as an EDS writes it: `$NODEID+0x180` is {0x180, true}.
struct Value {
    // Numbers: negative ones as two's complement in the width of their type, reals as the bits of IEEE 754.
    std::uint64_t number = 0;
    bool node_id_relative = false;
    std::string bytes{};  // strings, octet strings, domains; as the device holds them

    std::uint64_t resolve(std::uint8_t node_id) const { return number + (node_id_relative ? node_id : 0U); }
    friend bool operator==(const Value&, const Value&) = default;
};

// One value: either a whole object or one sub-object.
struct Variable {
    std::uint8_t sub_index = 0;
    std::string name;
    object::DataType type = object::DataType::unsigned8;
    object::Access access = object::Access::ro;
    bool pdo_mapping = false;
    bool run_time = false;    // the device changes it while it runs, so that no file can say what it is
    bool no_default = false;  // no file states a default value
    std::uint32_t flags = 0;  // ObjFlags: bit 0 not written by a download, bit 1 not read by an upload
    Value default_value;
    std::optional<Value> low_limit;
    std::optional<Value> high_limit;
    std::optional<Value> parameter_value;  // of one node, in its configuration file
    std::string denotation;                // likewise
    std::string upload_file;               // likewise: where a domain's content goes, and comes from
    std::string download_file;

    friend bool operator==(const Variable&, const Variable&) = default;
};

struct Object {
    std::uint16_t index = 0;
    std::string name;
    object::ObjectCode code = object::ObjectCode::var;
    std::uint32_t flags = 0;                    // ObjFlags of an object with sub-objects
    std::string denotation;                     // of an object with sub-objects
    std::vector<std::uint16_t> object_links{};  // indices of the objects that belong to it
    std::vector<Variable>
        variables{};  // with sub-objects: ascending sub-indices; else exactly one, sub-index 0

    const Variable* find(std::uint8_t sub_index) const;
    friend bool operator==(const Object&, const Object&) = default;
};

// [FileInfo]; dates and times as the EDS prints them (mm-dd-yyyy, hh:mmAM).
struct FileInformation {
    std::string file_name;
    std::string eds_version = "4.0";
    unsigned file_version = 1;   // 0..255
    unsigned file_revision = 0;  // 0..255
    std::string description;
    std::string creation_date;
    std::string creation_time;
    std::string created_by;
    std::string modification_date;
    std::string modification_time;
    std::string modified_by;

    friend bool operator==(const FileInformation&, const FileInformation&) = default;
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
    unsigned granularity = 0;  // of a mapping, in bits: 1..64; 0: the mapping is fixed
    bool dynamic_channels = false;
    bool group_messaging = false;
    unsigned receive_pdos = 0;
    unsigned transmit_pdos = 0;
    bool lss_supported = false;
    std::uint32_t compact_pdo =
        0;  // bit n - 1: 1400h.. and 1800h.. have sub-index n without a section of their own

    friend bool operator==(const DeviceInformation&, const DeviceInformation&) = default;
};

// What a configuration file says about its one node.
struct Commissioning {
    std::string last_eds;      // file name of the data sheet
    std::uint8_t node_id = 0;  // 1..127
    std::string node_name;
    std::optional<std::uint32_t> bit_rate_kbit;  // not stated when it is not known
    std::uint32_t net_number = 0;
    std::string network_name;
    bool canopen_manager = false;
    std::uint32_t serial_number = 0;  // 1018h:4
    std::vector<std::uint16_t>
        connected_modules;  // numbers of Dictionary::modules, in the order of their places

    friend bool operator==(const Commissioning&, const Commissioning&) = default;
};

// What one module of a modular device adds to an object for each place that it takes.
struct ModuleExtension {
    std::uint16_t index = 0;
    Variable variable;              // of each sub-object that it adds
    std::uint32_t count = 0;        // sub-objects that one module adds; 0: several modules share one
    std::uint32_t shared_bits = 0;  // then: bits of it that one module takes
    bool extends_objects = false;   // ObjExtend: beyond 254 sub-indices the next object goes on

    friend bool operator==(const ModuleExtension&, const ModuleExtension&) = default;
};

// A kind of module that can be plugged to a modular device.
struct Module {
    std::uint8_t number = 0;  // 1..
    std::string product_name;
    std::uint32_t product_version = 0;
    std::uint32_t product_revision = 0;
    std::string order_code;
    std::vector<std::string> comments;
    std::vector<Object> fixed_objects;  // it adds these, once; ascending index
    std::vector<ModuleExtension> extensions;

    friend bool operator==(const Module&, const Module&) = default;
};

struct Dictionary {
    FileInformation file;
    DeviceInformation device;
    std::vector<std::string> comments;            // [Comments]
    std::vector<std::uint8_t> supported_dummies;  // data type numbers with DummyUsage 1
    std::vector<Object> objects;                  // ascending index
    std::vector<Module> modules;                  // of a modular device, ascending number

    // nullptr when the dictionary has no such object or sub-index.

    const Object* find(std::uint16_t index) const;
    const Variable* find(std::uint16_t index, std::uint8_t sub_index) const;
    friend bool operator==(const Dictionary&, const Dictionary&) = default;
};

}  // namespace cgw::dictionary
