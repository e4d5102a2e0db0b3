// What an ELF program loads into a device, and the sections it is made of: 32 and 64 bits, both byte orders.
// Nothing is trusted: a file is read only when everything its headers speak of lies inside it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "firmware_file/finding.hpp"

namespace cgw::firmware_file {

// A PT_LOAD segment that takes memory.
struct ElfSegment {
    std::uint64_t address = 0;  // virtual: where the program sees it
    std::uint64_t offset = 0;   // in the file
    std::uint64_t size = 0;     // in the file
    std::uint64_t memory = 0;   // bytes that it takes there, those of the file first
    bool writable = false;

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
        return size != 0 && other.size != 0 && offset < other.offset + other.size &&
               other.offset < offset + size;
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

// The section that can have an image: the only one of its name, with contents that are plain program
// data, in one loaded segment, and sharing its bytes with no other section.
Outcome<ElfSection> find_section(const Elf& elf, std::string_view name);

// Whether bytes of a segment, which lie in it as a whole, may be replaced. Refused when they are among the
// headers or another segment has them too, in the file or in memory. In a program with sections they lie in
// a single one, which is as find_section() wants it, neither writable nor code; without, in a segment that is
// not writable.
Outcome<void> replaceable(const Elf& elf, const ElfSegment& segment, std::uint64_t address,
                          std::uint64_t size);

}  // namespace cgw::firmware_file
