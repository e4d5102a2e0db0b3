#include "firmware_file/firmware_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "diagnostic/rules/firmware.hpp"

namespace cgw::firmware_file {
namespace {

namespace rules = diagnostic::rules;

constexpr std::array<std::uint8_t, 4> elf_magic{0x7F, 'E', 'L', 'F'};

}  // namespace

std::optional<Kind> kind_of(std::span<const std::uint8_t> bytes) {
    if (bytes.size() >= elf_magic.size() && std::equal(elf_magic.begin(), elf_magic.end(), bytes.begin())) {
        return Kind::elf;
    }
    const auto first = std::find_if(bytes.begin(), bytes.end(), [](std::uint8_t byte) {
        return byte != ' ' && byte != '\t' && byte != '\r' && byte != '\n';
    });
    if (first == bytes.end()) {
        return std::nullopt;
    }
    if (*first == ':') {
        return Kind::intel_hex;
    }
    const auto second = std::next(first);
    if (*first == 'S' && second != bytes.end() && *second >= '0' && *second <= '9') {
        return Kind::s_record;
    }
    return std::nullopt;
}

std::string_view to_text(Kind kind) {
    constexpr std::array<std::string_view, 3> names{"ELF", "Intel HEX", "S-record"};
    return names[static_cast<std::size_t>(kind)];
}

Outcome<FirmwareFile> FirmwareFile::read(std::span<const std::uint8_t> bytes) {
    FirmwareFile file;
    const std::optional<Kind> kind = kind_of(bytes);
    if (!kind) {
        return refuse(rules::firmware_kind,
                      "this is neither an ELF program nor an Intel HEX or S-record file", {},
                      "take the file that the linker or objcopy made; a plain binary one has no addresses");
    }
    if (*kind != Kind::elf && bytes.size() > largest_record_file) {
        return refuse(rules::firmware_kind,
                      fmt::format("the {} file has {} bytes; more than 64 MiB are not read", to_text(*kind),
                                  bytes.size()));
    }
    const auto keep = [&file](auto content) -> Outcome<FirmwareFile> {
        if (!content) {
            return tl::unexpected(content.error());
        }
        file.content_ = std::move(*content);
        return std::move(file);
    };
    switch (*kind) {
        case Kind::intel_hex:
            return keep(read_intel_hex(bytes));
        case Kind::s_record:
            return keep(read_s_record(bytes));
        case Kind::elf:
            break;
    }
    Outcome<Elf> elf = read_elf(bytes);
    if (!elf) {
        return tl::unexpected(elf.error());
    }
    file.content_ = Program{base::Bytes(bytes.begin(), bytes.end()), std::move(*elf)};
    return file;
}

const Memory* FirmwareFile::memory() const {
    if (const auto* hex = std::get_if<IntelHex>(&content_); hex != nullptr) {
        return &hex->memory;
    }
    const auto* records = std::get_if<SRecord>(&content_);
    return records != nullptr ? &records->memory : nullptr;
}

std::vector<Area> FirmwareFile::areas() const {
    std::vector<Area> areas;
    if (const Memory* bytes = memory(); bytes != nullptr) {
        for (const Block& block : bytes->blocks()) {
            areas.push_back({block.address, block.bytes});
        }
        return areas;
    }
    const auto& program = std::get<Program>(content_);
    for (const ElfSegment& segment : program.elf.segments) {
        if (segment.size != 0) {
            areas.push_back(
                {segment.address, std::span(program.bytes).subspan(segment.offset, segment.size)});
        }
    }
    return areas;
}

Outcome<Area> FirmwareFile::from(std::uint64_t address) const {
    if (const Memory* bytes = memory(); bytes != nullptr) {
        return Area{address, bytes->from(address)};
    }
    Area found{address, {}};
    for (const Area& area : areas()) {
        if (address < area.address || address >= area.end()) {
            continue;
        }
        if (!found.bytes.empty()) {
            return refuse(rules::elf_structure, fmt::format("two segments hold {}", address_text(address)));
        }
        found.bytes = area.bytes.subspan(address - area.address);
    }
    return found;
}

Outcome<Area> FirmwareFile::section(std::string_view name) const {
    const Program* program = std::get_if<Program>(&content_);
    if (program == nullptr) {
        return refuse(rules::firmware_section, fmt::format("an {} file has no sections", to_text(kind())), {},
                      "say where with --address");
    }
    const Outcome<ElfSection> section = find_section(program->elf, name);
    if (!section) {
        return tl::unexpected(section.error());
    }
    // Another segment may claim the address; what the program sees there is then anybody's guess.
    if (Outcome<Area> alone = from(section->address); !alone) {
        return alone;
    }
    return Area{section->address, std::span(program->bytes).subspan(section->offset, section->size)};
}

void FirmwareFile::put(std::uint64_t address, std::span<const std::uint8_t> bytes) {
    if (auto* hex = std::get_if<IntelHex>(&content_); hex != nullptr) {
        hex->memory.put(address, bytes);
        return;
    }
    if (auto* records = std::get_if<SRecord>(&content_); records != nullptr) {
        records->memory.put(address, bytes);
        return;
    }
    auto& program = std::get<Program>(content_);
    const ElfSegment& segment = segment_of(program, address, bytes.size());
    std::copy(
        bytes.begin(), bytes.end(),
        program.bytes.begin() + static_cast<std::ptrdiff_t>(segment.offset + (address - segment.address)));
}

const ElfSegment& FirmwareFile::segment_of(const Program& program, std::uint64_t address,
                                           std::uint64_t size) {
    for (const ElfSegment& segment : program.elf.segments) {
        if (address >= segment.address && address + size <= segment.address + segment.size) {
            return segment;
        }
    }
    throw std::logic_error("the program has no bytes there");
}

Outcome<void> FirmwareFile::allows(std::uint64_t address, std::uint64_t size) const {
    const Program* program = std::get_if<Program>(&content_);
    if (program == nullptr) {
        return {};
    }
    return replaceable(program->elf, segment_of(*program, address, size), address, size);
}

base::Bytes FirmwareFile::bytes() const {
    if (const auto* hex = std::get_if<IntelHex>(&content_); hex != nullptr) {
        return base::to_bytes(write_intel_hex(*hex));
    }
    if (const auto* records = std::get_if<SRecord>(&content_); records != nullptr) {
        return base::to_bytes(write_s_record(*records));
    }
    return std::get<Program>(content_).bytes;
}

bool FirmwareFile::same_outside(const FirmwareFile& other, std::uint64_t begin, std::uint64_t end) const {
    if (content_.index() != other.content_.index()) {
        return false;
    }
    const base::Bytes blank(end - begin, 0);
    FirmwareFile mine = *this;
    FirmwareFile theirs = other;
    mine.put(begin, blank);
    theirs.put(begin, blank);
    return mine.bytes() == theirs.bytes();
}

}  // namespace cgw::firmware_file
