// What an ELF program loads into a device, and the sections it is made of: 32 and 64 bits, both byte orders.
// Nothing is trusted: a file is read only when everything its headers speak of lies inside it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "firmware_file/finding.hpp"

namespace cgw::firmware_file {

// A PT_LOAD segment, as far as it stands in the file.
struct ElfSegment {
    std::uint64_t address = 0;  // virtual: where the program sees it
    std::uint64_t offset = 0;   // in the file
    std::uint64_t size = 0;     // in the file

    friend bool operator==(const ElfSegment&, const ElfSegment&) = default;
};

struct ElfSection {
    std::string name;
    std::uint32_t type = 0;
    std::uint64_t flags = 0;
    std::uint64_t address = 0;
    std::uint64_t offset = 0;
    std::uint64_t size = 0;

    bool has_contents() const;
    friend bool operator==(const ElfSection&, const ElfSection&) = default;
};

// Bytes of the file.
struct ElfRange {
    std::uint64_t offset = 0;
    std::uint64_t size = 0;

    bool meets(const ElfRange& other) const {
        return offset < other.offset + other.size && other.offset < offset + size;
    }
    friend bool operator==(const ElfRange&, const ElfRange&) = default;
};

struct Elf {
    std::vector<ElfRange> headers;  // what is about the program: header, tables, names of the sections
    std::vector<ElfSegment> segments;
    std::vector<ElfSection> sections;

    friend bool operator==(const Elf&, const Elf&) = default;
};

// Refuses object files and cores, extended numbering (65280 sections and more), tables, segments, sections
// and names outside the file, and addresses that wrap.
Outcome<Elf> read_elf(std::span<const std::uint8_t> file);

// The section that an image can be put into: the only one of its name, with contents that are plain program
// data, in one loaded segment, and sharing its bytes with no other section.
Outcome<ElfSection> find_section(const Elf& elf, std::string_view name);

}  // namespace cgw::firmware_file
