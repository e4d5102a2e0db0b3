// The object dictionary as the runtime sees it: sorted 12-byte records, read in place (flash, file or
// memory; any alignment), and one flat block of values in RAM.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "object/vocabulary.hpp"

namespace cgw::object {

// Entry flags.
inline constexpr std::uint8_t flag_pdo_mappable = 0x01;
inline constexpr std::uint8_t flag_sdo_read_only = 0x02;  // rww in the EDS, yet SDO may not write it (D29)

struct ObjectEntry {
    std::uint16_t index = 0;
    std::uint8_t sub_index = 0;
    DataType type = DataType::unsigned8;
    Access access = Access::ro;
    std::uint8_t flags = 0;
    std::uint16_t offset = 0;  // of the value in the value block, bytes
    std::uint8_t length = 0;   // of the value, bytes: 1, 2 or 4
    std::uint8_t handler = 0;  // 0: plain memory; others belong to the device

    friend bool operator==(const ObjectEntry&, const ObjectEntry&) = default;
};

// Record layout, little-endian: index u16, sub u8, type u8, access u8, flags u8, offset u16, length u8,
// handler u8, reserved u16 (0). Records are sorted by index, then sub-index, each pair once.
inline constexpr std::size_t object_record_size = 12;

std::array<std::uint8_t, object_record_size> encode(const ObjectEntry& entry);
ObjectEntry decode_object_record(const std::uint8_t* record);

enum class Found : std::uint8_t { yes, no_object, no_sub_index };

class ObjectTable {
  public:
    ObjectTable() = default;
    // `records` holds whole, sorted records; bytes beyond the last whole one are ignored. `record_size` is
    // larger than object_record_size when a later image format lengthened the records at their end.
    explicit ObjectTable(std::span<const std::uint8_t> records, std::size_t record_size = object_record_size);

    std::size_t size() const { return count_; }
    ObjectEntry entry(std::size_t position) const;  // position < size()

    struct Lookup {
        Found found = Found::no_object;
        ObjectEntry entry;         // meaningful only when found
        std::size_t position = 0;  // likewise
    };
    Lookup find(std::uint16_t index, std::uint8_t sub_index) const;
    // The same, sooner when it is the record at `guess` or the one behind. `guess` may be any number.
    Lookup find(std::uint16_t index, std::uint8_t sub_index, std::size_t guess) const;

  private:
    const std::uint8_t* search(std::uint32_t wanted) const;
    std::size_t position_of(const std::uint8_t* record) const {
        return static_cast<std::size_t>(record - records_) / record_size_;
    }

    const std::uint8_t* records_ = nullptr;
    std::size_t record_size_ = object_record_size;
    std::size_t count_ = 0;
};

// The value block's access, little-endian; `values` must hold entry.offset + entry.length bytes.
std::uint32_t load_value(std::span<const std::uint8_t> values, const ObjectEntry& entry);
void store_value(std::span<std::uint8_t> values, const ObjectEntry& entry, std::uint32_t value);

}  // namespace cgw::object
