// What Intel HEX and S-record files have in common: lines of hexadecimal digits that say at which address
// bytes stand. Private to the room.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/bytes.hpp"
#include "firmware_file/finding.hpp"
#include "firmware_file/memory.hpp"

namespace cgw::firmware_file {

inline constexpr std::uint64_t address_limit = std::uint64_t{1} << 32;  // the first address they cannot have

// How the records of a file look; kept when the file is written again.
struct RecordStyle {
    std::size_t data_bytes = 16;  // of a full record: 1..255, S-records less
    std::string line_end = "\n";
};

struct Line {
    std::string_view text;  // without its end and blanks before that
    std::uint32_t number = 0;

    // Digits of byte number `first` up to the one before `last`, behind `prefix` characters.
    diagnostic::Range range(std::size_t prefix, std::size_t first, std::size_t last) const;
    diagnostic::Range whole() const;

    bool is_dos_end() const;  // nothing but Ctrl-Z, with which old DOS tools end a text
    std::string upper_case() const;
};

// The lines of a text that are not blank.
class Lines {
  public:
    explicit Lines(std::span<const std::uint8_t> text)
        : rest_(reinterpret_cast<const char*>(text.data()), text.size()) {}

    bool next(Line& line);
    std::uint32_t count() const { return number_; }

  private:
    std::string_view rest_;
    std::uint32_t number_ = 0;
};

// "\r\n" when the first line ends so, else "\n".
std::string line_end_of(std::span<const std::uint8_t> text);

// The bytes whose digits stand behind `prefix` characters, upper or lower case.
Outcome<base::Bytes> decode(const Line& line, std::size_t prefix);

// Adds the bytes as upper-case digits.
void encode(std::string& text, std::span<const std::uint8_t> bytes);

// Bytes from an address to the next multiple of `size` when that is a power of two, else `size`: so that
// records are cut where other tools cut them.
std::size_t up_to_multiple(std::uint64_t address, std::size_t size);

// Bytes of a full record, at most `size`, such that one of the blocks has a full one: who reads the file
// again takes it for the same. `bank`: no record goes beyond a multiple of it; 0: none.
std::size_t settled_size(std::span<const Block> blocks, std::size_t size, std::uint64_t bank);

// The data of all records, in any order, until they are joined.
class Pieces {
  public:
    void add(std::uint64_t address, std::span<const std::uint8_t> bytes, const Line& line);

    std::size_t longest() const { return longest_; }  // bytes
    Outcome<Memory> join();  // refuses an address that has two values, and more than 65536 blocks

  private:
    struct Piece {
        std::uint64_t address = 0;
        std::size_t offset = 0;  // in bytes_
        std::size_t size = 0;
        diagnostic::Range where;
    };
    base::Bytes bytes_;
    std::vector<Piece> pieces_;
    std::size_t longest_ = 0;
};

}  // namespace cgw::firmware_file
