// A firmware file of any of the three kinds: which bytes it puts at which addresses, and a way to replace
// some.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "base/bytes.hpp"
#include "firmware_file/elf.hpp"
#include "firmware_file/intel_hex.hpp"
#include "firmware_file/s_record.hpp"

namespace cgw::firmware_file {

inline constexpr std::size_t largest_record_file = std::size_t{64} * 1024 * 1024;  // Intel HEX, S-record

// By the first bytes; nullopt for anything else.
enum class Kind { elf, intel_hex, s_record };
std::optional<Kind> kind_of(std::span<const std::uint8_t> bytes);
std::string_view to_text(Kind kind);  // "Intel HEX"

// Bytes that stand together in a file, by the address where the program sees them.
struct Area {
    std::uint64_t address = 0;
    std::span<const std::uint8_t> bytes;

    std::uint64_t end() const { return address + bytes.size(); }
};

class FirmwareFile {
  public:
    static Outcome<FirmwareFile> read(std::span<const std::uint8_t> bytes);

    Kind kind() const { return static_cast<Kind>(content_.index()); }

    // What the file holds. Areas of an ELF program are its segments, which a strange one may lay over each
    // other.
    std::vector<Area> areas() const;

    // The area that begins at an address and ends with what stands there; empty where nothing stands. Refused
    // where two segments of a program claim the address.
    Outcome<Area> from(std::uint64_t address) const;

    // Contents of a section, by find_section() of elf.hpp; Intel HEX and S-record files have none.
    Outcome<Area> section(std::string_view name) const;

    // Refuses to let bytes of an ELF program be replaced that replaceable() of elf.hpp does not give; there
    // must be such bytes.
    Outcome<void> allows(std::uint64_t address, std::uint64_t size) const;

    // Replaces bytes that it allows; those of an ELF program must all be there in one area.
    void put(std::uint64_t address, std::span<const std::uint8_t> bytes);

    // The whole file, written again.
    base::Bytes bytes() const;

    // Nothing but the bytes inside [begin, end) differs.
    bool same_outside(const FirmwareFile& other, std::uint64_t begin, std::uint64_t end) const;

  private:
    struct Program {
        base::Bytes bytes;
        Elf elf;
    };
    // In the order of Kind.
    std::variant<Program, IntelHex, SRecord> content_;

    const Memory* memory() const;
    static const ElfSegment& segment_of(const Program& program, std::uint64_t address, std::uint64_t size);
};

}  // namespace cgw::firmware_file
