#include "object/object_table.hpp"

namespace cgw::object {

std::array<std::uint8_t, object_record_size> encode(const ObjectEntry& entry) {
    std::array<std::uint8_t, object_record_size> record{};
    wire::store_u16(&record[0], entry.index);
    record[2] = entry.sub_index;
    record[3] = static_cast<std::uint8_t>(entry.type);
    record[4] = static_cast<std::uint8_t>(static_cast<unsigned>(entry.access) | entry.flags << 4U);
    record[5] = entry.handler;
    wire::store_u16(&record[6], entry.offset);
    return record;
}

ObjectTable::ObjectTable(std::span<const std::uint8_t> records, std::size_t record_size)
    : records_(records.data()), record_size_(record_size), count_(records.size() / record_size) {}

// Finds the last record that is not behind the wanted one: halves the rest without a branch on what it reads.
ObjectTable::Place ObjectTable::search(std::uint32_t wanted) const {
    std::size_t position = 0;
    for (std::size_t rest = count_; rest > 1;) {
        const std::size_t half = rest / 2;
        position = key_of(record(position + half)) <= wanted ? position + half : position;
        rest -= half;
    }
    if (is_at(position, wanted)) {
        return {Found::yes, position};
    }
    const bool neighbour = has_index(position, wanted >> 16) || has_index(position + 1, wanted >> 16);
    return {neighbour ? Found::no_sub_index : Found::no_object, 0};
}

bool ObjectTable::has_index(std::size_t position, std::uint32_t index) const {
    return position < count_ && wire::load_u16(record(position)) == index;
}

}  // namespace cgw::object
