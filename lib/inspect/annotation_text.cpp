// 80 columns: mark, offset, up to four bytes, type, name, value, meaning. What is longer goes on below.
#include <algorithm>

#include <fmt/format.h>

#include "base/utf8.hpp"
#include "base/wrap.hpp"
#include "inspect/annotation.hpp"

namespace cgw::inspect {
namespace {

constexpr std::size_t bytes_per_line = 4;
constexpr std::size_t value_width = 10;
constexpr std::size_t value_column = 43;
constexpr std::size_t meaning_width = 80 - value_column - value_width - 1;
constexpr std::size_t wide_width = 80 - value_column;  // value and meaning together

// Wrapped, and words that are longer than a line cut.
std::vector<std::string> lines_of(std::string_view text, std::size_t width) {
    std::vector<std::string> lines;
    for (const std::string& wrapped : base::wrap(text, width)) {
        std::string_view rest = wrapped;
        do {
            std::size_t bytes = 0;
            for (std::size_t shown = 0; bytes < rest.size() && shown < width; ++shown) {
                bytes += std::max<std::size_t>(base::utf8_sequence_length(rest.substr(bytes)), 1);
            }
            lines.emplace_back(rest.substr(0, bytes));
            rest.remove_prefix(bytes);
        } while (!rest.empty());
    }
    return lines;
}

// Value and meaning side by side, or below each other where the value is long.
std::vector<std::string> right_side(const Item& item) {
    if (base::width_of(item.value) > value_width) {
        std::vector<std::string> lines = lines_of(item.value, wide_width);
        if (!item.meaning.empty()) {
            const auto more = lines_of(item.meaning, wide_width);
            lines.insert(lines.end(), more.begin(), more.end());
        }
        return lines;
    }
    std::vector<std::string> lines;
    for (const std::string& line : lines_of(item.meaning, meaning_width)) {
        lines.push_back(fmt::format("{:<{}} {}", lines.empty() ? item.value : "", value_width, line));
    }
    return lines;
}

std::string hexadecimal(std::span<const std::uint8_t> bytes) {
    std::string text;
    for (const std::uint8_t byte : bytes) {
        text += fmt::format("{}{:02X}", text.empty() ? "" : " ", byte);
    }
    return text;
}

void put_line(std::string& page, std::string line) {
    line.erase(line.find_last_not_of(' ') + 1);
    page += line + "\n";
}

void put_wrong(std::string& page, std::size_t indent, std::string_view wrong) {
    for (const std::string& line : lines_of(wrong, 80 - indent - 4)) {
        put_line(page, fmt::format("!{:{}}^^ {}", "", indent, line));
    }
}

void put_item(std::string& page, const Item& item, std::span<const std::uint8_t> bytes) {
    const std::vector<std::string> right = right_side(item);
    const std::size_t byte_lines = (item.size + bytes_per_line - 1) / bytes_per_line;
    for (std::size_t i = 0; i < std::max(byte_lines, right.size()); ++i) {
        const std::size_t from = std::min(item.size, i * bytes_per_line);
        const std::size_t count = std::min(bytes_per_line, item.size - from);
        const bool first = i == 0;
        put_line(page, fmt::format("{} {} {:<11} {:<5} {:<17} {}", first && !item.wrong.empty() ? '!' : ' ',
                                   first ? fmt::format("{:04X}", item.offset) : std::string(4, ' '),
                                   hexadecimal(bytes.subspan(item.offset + from, count)),
                                   first ? name_of(item.type) : "", first ? item.name : "",
                                   i < right.size() ? right[i] : ""));
    }
    if (!item.wrong.empty()) {
        put_wrong(page, 6, item.wrong);
    }
}

}  // namespace

std::string annotation_text(const Annotation& annotation, std::span<const std::uint8_t> bytes,
                            std::string_view path) {
    std::string page = fmt::format("{}: {} bytes\n", path, bytes.size());
    for (const Group& group : annotation.groups) {
        page += "\n" + base::printable(group.title) + "\n";
        if (!group.wrong.empty()) {
            put_wrong(page, 1, group.wrong);
        }
        for (const Item& item : group.items) {
            put_item(page, item, bytes);
        }
    }
    return page;
}

}  // namespace cgw::inspect
