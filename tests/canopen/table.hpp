// A small object table with its value block, for tests of the core.
#pragma once

#include <array>
#include <vector>

#include "object/object_table.hpp"

namespace cgw::test {

class Table {
  public:
    using Access = object::Access;
    using DataType = object::DataType;

    // Objects are added in ascending order.
    Table& add(std::uint16_t index, std::uint8_t sub_index, DataType type, Access access, std::uint32_t value,
               std::uint8_t flags = 0, std::uint8_t handler = 0) {
        object::ObjectEntry entry;
        entry.index = index;
        entry.sub_index = sub_index;
        entry.type = type;
        entry.access = access;
        entry.flags = flags;
        entry.handler = handler;
        entry.offset = static_cast<std::uint16_t>(values.size());
        entry.length = object::size_of(type);
        values.resize(values.size() + entry.length);
        object::store_value(values, entry, value);
        const auto record = object::encode(entry);
        records.insert(records.end(), record.begin(), record.end());
        return *this;
    }

    object::ObjectTable objects() const { return object::ObjectTable(records); }

    std::uint32_t value(std::uint16_t index, std::uint8_t sub_index) const {
        return object::load_value(values, objects().find(index, sub_index).entry);
    }

    std::vector<std::uint8_t> records;
    std::vector<std::uint8_t> values;
};

inline Table sample_table() {
    using object::Access;
    using object::DataType;
    Table table;
    table.add(0x1000, 0, DataType::unsigned32, Access::ro, 0x00000191)
        .add(0x1001, 0, DataType::unsigned8, Access::ro, 0x11)
        .add(0x1017, 0, DataType::unsigned16, Access::constant, 1000)
        .add(0x1018, 0, DataType::unsigned8, Access::ro, 4)
        .add(0x1018, 1, DataType::unsigned32, Access::ro, 0x161)
        .add(0x1018, 3, DataType::unsigned32, Access::ro, 7)
        .add(0x2000, 1, DataType::unsigned16, Access::ro, 0xBEEF)
        .add(0x2003, 1, DataType::unsigned16, Access::rww, 0, object::flag_sdo_read_only)
        .add(0x2010, 0, DataType::unsigned16, Access::rw, 5)
        .add(0x2011, 0, DataType::unsigned8, Access::wo, 5);
    return table;
}

}  // namespace cgw::test
