#include "firmware_file/elf.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "diagnostic/rules/firmware.hpp"

namespace cgw::firmware_file {
namespace {

namespace rules = diagnostic::rules;

// Offsets of fields in the ELF header, a program header and a section header (System V ABI, chapters 4 and
// 5).
struct Layout {
    std::size_t word;           // bytes of an address or offset
    std::uint64_t address_end;  // one more than the highest address
    std::size_t header_size, program_offset, section_offset, program_entry, program_count, section_entry,
        section_count, names_index;
    std::size_t program_size, p_offset, p_address, p_file_size, p_memory_size, p_flags;
    std::size_t section_size, s_flags, s_address, s_offset, s_size;
};
constexpr Layout layout_32{
    4, std::uint64_t{1} << 32U, 52, 28, 32, 42, 44, 46, 48, 50, 32, 4, 8, 16, 20, 24, 40, 8, 12, 16, 20};
constexpr Layout layout_64{
    8, std::uint64_t{1} << 63U, 64, 32, 40, 54, 56, 58, 60, 62, 56, 8, 16, 32, 40, 4, 64, 8, 16, 24, 32};

constexpr std::size_t class_at = 4, byte_order_at = 5, version_at = 6, type_at = 16, identification_size = 16;
constexpr std::uint64_t extended_programs = 0xFFFF, extended_index = 0xFFFF;
constexpr std::uint32_t executable = 2, shared = 3;  // e_type
constexpr std::uint32_t loaded = 1;                  // p_type PT_LOAD
constexpr std::uint32_t segment_writable = 2;        // p_flags
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
            if (segment.size > segment.memory ||
                !inside(segment.address, segment.memory, layout_->address_end)) {
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
            if (!inside(section.address, section.size, layout_->address_end)) {
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

}  // namespace

Outcome<Elf> read_elf(std::span<const std::uint8_t> file) {
    return Reader(file).read();
}

}  // namespace cgw::firmware_file
