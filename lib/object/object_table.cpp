#include "object/object_table.hpp"

#include "wire/little_endian.hpp"

namespace cgw::object {
namespace {

constexpr std::uint32_t key_of(std::uint16_t index, std::uint8_t sub_index) {
    return (static_cast<std::uint32_t>(index) << 8) | sub_index;
}

}  // namespace

std::array<std::uint8_t, object_record_size> encode(const ObjectEntry& entry) {
    std::array<std::uint8_t, object_record_size> record{};
    wire::store_u16(&record[0], entry.index);
    record[2] = entry.sub_index;
    record[3] = static_cast<std::uint8_t>(entry.type);
    record[4] = static_cast<std::uint8_t>(entry.access);
    record[5] = entry.flags;
    wire::store_u16(&record[6], entry.offset);
    record[8] = entry.length;
    record[9] = entry.handler;
    return record;
}

ObjectEntry decode_object_record(const std::uint8_t* record) {
    ObjectEntry entry;
    entry.index = wire::load_u16(record);
    entry.sub_index = record[2];
    entry.type = static_cast<DataType>(record[3]);
    entry.access = static_cast<Access>(record[4]);
    entry.flags = record[5];
    entry.offset = wire::load_u16(record + 6);
    entry.length = record[8];
    entry.handler = record[9];
    return entry;
}

ObjectTable::ObjectTable(std::span<const std::uint8_t> records, std::size_t record_size)
    : records_(records.data()), record_size_(record_size), count_(records.size() / record_size) {}

ObjectEntry ObjectTable::entry(std::size_t position) const {
    return decode_object_record(records_ + position * record_size_);
}

std::uint32_t ObjectTable::key_at(std::size_t position) const {
    const std::uint8_t* record = records_ + position * record_size_;
    return key_of(wire::load_u16(record), record[2]);
}

ObjectTable::Lookup ObjectTable::find(std::uint16_t index, std::uint8_t sub_index) const {
    const std::uint32_t wanted = key_of(index, sub_index);
    std::size_t low = 0;
    std::size_t high = count_;
    while (low < high) {
        const std::size_t middle = low + (high - low) / 2;
        if (key_at(middle) < wanted) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    if (low < count_ && key_at(low) == wanted) {
        return {Found::yes, entry(low)};
    }
    const bool after = low < count_ && (key_at(low) >> 8) == index;
    const bool before = low > 0 && (key_at(low - 1) >> 8) == index;
    return {after || before ? Found::no_sub_index : Found::no_object, {}};
}

std::uint32_t load_value(std::span<const std::uint8_t> values, const ObjectEntry& entry) {
    std::uint32_t value = 0;
    for (std::size_t i = entry.length; i-- > 0;) {
        value = (value << 8) | values[entry.offset + i];
    }
    return value;
}

void store_value(std::span<std::uint8_t> values, const ObjectEntry& entry, std::uint32_t value) {
    for (std::size_t i = 0; i < entry.length; ++i) {
        values[entry.offset + i] = static_cast<std::uint8_t>(value >> (8 * i));
    }
}

}  // namespace cgw::object
