// Intel HEX files: record types 00 to 05. Addresses have 32 bits.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "firmware_file/finding.hpp"
#include "firmware_file/memory.hpp"
#include "firmware_file/record_text.hpp"

namespace cgw::firmware_file {

struct IntelHex {
    Memory memory;
    std::optional<std::uint32_t> start_segment;  // record 03: CS:IP
    std::optional<std::uint32_t> start_linear;   // record 05
    bool segmented = false;                      // addresses beyond 64 KiB stand in records 02, not 04
    RecordStyle style{};
};

// Refuses what is not whole: a wrong checksum, length or digit, an unknown record, a record that runs over
// the end of its 64 KiB, an address with two values, a missing end, anything behind the end.
Outcome<IntelHex> read_intel_hex(std::span<const std::uint8_t> text);

// Records in ascending order of addresses, then the start records, then the end.
std::string write_intel_hex(const IntelHex& file);

}  // namespace cgw::firmware_file
