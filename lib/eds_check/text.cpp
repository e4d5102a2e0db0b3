// The file as text: lines, characters, comments, blanks.
#include <fmt/format.h>

#include <algorithm>

#include "base/ascii.hpp"
#include "base/utf8.hpp"
#include "diagnostic/rules/eds_check.hpp"
#include "eds_check/context.hpp"
#include "eds_check/subjects.hpp"

namespace cgw::eds_check {
namespace {

namespace rules = diagnostic::rules;
using eds::Line;
using eds::LineEnd;
using eds::LineKind;

constexpr std::uint32_t longest_line = 255;

std::string_view text_of(const Context& context, const Line& line) {
    return std::string_view(context.document.text()).substr(line.begin, line.end - line.begin);
}

template <typename Take>
void for_each_line(const Context& context, Take take) {
    const std::span<const Line> lines = context.document.lines();
    for (std::uint32_t number = 0; number < lines.size(); ++number) {
        take(number, lines[number]);
    }
}

bool is_foreign(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte >= 0x7F || (byte < ' ' && c != '\t' && c != '\0');  // a byte 0 is told by the reader
}

std::string_view name_of(LineEnd line_end) {
    return line_end == LineEnd::crlf ? "CRLF" : line_end == LineEnd::lf ? "LF" : "CR";
}

bool is_blank(char c) {
    return c == ' ' || c == '\t';
}

// [2000 ]; those behind the name, else those before it.
std::optional<Span> blanks_inside(const std::string& text, std::uint32_t number, const Line& line) {
    const std::uint32_t open = line.begin + 1;
    std::uint32_t behind = line.mark;
    while (behind > open && is_blank(text[behind - 1])) {
        --behind;
    }
    std::uint32_t before = open;
    while (before < behind && is_blank(text[before])) {
        ++before;
    }
    if (line.mark == line.end || (behind == line.mark && before == open)) {
        return std::nullopt;
    }
    return behind != line.mark ? Span{number, behind, line.mark} : Span{number, open, before};
}

}  // namespace

void check_line_lengths(const Context& context) {
    for_each_line(context, [&](std::uint32_t number, const Line& line) {
        const std::uint32_t length = line.end - line.begin;
        if (length > longest_line) {
            const Span beyond{number, line.begin + longest_line, line.end};
            context.reading.report(
                rules::eds_line_length, beyond,
                fmt::format("this line has {} characters; {} are allowed", length, longest_line));
        }
    });
}

void check_characters(const Context& context) {
    for_each_line(context, [&](std::uint32_t number, const Line& line) {
        const std::string_view text = text_of(context, line);
        const auto* const found = std::find_if(text.begin(), text.end(), is_foreign);
        if (found == text.end()) {
            return;
        }
        const auto at = static_cast<std::size_t>(found - text.begin());
        const std::size_t length = std::max<std::size_t>(base::utf8_sequence_length(text.substr(at)), 1);
        const auto begin = static_cast<std::uint32_t>(line.begin + at);
        const std::string what =
            length > 1
                ? fmt::format("`{}` is no character of ASCII", text.substr(at, length))
                : fmt::format("byte 0x{:02X} is no character of ASCII", static_cast<unsigned char>(*found));
        context.reading.report(rules::eds_character,
                               {number, begin, begin + static_cast<std::uint32_t>(length)}, what);
    });
}

void check_byte_order_mark(const Context& context) {
    if (context.document.has_byte_order_mark() && !context.document.lines().empty()) {
        const std::uint32_t begin = context.document.lines().front().begin;
        context.reading.report(rules::eds_byte_order_mark, {0, begin, begin},
                               "the file begins with a byte order mark of UTF-8");
    }
}

void check_comment_marks(const Context& context) {
    for_each_line(context, [&](std::uint32_t number, const Line& line) {
        if (line.kind != LineKind::comment) {
            return;
        }
        const std::string_view text = text_of(context, line);
        const auto at = static_cast<std::uint32_t>(text.find_first_of(";#"));
        if (at == 0 && text[0] == ';') {
            return;
        }
        context.reading.report(rules::eds_comment_mark, {number, line.begin + at, line.begin + at + 1},
                               text[at] == '#' ? "# begins no comment in an EDS"
                                               : "this comment does not begin in the first column");
    });
}

void check_line_ends(const Context& context) {
    LineEnd usual = LineEnd::none;
    std::size_t others = 0;
    std::uint32_t first = 0;
    for_each_line(context, [&](std::uint32_t number, const Line& line) {
        if (line.line_end == LineEnd::none) {
            return;
        }
        usual = usual == LineEnd::none ? line.line_end : usual;
        if (line.line_end != usual || usual == LineEnd::cr) {
            first = others++ == 0 ? number : first;
        }
    });
    if (others == 0) {
        return;
    }
    const Line& line = context.document.lines()[first];
    const std::string message =
        usual == LineEnd::cr
            ? std::string("lines end with CR alone")
            : fmt::format("{} line{} unlike the first one, which ends with {}; this one with {}", others,
                          others == 1 ? " ends" : "s end", name_of(usual), name_of(line.line_end));
    context.reading.report(rules::eds_line_ends, {first, line.end, line.end}, message);
}

void check_blanks(const Context& context) {
    for_each_line(context, [&](std::uint32_t number, const Line& line) {
        if (line.kind != LineKind::section && line.kind != LineKind::entry) {
            return;
        }
        const std::string& text = context.document.text();
        const bool entry = line.kind == LineKind::entry;
        if (is_blank(text[line.begin])) {
            const auto end = text.find_first_not_of(" \t", line.begin);
            context.reading.report(rules::eds_blanks, {number, line.begin, static_cast<std::uint32_t>(end)},
                                   entry ? "blanks stand before the key" : "blanks stand before the [");
        } else if (const auto inside = entry ? std::nullopt : blanks_inside(text, number, line)) {
            context.reading.report(rules::eds_blanks, *inside, "blanks stand inside the brackets");
        } else if (entry && line.mark > line.begin && is_blank(text[line.mark - 1])) {
            context.reading.report(rules::eds_blanks,
                                   {number, context.document.key_span(number).end, line.mark},
                                   "blanks stand between key and equals sign");
        }
    });
}

void check_header_tails(const Context& context) {
    for (const eds::Section& section : context.document.sections()) {
        const Line& line = context.document.lines()[section.header];
        const std::string_view tail =
            text_of(context, line).substr(std::min(line.mark + 1, line.end) - line.begin);
        if (base::trimmed(tail).empty()) {
            continue;
        }
        context.reading.report(rules::eds_header_tail, {section.header, line.mark + 1, line.end},
                               "something stands behind the ] of this section");
    }
}

void check_semicolons(const Context& context) {
    for_each_entry(context, [&](std::uint32_t section, std::uint32_t line) {
        const KeyRow* const row = context.model.key_row(line);
        const Span span = context.document.value_span(line);
        const std::size_t at = context.document.value(line).find(';');
        const bool shared_count = context.kind_of(section) == eds::SectionKind::module_sub_extension &&
                                  row != nullptr && row->name == "Count";
        if (at == std::string_view::npos || shared_count) {
            return;
        }
        context.reading.report(rules::eds_semicolon,
                               {line, span.begin + static_cast<std::uint32_t>(at), span.end},
                               "a semicolon stands in this value");
    });
}

}  // namespace cgw::eds_check
