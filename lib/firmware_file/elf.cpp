#include "firmware_file/elf.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/utf8.hpp"

namespace cgw::firmware_file {
namespace {

namespace rules = diagnostic::rules;

// Offsets of fields in the ELF header, a program header and a section header (System V ABI, chapters 4 and
// 5).
struct Layout {
    std::size_t word;  // bytes of an address or offset
    std::size_t header_size, program_offset, section_offset, program_entry, program_count, section_entry,
        section_count, names_index;
    std::size_t program_size, p_offset, p_address, p_file_size, p_memory_size, p_flags;
    std::size_t section_size, s_flags, s_address, s_offset, s_size;
};
constexpr Layout layout_32{4, 52, 28, 32, 42, 44, 46, 48, 50, 32, 4, 8, 16, 20, 24, 40, 8, 12, 16, 20};
constexpr Layout layout_64{8, 64, 32, 40, 54, 56, 58, 60, 62, 56, 8, 16, 32, 40, 4, 64, 8, 16, 24, 32};

constexpr std::size_t class_at = 4, byte_order_at = 5, version_at = 6, type_at = 16, identification_size = 16;
constexpr std::uint64_t extended_programs = 0xFFFF, extended_index = 0xFFFF;
constexpr std::uint32_t executable = 2, shared = 3;                                 // e_type
constexpr std::uint32_t loaded = 1;                                                 // p_type PT_LOAD
constexpr std::uint32_t unused = 0, program_data = 1, no_contents = 8;              // sh_type
constexpr std::uint32_t segment_writable = 2;                                       // p_flags
constexpr std::uint64_t writable = 1, in_memory = 2, code = 4, compressed = 0x800;  // sh_flags
constexpr std::uint64_t address_end = std::uint64_t{1} << 63U;
constexpr std::size_t longest_name = 1024;  // nobody has longer ones, and a damaged file could have huge ones

bool inside(std::uint64_t offset, std::uint64_t size, std::uint64_t total) {
    return offset <= total && size <= total - offset;
}

tl::unexpected<diagnostic::Diagnostic> damaged(std::uint64_t offset, std::string_view what) {
    return refuse(rules::elf_structure, fmt::format("at byte 0x{:X}: {}", offset, what));
}

class Reader {
  public:
    explicit Reader(std::span<const std::uint8_t> file) : file_(file) {}

    Outcome<Elf> read() {
        if (Outcome<void> done = read_identification(); !done) {
            return tl::unexpected(done.error());
        }
        if (Outcome<void> done = read_segments(); !done) {
            return tl::unexpected(done.error());
        }
        if (Outcome<void> done = read_sections(); !done) {
            return tl::unexpected(done.error());
        }
        return std::move(elf_);
    }

  private:
    // The caller has made sure that the bytes are there.
    std::uint64_t number(std::size_t offset, std::size_t width) const {
        std::uint64_t value = 0;
        for (std::size_t i = 0; i < width; ++i) {
            value = (value << 8U) | file_[offset + (big_ ? i : width - 1 - i)];
        }
        return value;
    }
    std::uint64_t half(std::size_t offset) const { return number(offset, 2); }
    std::uint32_t word(std::size_t offset) const { return static_cast<std::uint32_t>(number(offset, 4)); }
    std::uint64_t address(std::size_t offset) const { return number(offset, layout_->word); }

    Outcome<void> read_identification() {
        if (file_.size() < identification_size) {
            return damaged(file_.size(), "the file ends within the ELF header");
        }
        if ((file_[class_at] != 1 && file_[class_at] != 2) ||
            (file_[byte_order_at] != 1 && file_[byte_order_at] != 2) || file_[version_at] != 1) {
            return damaged(class_at, "unknown class, byte order or version");
        }
        layout_ = file_[class_at] == 1 ? &layout_32 : &layout_64;
        big_ = file_[byte_order_at] == 2;
        if (file_.size() < layout_->header_size) {
            return damaged(file_.size(), "the file ends within the ELF header");
        }
        elf_.headers.push_back({0, layout_->header_size});
        const std::uint64_t type = half(type_at);
        if (type != executable && type != shared) {
            return refuse(rules::elf_structure, "at byte 0x10: this is no linked program", {},
                          "an object file has no addresses yet: put the image into the program");
        }
        return {};
    }

    // Where a table begins; refused when it does not lie in the file.
    Outcome<std::size_t> table(std::size_t offset_at, std::size_t entry_at, std::uint64_t count,
                               std::size_t size, std::string_view name) {
        const std::uint64_t offset = address(offset_at);
        if (half(entry_at) != size) {
            return damaged(entry_at, fmt::format("an entry of the {} header table has {} bytes, not {}", name,
                                                 half(entry_at), size));
        }
        if (!inside(offset, count * size, file_.size())) {
            return damaged(offset_at, fmt::format("the {} header table lies outside the file", name));
        }
        elf_.headers.push_back({offset, count * size});
        return static_cast<std::size_t>(offset);
    }

