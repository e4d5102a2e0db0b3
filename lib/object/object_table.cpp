#include "object/object_table.hpp"

#include <bit>

#include "wire/little_endian.hpp"

namespace cgw::object {
namespace {

// Index in the upper, sub-index in the lower half: ordered as the records are.
constexpr std::uint32_t key_of(std::uint16_t index, std::uint8_t sub_index) {
    return (static_cast<std::uint32_t>(index) << 16) | sub_index;
}

// The same of a record, whose first four bytes are index, sub-index and type.
std::uint32_t key_of(const std::uint8_t* record) {
    return std::rotl(wire::load_u32(record) << 8, 8);
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

// The last record that is not behind the wanted one; halves the rest without a branch on what it reads.
const std::uint8_t* ObjectTable::search(std::uint32_t wanted) const {
    const std::uint8_t* base = records_;
    for (std::size_t rest = count_; rest > 1;) {
        const std::size_t half = rest / 2;
        const std::uint8_t* const middle = base + half * record_size_;
        base = key_of(middle) <= wanted ? middle : base;
        rest -= half;
    }
    return base;
}

ObjectTable::Lookup ObjectTable::find(std::uint16_t index, std::uint8_t sub_index) const {
    if (count_ == 0) {
        return {};
    }
    const std::uint32_t wanted = key_of(index, sub_index);
    const std::uint8_t* const record = search(wanted);
    if (key_of(record) == wanted) {
        return {Found::yes, decode_object_record(record), position_of(record)};
    }
    const std::uint8_t* const next = record + record_size_;
    const bool before = wire::load_u16(record) == index;
    const bool after = next != records_ + count_ * record_size_ && wire::load_u16(next) == index;
    return {before || after ? Found::no_sub_index : Found::no_object, {}, 0};
}

ObjectTable::Lookup ObjectTable::find(std::uint16_t index, std::uint8_t sub_index, std::size_t guess) const {
    const std::uint32_t wanted = key_of(index, sub_index);
    for (std::size_t position = guess; position < count_ && position <= guess + 1; ++position) {
        const std::uint8_t* const record = records_ + position * record_size_;
        if (key_of(record) == wanted) {
            return {Found::yes, decode_object_record(record), position};
        }
    }
    return find(index, sub_index);
}

std::uint32_t load_value(std::span<const std::uint8_t> values, const ObjectEntry& entry) {
    const std::uint8_t* const at = values.data() + entry.offset;
    switch (entry.length) {
        case 1:
            return *at;
        case 2:
            return wire::load_u16(at);
        default:
            return wire::load_u32(at);
    }
}

void store_value(std::span<std::uint8_t> values, const ObjectEntry& entry, std::uint32_t value) {
    for (std::size_t i = 0; i < entry.length; ++i) {
        values[entry.offset + i] = static_cast<std::uint8_t>(value >> (8 * i));
    }
}

}  // namespace cgw::object
