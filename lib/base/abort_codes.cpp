#include "base/abort_codes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "object/vocabulary.hpp"

namespace cgw::base {

namespace {

using object::AbortCode;

constexpr std::uint32_t number(AbortCode code) {
    return static_cast<std::uint32_t>(code);
}

constexpr std::array table{
    AbortCodeRow{0x05030000, "the toggle bit has not alternated", "", ""},
    AbortCodeRow{number(AbortCode::timed_out), "the other side did not answer in time", "", "",
                 "no answer in time"},
    AbortCodeRow{number(AbortCode::command_unknown), "the command specifier is not valid or not known",
                 "any request but expedited upload and download: it has no segmented and no block transfer",
                 "let the master use expedited transfer; no object of the gateway is longer than 4 bytes",
                 "command not valid or unknown"},
    AbortCodeRow{0x05040002, "the block size is not valid", "", ""},
    AbortCodeRow{0x05040003, "the sequence number is not valid", "", ""},
    AbortCodeRow{0x05040004, "the check sum of the block is wrong", "", ""},
    AbortCodeRow{0x05040005, "out of memory", "", ""},
    AbortCodeRow{number(AbortCode::unsupported_access), "this access to the object is not supported", "", "",
                 "unsupported access"},
    AbortCodeRow{number(AbortCode::write_only), "a write-only object was read", "", "", "write-only object"},
    AbortCodeRow{
        number(AbortCode::read_only), "a read-only object was written",
        "every write to an object that exists, with the right length: no object of the gateway can be "
        "written by SDO, 2003h and 2004h included",
        "set the parameter behind the object with DcDesk 2000, then save and reset both devices; write "
        "2003h and 2004h by RPDO",
        "read-only object"},
    AbortCodeRow{number(AbortCode::object_missing), "there is no object of this index",
                 "the index is none of its object dictionary",
                 "compare the EDS with the device: was it written from the configuration that runs?",
                 "object does not exist"},
    AbortCodeRow{number(AbortCode::not_mappable), "the object cannot be mapped into a PDO", "", ""},
    AbortCodeRow{number(AbortCode::mapping_too_long),
                 "number and length of the mapped objects exceed the PDO", "", ""},
    AbortCodeRow{number(AbortCode::incompatible), "parameters do not fit together", "", ""},
    AbortCodeRow{0x06040047, "incompatibility inside the device", "", ""},
    AbortCodeRow{number(AbortCode::hardware), "access failed for a hardware error", "", ""},
    AbortCodeRow{0x06070010, "the length does not fit the object", "", ""},
    AbortCodeRow{
        number(AbortCode::length_too_high), "the data are longer than the object",
        "a write that states more bytes than the object has; it would be refused anyway (0x06010002)",
        "do not write: the gateway is configured with DcDesk 2000", "length too high"},
    AbortCodeRow{
        number(AbortCode::length_too_low), "the data are shorter than the object",
        "a write that states fewer bytes than the object has; it would be refused anyway (0x06010002)",
        "do not write: the gateway is configured with DcDesk 2000", "length too low"},
    AbortCodeRow{
        number(AbortCode::sub_index_missing), "the object has no entry of this sub-index",
        "the entry does not exist in this configuration, such as 2000h:7 without TPDO3 or an entry of "
        "2001h..2004h beyond sub-index 0's count",
        "read sub-index 0 first; compare the EDS with the device", "sub-index does not exist"},
    AbortCodeRow{number(AbortCode::value_invalid), "the value is not valid", "", ""},
    AbortCodeRow{number(AbortCode::value_too_high), "the value is too great", "", ""},
    AbortCodeRow{number(AbortCode::value_too_low), "the value is too small", "", ""},
    AbortCodeRow{0x06090036, "the greatest value is less than the least one", "", ""},
    AbortCodeRow{0x060A0023, "the resource, an SDO connection, is not available", "", ""},
    AbortCodeRow{number(AbortCode::general), "general error", "", ""},
    AbortCodeRow{number(AbortCode::not_stored),
                 "the data cannot be transferred to or stored in the application", "", ""},
    AbortCodeRow{number(AbortCode::local_control),
                 "the data cannot be transferred or stored because of local control", "", ""},
    AbortCodeRow{number(AbortCode::wrong_device_state),
                 "the data cannot be transferred or stored in the present state of the device", "", ""},
    AbortCodeRow{0x08000023, "there is no object dictionary, or it could not be made", "", ""},
    AbortCodeRow{number(AbortCode::no_data), "there are no data", "", ""},
};

static_assert(std::is_sorted(table.begin(), table.end(),
                             [](const AbortCodeRow& a, const AbortCodeRow& b) { return a.code < b.code; }));

}  // namespace

std::span<const AbortCodeRow> abort_codes() {
    return table;
}

const AbortCodeRow* find_abort_code(std::uint32_t code) {
    const auto* const found = std::find_if(table.begin(), table.end(),
                                           [code](const AbortCodeRow& row) { return row.code == code; });
    return found != table.end() ? found : nullptr;
}

std::string abort_text(std::uint32_t code) {
    const AbortCodeRow* row = find_abort_code(code);
    if (row == nullptr) {
        return fmt::format("abort 0x{:08X}", code);
    }
    return fmt::format("abort 0x{:08X}, {}", code, row->brief.empty() ? row->meaning : row->brief);
}

}  // namespace cgw::base
