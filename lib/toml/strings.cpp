#include "toml/strings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>

#include "base/utf8.hpp"
#include "diagnostic/rules/files.hpp"

namespace cgw::toml {
namespace {

struct Escape {
    char letter;
    char meaning;
};

constexpr Escape escapes[] = {{'b', '\b'}, {'t', '\t'}, {'n', '\n'}, {'f', '\f'},
                              {'r', '\r'}, {'"', '"'},  {'\\', '\\'}};

void append_utf8(std::string& text, std::uint32_t code) {
    const auto byte = [&](std::uint32_t value) { text += static_cast<char>(value); };
    const auto tail = [&](unsigned shift) { byte(0x80U | ((code >> shift) & 0x3FU)); };
    if (code < 0x80) {
        byte(code);
    } else if (code < 0x800) {
        byte(0xC0U | (code >> 6U));
        tail(0);
    } else if (code < 0x10000) {
        byte(0xE0U | (code >> 12U));
        tail(6);
        tail(0);
    } else {
        byte(0xF0U | (code >> 18U));
        tail(12);
        tail(6);
        tail(0);
    }
}

class StringReader {
  public:
    StringReader(const Source& source, std::size_t begin)
        : source_(source), text_(source.text()), begin_(begin), at_(begin), quote_(text_[begin]) {}

    StringLiteral read(bool may_span_lines) {
        const bool is_long = text_.substr(begin_, 3) == std::string(3, quote_);
        if (is_long && may_span_lines) {
            read_long();
        } else {
            read_short();
        }
        return {std::move(content_), at_};
    }

  private:
    bool has_escapes() const { return quote_ == '"'; }

    void read_short() {
        for (++at_; at_ < text_.size() && text_[at_] != '\n' && text_[at_] != '\r';) {
            if (text_[at_] == quote_) {
                ++at_;
                return;
            }
            take_character();
        }
        throw Complaint{&diagnostic::rules::toml_syntax, source_.range(begin_, at_),
                        "the string is not closed on this line"};
    }

    void read_long() {
        at_ += 3;
        skip_newline();
        while (at_ < text_.size()) {
            const std::size_t stop = std::min(text_.find_first_not_of(quote_, at_), text_.size());
            const std::size_t quotes = stop - at_;
            if (quotes >= 3) {
                // Up to two quotes may stand directly before the closing three.
                const std::size_t inside = std::min<std::size_t>(quotes - 3, 2);
                content_.append(inside, quote_);
                at_ += inside + 3;
                return;
            }
            if (quotes > 0) {
                content_.append(quotes, quote_);
                at_ = stop;
            } else if (!skip_escaped_newline()) {
                take_character();
            }
        }
        throw Complaint{&diagnostic::rules::toml_syntax, source_.range(begin_, begin_ + 3),
                        "the multi-line string that begins here is not closed"};
    }

    bool skip_newline() {
        const std::size_t length = text_.substr(at_, 2) == "\r\n" ? 2 : text_.substr(at_, 1) == "\n" ? 1 : 0;
        at_ += length;
        return length > 0;
    }

    // A backslash at the end of a line swallows all white space up to the next character.
    bool skip_escaped_newline() {
        if (!has_escapes() || text_[at_] != '\\') {
            return false;
        }
        const std::size_t end = text_.find_first_not_of(" \t", at_ + 1);
        if (end == std::string_view::npos || (text_[end] != '\n' && text_[end] != '\r')) {
            return false;
        }
        at_ = std::min(text_.find_first_not_of(" \t\r\n", end), text_.size());
        return true;
    }

    void take_character() {
        if (has_escapes() && text_[at_] == '\\') {
            take_escape();
        } else {
            content_ += text_[at_++];
        }
    }

    void take_escape() {
        const char letter = at_ + 1 < text_.size() ? text_[at_ + 1] : '\n';
        for (const Escape& escape : escapes) {
            if (escape.letter == letter) {
                content_ += escape.meaning;
                at_ += 2;
                return;
            }
        }
        if (letter == 'u' || letter == 'U') {
            take_code_point(letter == 'u' ? 4 : 8);
            return;
        }
        throw Complaint{&diagnostic::rules::toml_syntax, source_.range(at_, at_ + 1),
                        fmt::format("a backslash is followed by {}, which is no escape sequence",
                                    describe(source_, at_ + 1)),
                        R"(write \\ for a backslash, or put the text between apostrophes)"};
    }

    void take_code_point(std::size_t digits) {
        const std::string_view text = text_.substr(at_ + 2, digits);
        std::uint32_t code = 0;
        const char* end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, code, 16);
        const bool complete = error == std::errc() && stop == end && text.size() == digits;
        const bool is_surrogate = code >= 0xD800 && code <= 0xDFFF;
        if (!complete || is_surrogate || code > 0x10FFFF) {
            throw Complaint{
                &diagnostic::rules::toml_syntax, source_.range(at_, at_ + 2),
                fmt::format("the escape sequence does not name a character: {} hexadecimal digits "
                            "of a Unicode character are needed",
                            digits)};
        }
        append_utf8(content_, code);
        at_ += 2 + digits;
    }

    const Source& source_;
    std::string_view text_;
    std::size_t begin_;
    std::size_t at_;
    char quote_;
    std::string content_;
};

}  // namespace

StringLiteral read_string(const Source& source, std::size_t begin, bool may_span_lines) {
    return StringReader(source, begin).read(may_span_lines);
}

std::string describe(const Source& source, std::size_t offset) {
    const std::string_view rest = source.text().substr(offset);
    if (rest.empty()) {
        return "the end of the file";
    }
    switch (rest.front()) {
        case '\n':
        case '\r':
            return "the end of the line";
        case '\t':
            return "a tab";
        case '#':
            return "a comment";
        default:
            return fmt::format("'{}'", rest.substr(0, base::utf8_sequence_length(rest)));
    }
}

}  // namespace cgw::toml
