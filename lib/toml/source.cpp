#include "toml/source.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/utf8.hpp"
#include "diagnostic/rules/files.hpp"

namespace cgw::toml {

using diagnostic::Position;
using diagnostic::Range;

Source::Source(std::string_view text) : text_(text) {
    std::size_t start = 0;
    while (true) {
        const std::size_t stop = std::min(text.find('\n', start), text.size());
        const std::string_view line = text.substr(start, stop - start);
        const std::size_t first = line.find_first_not_of(" \t");
        const bool is_comment = first != std::string_view::npos && line[first] == '#';
        const std::uint32_t above = comments_.empty() ? 0 : comments_.back();
        starts_.push_back(static_cast<std::uint32_t>(start));
        comments_.push_back(is_comment ? above + static_cast<std::uint32_t>(line.size() + 1) : 0);
        if (stop == text.size()) {
            break;
        }
        start = stop + 1;
    }
}

std::size_t Source::line_index(std::size_t offset) const {
    const auto next = std::upper_bound(starts_.begin(), starts_.end(), offset);
    return static_cast<std::size_t>(next - starts_.begin()) - 1;
}

Position Source::position(std::size_t offset) const {
    const std::size_t line = line_index(offset);
    return {static_cast<std::uint32_t>(line + 1), static_cast<std::uint32_t>(offset - starts_[line] + 1)};
}

Range Source::range(std::size_t begin, std::size_t end) const {
    return {position(begin), position(end)};
}

std::size_t Source::line_and_comments(std::size_t offset) const {
    const std::size_t line = line_index(offset);
    const std::size_t end = line + 1 < starts_.size() ? starts_[line + 1] : text_.size();
    return end - starts_[line] + (line == 0 ? 0 : comments_[line - 1]);
}

namespace {

std::string help_for_encoding(std::string_view text) {
    const bool is_utf16 = text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
    return is_utf16 ? "the file looks like UTF-16; save it as UTF-8" : "save the file as UTF-8";
}

bool is_control(std::string_view text, std::size_t at) {
    const auto byte = static_cast<unsigned char>(text[at]);
    if (byte == '\r') {
        return at + 1 >= text.size() || text[at + 1] != '\n';
    }
    return (byte < 0x20 && byte != '\t' && byte != '\n') || byte == 0x7F;
}

// `message` may have one place for the byte's value.
Complaint about_byte(const Source& source, std::size_t at, std::string_view message) {
    const auto byte = static_cast<unsigned char>(source.text()[at]);
    return {&diagnostic::rules::file_not_utf8, source.range(at, at + 1),
            fmt::format(fmt::runtime(message), byte)};
}

}  // namespace

std::optional<Complaint> check_characters(const Source& source) {
    const std::string_view text = source.text();
    for (std::size_t at = 0; at < text.size();) {
        if (is_control(text, at)) {
            return about_byte(source, at,
                              text[at] == '\r' ? "a carriage return (0x0D) stands without a line feed"
                                               : "control character 0x{:02X} in the text");
        }
        const std::size_t length = base::utf8_sequence_length(text.substr(at, 4));
        if (length == 0) {
            Complaint complaint = about_byte(source, at, "byte 0x{:02X} is not UTF-8");
            complaint.help = help_for_encoding(text);
            return complaint;
        }
        at += length;
    }
    return std::nullopt;
}

}  // namespace cgw::toml