    Outcome<void> read_segments() {
        const std::uint64_t count = half(layout_->program_count);
        if (count == 0) {
            return {};
        }
        if (count == extended_programs) {
            return damaged(layout_->program_count, "extended numbering of segments is not supported");
        }
        const Outcome<std::size_t> start =
            table(layout_->program_offset, layout_->program_entry, count, layout_->program_size, "program");
        if (!start) {
            return tl::unexpected(start.error());
        }
        std::uint64_t bytes = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t at = *start + i * layout_->program_size;
            if (word(at) != loaded) {
                continue;
            }
            const ElfSegment segment{address(at + layout_->p_address), address(at + layout_->p_offset),
                                     address(at + layout_->p_file_size), address(at + layout_->p_memory_size),
                                     (word(at + layout_->p_flags) & segment_writable) != 0};
            if (!inside(segment.offset, segment.size, file_.size())) {
                return damaged(at, fmt::format("segment {} lies outside the file", i));
            }
            if (segment.size > segment.memory || !inside(segment.address, segment.memory, address_end)) {
                return damaged(at, fmt::format("segment {} does not fit its addresses", i));
            }
            bytes += segment.size;
            if (bytes > file_.size()) {
                return damaged(at, "the segments lie over each other");
            }
            if (segment.memory != 0) {
                elf_.segments.push_back(segment);
            }
        }
        return {};
    }

    Outcome<void> read_sections() {
        const std::uint64_t count = half(layout_->section_count);
        if (count == 0 && address(layout_->section_offset) == 0) {
            return {};  // stripped
        }
        const std::uint64_t names_index = half(layout_->names_index);
        if (count == 0 || names_index == extended_index) {
            return damaged(layout_->section_count, "extended numbering of sections is not supported");
        }
        const Outcome<std::size_t> start =
            table(layout_->section_offset, layout_->section_entry, count, layout_->section_size, "section");
        if (!start) {
            return tl::unexpected(start.error());
        }
        if (names_index >= count) {
            return damaged(layout_->names_index, "there is no section with the names of the sections");
        }
        const ElfSection names = section_at(*start + names_index * layout_->section_size);
        if (!names.has_contents() || !inside(names.offset, names.size, file_.size())) {
            return damaged(layout_->names_index, "the names of the sections lie outside the file");
        }
        elf_.headers.push_back({names.offset, names.size});
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t at = *start + i * layout_->section_size;
            ElfSection section = section_at(at);
            if (section.has_contents() && !inside(section.offset, section.size, file_.size())) {
                return damaged(at, fmt::format("section {} lies outside the file", i));
            }
            if (!inside(section.address, section.size, address_end)) {
                return damaged(at, fmt::format("section {} does not fit its addresses", i));
            }
            std::span<const std::uint8_t> text = file_.subspan(names.offset, names.size);
            text = text.subspan(std::min<std::size_t>(word(at), text.size()));
            text = text.first(std::min(text.size(), longest_name));
            const auto end = std::find(text.begin(), text.end(), 0);
            if (end == text.end()) {
                return damaged(at, fmt::format("the name of section {} lies outside the names", i));
            }
            section.name.assign(text.begin(), end);
            elf_.sections.push_back(std::move(section));
        }
        return {};
    }

    ElfSection section_at(std::size_t at) const {
        ElfSection section;
        section.type = word(at + 4);
        section.flags = address(at + layout_->s_flags);
        section.address = address(at + layout_->s_address);
        section.offset = address(at + layout_->s_offset);
        section.size = address(at + layout_->s_size);
        return section;
    }

    std::span<const std::uint8_t> file_;
    const Layout* layout_ = &layout_32;
    bool big_ = false;
    Elf elf_;
};

// The section's bytes are those that this segment loads at the section's address.
bool holds(const ElfSegment& segment, const ElfSection& section) {
    return section.offset >= segment.offset &&
           inside(section.offset - segment.offset, section.size, segment.size) &&
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
        return refuse(rules::firmware_address, fmt::format("no section stands at {}", address_text(address)),
                      {}, "reserve the area in the program, as a section of read-only data");
    }
    const std::string shown = base::printable(found->name);
    if (const char* why = not_free(*found); why != nullptr) {
        return refuse(rules::firmware_section, fmt::format("section {} {}", shown, why), {},
                      "reserve read-only data: a constant array, or (READONLY) in the linker script");
    }
    const std::uint64_t rest = found->size - (address - found->address);
    if (size > rest) {
        return refuse(rules::image_room, fmt::format("section {} ends {} bytes behind {}, the image needs {}",
                                                     shown, rest, address_text(address), size));
    }
    return alone(elf, *found);
}

}  // namespace

bool ElfSection::has_contents() const {
    return type != unused && type != no_contents;
}

Outcome<Elf> read_elf(std::span<const std::uint8_t> file) {
    return Reader(file).read();
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
        return refuse(rules::firmware_section, fmt::format("section {} {}", shown, why));
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
