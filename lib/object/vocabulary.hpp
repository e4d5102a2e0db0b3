// The vocabulary of CiA 301: data types, object codes, access, SDO abort codes.
#pragma once

#include <cstddef>
#include <cstdint>

namespace cgw::object {

// CiA 301 table 44; the numbers are the ones an EDS prints as DataType. Those behind unsigned32 are for
// dictionaries of other devices: the core carries none of them.
enum class DataType : std::uint8_t {
    boolean = 0x01,
    integer8 = 0x02,
    integer16 = 0x03,
    integer32 = 0x04,
    unsigned8 = 0x05,
    unsigned16 = 0x06,
    unsigned32 = 0x07,
    real32 = 0x08,
    visible_string = 0x09,
    octet_string = 0x0A,
    unicode_string = 0x0B,
    time_of_day = 0x0C,
    time_difference = 0x0D,
    domain = 0x0F,
    integer24 = 0x10,
    real64 = 0x11,
    integer40 = 0x12,
    integer48 = 0x13,
    integer56 = 0x14,
    integer64 = 0x15,
    unsigned24 = 0x16,
    unsigned40 = 0x18,
    unsigned48 = 0x19,
    unsigned56 = 0x1A,
    unsigned64 = 0x1B,
    pdo_communication = 0x20,
    pdo_mapping = 0x21,
    sdo_parameter = 0x22,
    identity = 0x23,
};

inline constexpr std::uint8_t type_sizes[8] = {0, 1, 1, 2, 4, 1, 2, 4};  // bytes on the wire, by number

// Bytes on the wire; 0 for a type this core does not carry.
constexpr std::uint8_t size_of(DataType type) {
    const auto number = static_cast<std::size_t>(type);
    return number < sizeof type_sizes ? type_sizes[number] : std::uint8_t{0};
}

constexpr bool is_signed(DataType type) {
    return type == DataType::integer8 || type == DataType::integer16 || type == DataType::integer32;
}

enum class ObjectCode : std::uint8_t {
    null = 0x0,
    domain = 0x2,
    type_definition = 0x5,       // DEFTYPE
    structure_definition = 0x6,  // DEFSTRUCT
    var = 0x7,
    array = 0x8,
    record = 0x9,
};

// Has sub-objects; the others are one variable each, at sub-index 0.
constexpr bool has_sub_objects(ObjectCode code) {
    return code == ObjectCode::array || code == ObjectCode::record ||
           code == ObjectCode::structure_definition;
}

// rwr / rww: readable and writable, mappable into a TPDO (r) or an RPDO (w) only.
enum class Access : std::uint8_t { ro = 0, wo = 1, rw = 2, rwr = 3, rww = 4, constant = 5 };

// SDO abort codes of CiA 301 that a server here sends or a client may meet; all of them, with texts, are in
// explain/abort_codes.cpp.
enum class AbortCode : std::uint32_t {
    none = 0,
    timed_out = 0x05040000,
    command_unknown = 0x05040001,
    unsupported_access = 0x06010000,
    write_only = 0x06010001,
    read_only = 0x06010002,
    object_missing = 0x06020000,
    not_mappable = 0x06040041,
    mapping_too_long = 0x06040042,
    incompatible = 0x06040043,  // with other parameters
    hardware = 0x06060000,
    length_too_high = 0x06070012,
    length_too_low = 0x06070013,
    sub_index_missing = 0x06090011,
    value_invalid = 0x06090030,
    value_too_high = 0x06090031,
    value_too_low = 0x06090032,
    general = 0x08000000,
    not_stored = 0x08000020,          // cannot be transferred to or stored in the application
    local_control = 0x08000021,       // the same, because of local control
    wrong_device_state = 0x08000022,  // the same, in the present state of the device
    no_data = 0x08000024,
};

}  // namespace cgw::object
