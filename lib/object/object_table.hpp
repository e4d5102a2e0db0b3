// The object dictionary as the runtime sees it: sorted 8-byte records, read in place (flash, file or
// memory; any alignment), and one flat block of values in RAM.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "object/vocabulary.hpp"
#include "wire/little_endian.hpp"

namespace cgw::object {

// Entry flags, 4 bits.
inline constexpr std::uint8_t flag_pdo_mappable = 0x01;
inline constexpr std::uint8_t flag_sdo_read_only = 0x02;  // rww in the EDS, yet SDO may not write it (D29)

struct ObjectEntry {
    std::uint16_t index = 0;
    std::uint8_t sub_index = 0;
    DataType type{};  // 0: none
    Access access = Access::ro;
    std::uint8_t flags = 0;
    std::uint16_t offset = 0;  // of the value in the value block, bytes
    std::uint8_t length = 0;   // of the value, bytes: 1, 2 or 4, as the type has it; 0 for an unknown type
    std::uint8_t handler = 0;  // 0: plain memory; others belong to the device

    friend bool operator==(const ObjectEntry&, const ObjectEntry&) = default;
};

// Record layout, little-endian: index u16, sub u8, type u8, rights u8 (access in the low, flags in the high
// half), handler u8, offset u16. Records are sorted by index, then sub-index, each pair once.
inline constexpr std::size_t object_record_size = 8;

std::array<std::uint8_t, object_record_size> encode(const ObjectEntry& entry);

inline ObjectEntry decode_object_record(const std::uint8_t* record) {
    ObjectEntry entry;
    entry.index = wire::load_u16(record);
    entry.sub_index = record[2];
    entry.type = static_cast<DataType>(record[3]);
    entry.access = static_cast<Access>(record[4] & 0x0FU);
    entry.flags = static_cast<std::uint8_t>(record[4] >> 4);
    entry.handler = record[5];
    entry.offset = wire::load_u16(record + 6);
    entry.length = size_of(entry.type);
    return entry;
}

enum class Found : std::uint8_t { yes, no_object, no_sub_index };

class ObjectTable {
  public:
    ObjectTable() = default;
    // `records` holds whole, sorted records; bytes beyond the last whole one are ignored. `record_size` is
    // larger than object_record_size when a later image format lengthened the records at their end.
    explicit ObjectTable(std::span<const std::uint8_t> records, std::size_t record_size = object_record_size);

    std::size_t size() const { return count_; }
    // position < size()
    ObjectEntry entry(std::size_t position) const { return decode_object_record(record(position)); }

    struct Lookup {
        Found found = Found::no_object;
        ObjectEntry entry;  // meaningful only when found
    };
    Lookup find(std::uint16_t index, std::uint8_t sub_index) const {
        const Place place = locate(index, sub_index, 0);
        return {place.found, place.found == Found::yes ? entry(place.position) : ObjectEntry{}};
    }

    struct Place {
        Found found = Found::no_object;
        std::size_t position = 0;  // meaningful only when found
    };
    // Sooner when it is the record at `guess` or the one behind; `guess` may be any number.
    Place locate(std::uint16_t index, std::uint8_t sub_index, std::size_t guess) const {
        const std::uint32_t wanted = key_of(index, sub_index);
        if (is_at(guess, wanted)) {
            return {Found::yes, guess};
        }
        if (is_at(guess + 1, wanted)) {
            return {Found::yes, guess + 1};
        }
        return search(wanted);
    }

  private:
    // Index in the upper, sub-index in the lower half: ordered as the records are.
    static constexpr std::uint32_t key_of(std::uint16_t index, std::uint8_t sub_index) {
        return (static_cast<std::uint32_t>(index) << 16) | sub_index;
    }
    // The same of a record, whose first four bytes are index, sub-index and type.
    static constexpr std::uint32_t key_of(const std::uint8_t* record) {
        return std::rotl(wire::load_u32(record) << 8, 8);
    }
    const std::uint8_t* record(std::size_t position) const { return records_ + position * record_size_; }
    bool is_at(std::size_t position, std::uint32_t wanted) const {
        return position < count_ && key_of(record(position)) == wanted;
    }
    Place search(std::uint32_t wanted) const;
    bool has_index(std::size_t position, std::uint32_t index) const;

    const std::uint8_t* records_ = nullptr;
    std::size_t record_size_ = object_record_size;
    std::size_t count_ = 0;
};

// The bits a value of `length` (1, 2 or 4) bytes has.
constexpr std::uint32_t value_mask(std::uint8_t length) {
    return 0xFFFFFFFFU >> (8U * (4U - length));
}

// The value block's access, little-endian; `values` must hold entry.offset + entry.length bytes.
inline std::uint32_t load_value(std::span<const std::uint8_t> values, const ObjectEntry& entry) {
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

inline void store_value(std::span<std::uint8_t> values, const ObjectEntry& entry, std::uint32_t value) {
    std::uint8_t* const at = values.data() + entry.offset;
    switch (entry.length) {
        case 1:
            *at = static_cast<std::uint8_t>(value);
            break;
        case 2:
            wire::store_u16(at, static_cast<std::uint16_t>(value));
            break;
        default:
            wire::store_u32(at, value);
            break;
    }
}

}  // namespace cgw::object
