// Intel HEX files: record types 00 to 05. Addresses have 32 bits.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "firmware_file/finding.hpp"
#include "firmware_file/memory.hpp"
#include "firmware_file/record_text.hpp"

namespace cgw::firmware_file {

struct StartRecord {
    std::uint32_t start = 0;
    std::uint16_t address = 0;  // mostly 0; it means nothing, and is kept
};

struct IntelHex {
    Memory memory;
    std::optional<StartRecord> start_segment;  // record 03: CS:IP
    std::optional<StartRecord> start_linear;   // record 05
    std::uint16_t end_address = 0;  // of the end record: where an 8-bit program starts, in files of old tools
    bool segmented = false;         // addresses beyond 64 KiB stand in records 02, not 04
    RecordStyle style{};
};

// Refuses what is not whole: a wrong checksum, length or digit, an unknown record, a record that runs over
// the end of its 64 KiB, an address with two values, a missing end, anything behind the end.
// A line of Ctrl-Z there, which ends texts of old DOS tools, is taken and not kept.
Outcome<IntelHex> read_intel_hex(std::span<const std::uint8_t> text);

// Records in ascending order of addresses, then the start records, then the end.
std::string write_intel_hex(const IntelHex& file);

// Start and end records of a whole text as they stand there, in upper case and sorted: what writing it again
// must keep beside the data.
std::vector<std::string> other_intel_hex_records(std::span<const std::uint8_t> text);

}  // namespace cgw::firmware_file
