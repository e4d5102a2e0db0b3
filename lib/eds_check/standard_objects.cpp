#include "eds_check/standard_objects.hpp"

#include <algorithm>
#include <array>

namespace cgw::eds_check {
namespace {

using object::DataType;
using object::ObjectCode;

struct CodeRow {
    IndexRange range;
    ObjectCode code;
};
constexpr std::array code_rows{
    CodeRow{{0x1018, 0x1018}, ObjectCode::record}, CodeRow{sdo_servers, ObjectCode::record},
    CodeRow{sdo_clients, ObjectCode::record},      CodeRow{receive_communication, ObjectCode::record},
    CodeRow{receive_mapping, ObjectCode::record},  CodeRow{transmit_communication, ObjectCode::record},
    CodeRow{transmit_mapping, ObjectCode::record},
};

constexpr std::uint8_t highest_sub_index = 0xFE;

struct TypeRow {
    IndexRange range;
    bool has_sub_objects;
    std::uint8_t first_sub;
    std::uint8_t last_sub;
    DataType type;
};
constexpr std::array type_rows{
    TypeRow{{0x1000, 0x1000}, false, 0, 0, DataType::unsigned32},
    TypeRow{{0x1001, 0x1001}, false, 0, 0, DataType::unsigned8},
    TypeRow{{0x1002, 0x1002}, false, 0, 0, DataType::unsigned32},
    TypeRow{{0x1003, 0x1003}, true, 1, highest_sub_index, DataType::unsigned32},
    TypeRow{{0x1005, 0x1007}, false, 0, 0, DataType::unsigned32},
    TypeRow{{0x100C, 0x100C}, false, 0, 0, DataType::unsigned16},
    TypeRow{{0x100D, 0x100D}, false, 0, 0, DataType::unsigned8},
    TypeRow{{0x1010, 0x1011}, true, 1, highest_sub_index, DataType::unsigned32},
    TypeRow{{0x1012, 0x1014}, false, 0, 0, DataType::unsigned32},
    TypeRow{{0x1015, 0x1015}, false, 0, 0, DataType::unsigned16},
    TypeRow{{0x1016, 0x1016}, true, 1, highest_sub_index, DataType::unsigned32},
    TypeRow{{0x1017, 0x1017}, false, 0, 0, DataType::unsigned16},
    TypeRow{{0x1018, 0x1018}, true, 1, 4, DataType::unsigned32},
    TypeRow{{0x1019, 0x1019}, false, 0, 0, DataType::unsigned8},
    TypeRow{{sdo_servers.first, sdo_clients.last}, true, 1, 2, DataType::unsigned32},
    TypeRow{{sdo_servers.first, sdo_clients.last}, true, 3, 3, DataType::unsigned8},
    TypeRow{receive_communication, true, 1, 1, DataType::unsigned32},
    TypeRow{receive_communication, true, 2, 2, DataType::unsigned8},
    TypeRow{receive_communication, true, 3, 3, DataType::unsigned16},
    TypeRow{receive_communication, true, 5, 5, DataType::unsigned16},
    TypeRow{receive_mapping, true, 1, highest_sub_index, DataType::unsigned32},
    TypeRow{transmit_communication, true, 1, 1, DataType::unsigned32},
    TypeRow{transmit_communication, true, 2, 2, DataType::unsigned8},
    TypeRow{transmit_communication, true, 3, 3, DataType::unsigned16},
    TypeRow{transmit_communication, true, 5, 5, DataType::unsigned16},
    TypeRow{transmit_communication, true, 6, 6, DataType::unsigned8},
    TypeRow{transmit_mapping, true, 1, highest_sub_index, DataType::unsigned32},
};

}  // namespace

std::optional<ObjectCode> standard_code(std::uint16_t index) {
    const auto* const row = std::find_if(code_rows.begin(), code_rows.end(),
                                         [index](const CodeRow& each) { return each.range.contains(index); });
    return row != code_rows.end() ? std::optional(row->code) : std::nullopt;
}

std::optional<DataType> standard_type(std::uint16_t index, std::uint8_t sub_index) {
    const auto* const row = std::find_if(type_rows.begin(), type_rows.end(), [&](const TypeRow& each) {
        return each.range.contains(index) && sub_index >= each.first_sub && sub_index <= each.last_sub;
    });
    return row != type_rows.end() ? std::optional(row->type) : std::nullopt;
}

bool is_parent_by_standard(std::uint16_t index) {
    return std::any_of(type_rows.begin(), type_rows.end(), [index](const TypeRow& row) {
        return row.range.contains(index) && row.has_sub_objects;
    });
}

}  // namespace cgw::eds_check
