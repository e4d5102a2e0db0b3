// Where in an ELF program an image may stand.
#include <fmt/format.h>

#include <algorithm>

#include "base/utf8.hpp"
#include "diagnostic/rules/firmware.hpp"
#include "firmware_file/elf.hpp"

namespace cgw::firmware_file {
namespace {

namespace rules = diagnostic::rules;

constexpr std::uint32_t unused = 0, program_data = 1, no_contents = 8;              // sh_type
constexpr std::uint64_t writable = 1, in_memory = 2, code = 4, compressed = 0x800;  // sh_flags

constexpr const char* demanded =
    "an image stands in read-only data that has contents and is loaded: a constant array, or (READONLY) in "
    "the linker script";

// The section's bytes are those that this segment loads at the section's address.
bool holds(const ElfSegment& segment, const ElfSection& section) {
    return section.offset >= segment.offset && section.offset - segment.offset <= segment.size &&
           section.size <= segment.size - (section.offset - segment.offset) &&
           section.address - segment.address == section.offset - segment.offset;
}

bool share_bytes(const ElfSection& a, const ElfSection& b) {
    return a.has_contents() && b.has_contents() && ElfRange{a.offset, a.size}.meets({b.offset, b.size});
}

// Why it can have no image; nullptr when it can.
const char* unfit(const ElfSection& section) {
    if (section.type == no_contents) {
        return "has no contents in the file (NOBITS)";
    }
    if (section.type != program_data) {
        return "is no program data (PROGBITS)";
    }
    if ((section.flags & compressed) != 0) {
        return "is compressed";
    }
    if ((section.flags & in_memory) == 0) {
        return "is not loaded into the device";
    }
    return nullptr;
}

// Why an image that it could have is not put there all the same.
const char* not_free(const ElfSection& section) {
    if (const char* why = unfit(section); why != nullptr) {
        return why;
    }
    if ((section.flags & writable) != 0) {
        return "is writable";
    }
    return (section.flags & code) != 0 ? "is code" : nullptr;
}

Outcome<void> alone(const Elf& elf, const ElfSection& section) {
    for (const ElfSection& other : elf.sections) {
        if (&other != &section && share_bytes(other, section)) {
            return refuse(rules::elf_structure,
                          fmt::format("sections {} and {} share bytes of the file",
                                      base::printable(section.name), base::printable(other.name)));
        }
    }
    return {};
}

// The section that the program sees at the first of the bytes must be a place for all of them.
Outcome<void> replaceable_in_sections(const Elf& elf, const ElfSegment& segment, std::uint64_t address,
                                      std::uint64_t size) {
    const auto found = std::find_if(elf.sections.begin(), elf.sections.end(), [&](const ElfSection& section) {
        return section.has_contents() && (section.flags & in_memory) != 0 && section.address <= address &&
               address - section.address < section.size;
    });
    if (found == elf.sections.end() || !holds(segment, *found)) {
        return refuse(rules::firmware_address, fmt::format("no section holds {}", address_text(address)), {},
                      "reserve the area in the program, as a section of read-only data");
    }
    const std::string shown = base::printable(found->name);
    if (const char* why = not_free(*found); why != nullptr) {
        return refuse(rules::firmware_section, fmt::format("section {} {}", shown, why), {}, demanded);
    }
    const std::uint64_t rest = found->size - (address - found->address);
    if (size > rest) {
        return refuse(rules::image_room, fmt::format("section {} has {} bytes from {} on, the image needs {}",
                                                     shown, rest, address_text(address), size));
    }
    return alone(elf, *found);
}

}  // namespace

bool ElfSection::has_contents() const {
    return type != unused && type != no_contents;
}

Outcome<ElfSection> find_section(const Elf& elf, std::string_view name) {
    const ElfSection* found = nullptr;
    const std::string shown = base::printable(name);
    for (const ElfSection& section : elf.sections) {
        if (section.name != name) {
            continue;
        }
        if (found != nullptr) {
            return refuse(rules::firmware_section, fmt::format("section {} exists twice", shown), {},
                          "say where with --address");
        }
        found = &section;
    }
    if (found == nullptr) {
        return refuse(rules::firmware_section, fmt::format("there is no section {}", shown));
    }
    if (const char* why = unfit(*found); why != nullptr) {
        return refuse(rules::firmware_section, fmt::format("section {} {}", shown, why), {}, demanded);
    }
    const auto loads = [&](const ElfSegment& segment) { return holds(segment, *found); };
    if (std::count_if(elf.segments.begin(), elf.segments.end(), loads) != 1) {
        return refuse(rules::firmware_section,
                      fmt::format("section {} does not lie in one loaded segment", shown));
    }
    if (Outcome<void> single = alone(elf, *found); !single) {
        return tl::unexpected(single.error());
    }
    return *found;
}

Outcome<void> replaceable(const Elf& elf, const ElfSegment& segment, std::uint64_t address,
                          std::uint64_t size) {
    const ElfRange range{segment.offset + (address - segment.address), size};
    for (const ElfRange& header : elf.headers) {
        if (header.meets(range)) {
            return refuse(rules::elf_structure,
                          fmt::format("at byte 0x{:X}: headers of the file stand in the place of the image",
                                      header.offset));
        }
    }
    for (const ElfSegment& other : elf.segments) {
        if (&other != &segment && (range.meets({other.offset, other.size}) ||
                                   ElfRange{address, size}.meets({other.address, other.memory}))) {
            return refuse(rules::elf_structure,
                          fmt::format("two segments hold the bytes at {}", address_text(address)));
        }
    }
    if (!elf.sections.empty()) {
        return replaceable_in_sections(elf, segment, address, size);
    }
    if (segment.writable) {
        return refuse(rules::firmware_address,
                      fmt::format("the segment at {} is writable", address_text(segment.address)), {},
                      "reserve read-only data for the image");
    }
    return {};
}

}  // namespace cgw::firmware_file
