// Motorola S-record files: record types S0 to S9 without S4. Addresses have 16, 24 or 32 bits.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "firmware_file/finding.hpp"
#include "firmware_file/memory.hpp"
#include "firmware_file/record_text.hpp"

namespace cgw::firmware_file {

// A record S0: what a tool says about the file. Its address means nothing, and most write 0.
struct SRecordHeader {
    std::uint16_t address = 0;
    base::Bytes bytes;  // at most 252, may be empty

    friend bool operator==(const SRecordHeader&, const SRecordHeader&) = default;
};

struct SRecord {
    Memory memory;
    std::vector<SRecordHeader> headers;
    std::uint32_t start = 0;        // of the end record S7, S8 or S9
    std::size_t address_bytes = 2;  // 2: S1 and S9, 3: S2 and S8, 4: S3 and S7; more when addresses need it
    bool counted = false;           // the file has a record S5 or S6 with the number of its data records
    RecordStyle style{};
};

// Refuses what is not whole: a wrong checksum, length or digit, an unknown record, an address with two
// values, a wrong count, a missing end, anything behind the end. A line of Ctrl-Z there, which ends texts of
// old DOS tools, is taken and not kept.
Outcome<SRecord> read_s_record(std::span<const std::uint8_t> text);

// Headers, records in ascending order of addresses, count, end.
std::string write_s_record(const SRecord& file);

// Headers as they stand in a whole text, in upper case, whether it has a count, and the start address of its
// end, sorted: what writing it again must keep beside the data.
std::vector<std::string> other_s_records(std::span<const std::uint8_t> text);

}  // namespace cgw::firmware_file
