// The document layer of EDS and DCF: any bytes as lines, sections and entries, each with its place. It knows
// the syntax of CiA 306, not the meaning of a key, and refuses nothing: what is no section, entry or comment
// is a line of kind `other`.
//
// Lossless: the lines with their line ends are the text, byte for byte, in its order; keys, values and names
// are views into it. An Edit (eds/edit.hpp) replaces bytes of one line and leaves all others.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostic/location.hpp"

namespace cgw::eds {

// Bytes of the largest text that is read: fifty thousand objects take 12 MiB.
inline constexpr std::size_t largest_text = 32U * 1024U * 1024U;

enum class LineKind : std::uint8_t {
    blank,
    comment,  // its first character that is no blank is ';' or '#'
    section,  // '['; the name ends at the first ']', or with the line
    entry,    // has '=': key and value
    other,
};

enum class LineEnd : std::uint8_t { none, lf, crlf, cr };  // none: the text ends here

// Offsets into the text.
struct Line {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;   // before the line end
    std::uint32_t mark = 0;  // of an entry its first '='; of a section its ']', `end` when there is none
    LineKind kind = LineKind::blank;
    LineEnd line_end = LineEnd::none;
};

// Lines by number, from 0. The lines of a section are those behind its header, to the next one.
struct Section {
    std::uint32_t header = 0;
    std::uint32_t end = 0;  // behind its last line
};

// A part of one line.
struct Span {
    std::uint32_t line = 0;   // from 0
    std::uint32_t begin = 0;  // offsets into the text
    std::uint32_t end = 0;

    friend bool operator==(const Span&, const Span&) = default;
};

class Document {
  public:
    // At most largest_text bytes, of which the caller makes sure.
    explicit Document(std::string text);

    const std::string& text() const { return text_; }
    bool has_byte_order_mark() const {
        return text_begin_ != 0;
    }  // of UTF-8; not part of the first line's column

    std::span<const Line> lines() const { return lines_; }
    std::span<const Section> sections() const { return sections_; }
    std::uint32_t preamble_end() const;  // number of lines before the first section

    // Without blanks and tabs around them.
    std::string_view name(const Section& section) const { return view(name_span(section)); }
    std::string_view key(std::uint32_t line) const { return view(key_span(line)); }
    std::string_view value(std::uint32_t line) const { return view(value_span(line)); }
    std::string_view view(const Span& span) const {
        return {text_.data() + span.begin, span.end - span.begin};
    }

    Span name_span(const Section& section) const;
    Span key_span(std::uint32_t line) const {  // of an entry
        return trimmed(line, lines_[line].begin, lines_[line].mark);
    }
    Span value_span(std::uint32_t line) const {  // of an entry
        return trimmed(line, lines_[line].mark + 1, lines_[line].end);
    }
    Span line_span(std::uint32_t line) const { return {line, lines_[line].begin, lines_[line].end}; }

    // 1-based; columns count bytes.
    diagnostic::Range range(const Span& span) const;

    // Whatever the case; the first of that name. Section names are looked up in an index, keys from the top
    // of their section: who wants all entries walks them once.
    const Section* find(std::string_view wanted) const;
    std::optional<std::uint32_t> find(const Section& section, std::string_view wanted) const;

    // nullptr: no such section or key.
    std::optional<std::string_view> value(std::string_view section, std::string_view wanted) const;

    // Section numbers in the order of their names, whatever the case; equal names follow each other in file
    // order.
    std::span<const std::uint32_t> sections_by_name() const { return by_name_; }
    bool same_name(std::uint32_t a, std::uint32_t b) const;

  private:
    void read_lines();
    void close_section();
    static void classify(Line& line, const char* begin, const char* end);
    void index_names();
    void sort_by_name(std::size_t begin, std::size_t end);
    Span trimmed(std::uint32_t line, std::uint32_t begin, std::uint32_t end) const {
        const char* const text = text_.data();
        const auto is_blank = [text](std::uint32_t at) { return text[at] == ' ' || text[at] == '\t'; };
        while (begin < end && is_blank(begin)) {
            ++begin;
        }
        while (end > begin && is_blank(end - 1)) {
            --end;
        }
        return {line, begin, end};
    }

    std::string text_;
    std::uint32_t text_begin_ = 0;
    std::vector<Line> lines_;
    std::vector<Section> sections_;
    std::vector<std::uint64_t> hashes_;  // of the names, by section
    std::vector<std::uint32_t> by_name_;
};

}  // namespace cgw::eds
