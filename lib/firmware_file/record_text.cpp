#include "firmware_file/record_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "base/ascii.hpp"
#include "base/utf8.hpp"
#include "diagnostic/rules/firmware.hpp"

namespace cgw::firmware_file {
namespace {

constexpr std::string_view digits = "0123456789ABCDEF";
constexpr std::size_t most_blocks = 65536;  // each costs memory, and no firmware has that many gaps

// A place inside a line; columns count from 1.
diagnostic::Range columns(std::uint32_t line, std::size_t first, std::size_t end) {
    return {{line, static_cast<std::uint32_t>(first)}, {line, static_cast<std::uint32_t>(end)}};
}

std::uint8_t value_of(char digit) {
    return static_cast<std::uint8_t>(digits.find(base::upper(digit)));
}

}  // namespace

diagnostic::Range Line::range(std::size_t prefix, std::size_t first, std::size_t last) const {
    return columns(number, prefix + 2 * first + 1, prefix + 2 * last + 1);
}

diagnostic::Range Line::whole() const {
    return columns(number, 1, text.size() + 1);
}

bool Line::is_dos_end() const {
    return text.find_first_not_of('\x1A') == std::string_view::npos;
}

std::string Line::upper_case() const {
    std::string upper(text);
    std::transform(upper.begin(), upper.end(), upper.begin(), base::upper);
    return upper;
}

bool Lines::next(Line& line) {
    while (!rest_.empty()) {
        const std::size_t end = std::min(rest_.find('\n'), rest_.size());
        line.text = rest_.substr(0, end);
        line.number = ++number_;
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
        line.text = line.text.substr(0, line.text.find_last_not_of(" \t\r") + 1);
        if (!line.text.empty()) {
            return true;
        }
    }
    return false;
}

std::string line_end_of(std::span<const std::uint8_t> text) {
    const auto end = std::find(text.begin(), text.end(), '\n');
    return end != text.begin() && end != text.end() && *std::prev(end) == '\r' ? "\r\n" : "\n";
}

Outcome<base::Bytes> decode(const Line& line, std::size_t prefix) {
    const std::string_view text = line.text.substr(std::min(prefix, line.text.size()));
    const auto wrong =
        std::find_if_not(text.begin(), text.end(), [](char c) { return base::is_hexadecimal_digit(c); });
    if (wrong != text.end()) {
        const std::size_t column = prefix + static_cast<std::size_t>(wrong - text.begin()) + 1;
        return refuse(
            diagnostic::rules::record_line,
            fmt::format("'{}' is no hexadecimal digit", base::printable(std::string_view(&*wrong, 1))),
            columns(line.number, column, column + 1));
    }
    if (text.size() % 2 != 0) {
        return refuse(diagnostic::rules::record_line,
                      "the record ends within a byte: the number of digits is odd",
                      columns(line.number, line.text.size(), line.text.size() + 1));
    }
    base::Bytes bytes(text.size() / 2);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        bytes[i] = static_cast<std::uint8_t>(16 * value_of(text[2 * i]) + value_of(text[2 * i + 1]));
    }
    return bytes;
}

void encode(std::string& text, std::span<const std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) {
        text += digits[byte >> 4U];
        text += digits[byte & 15U];
    }
}

std::size_t up_to_multiple(std::uint64_t address, std::size_t size) {
    return std::has_single_bit(size) ? size - static_cast<std::size_t>(address % size) : size;
}

namespace {

// Of records that hold `size` bytes from `begin` on.
std::size_t longest_record(std::uint64_t begin, std::uint64_t end, std::size_t size) {
    const auto first =
        static_cast<std::size_t>(std::min<std::uint64_t>(up_to_multiple(begin, size), end - begin));
    return std::max(first, static_cast<std::size_t>(std::min<std::uint64_t>(size, end - begin - first)));
}

std::size_t longest_record(std::span<const Block> blocks, std::size_t size, std::uint64_t bank) {
    std::size_t longest = 0;
    for (const Block& block : blocks) {
        for (std::uint64_t begin = block.address; begin < block.end();) {
            const std::uint64_t end =
                bank == 0 ? block.end() : std::min(block.end(), (begin / bank + 1) * bank);
            longest = std::max(longest, longest_record(begin, end, size));
            begin = end;
        }
    }
    return longest;
}

}  // namespace

std::size_t settled_size(std::span<const Block> blocks, std::size_t size, std::uint64_t bank) {
    for (;;) {
        const std::size_t longest = longest_record(blocks, size, bank);
        if (longest == 0 || longest == size) {
            return size;
        }
        size = longest;
    }
}

void Pieces::add(std::uint64_t address, std::span<const std::uint8_t> bytes, const Line& line) {
    if (!bytes.empty()) {
        pieces_.push_back({address, bytes_.size(), bytes.size(), line.whole()});
        bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
        longest_ = std::max(longest_, bytes.size());
    }
}

Outcome<Memory> Pieces::join() {
    std::stable_sort(pieces_.begin(), pieces_.end(),
                     [](const Piece& a, const Piece& b) { return a.address < b.address; });
    Memory memory;
    const Piece* last = nullptr;
    for (const Piece& piece : pieces_) {
        if (last != nullptr && last->address + last->size > piece.address) {
            const bool later = last->where.start < piece.where.start;
            const Piece& again = later ? piece : *last;
            const Piece& first = later ? *last : piece;
            return refuse(diagnostic::rules::record_address,
                          fmt::format("address {} is given again; line {} has it already",
                                      address_text(piece.address), first.where.start.line),
                          again.where);
        }
        memory.append(piece.address, std::span(bytes_).subspan(piece.offset, piece.size));
        if (memory.blocks().size() > most_blocks) {
            return refuse(
                diagnostic::rules::record_address,
                fmt::format("this begins block {} of the data: a firmware does not have so many gaps",
                            most_blocks + 1),
                piece.where);
        }
        last = &piece;
    }
    return memory;
}

}  // namespace cgw::firmware_file
