#include "xdd/well_formed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "base/ascii.hpp"
#include "base/numbers.hpp"
#include "base/utf8.hpp"

namespace cgw::xdd {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr std::array<std::string_view, 5> entities{"lt", "gt", "amp", "quot", "apos"};
constexpr std::size_t longest_reference = 32;  // that a finding shows

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

// XML 1.0, Char
bool is_character(std::int64_t code) {
    return code == 0x9 || code == 0xA || code == 0xD || (code >= 0x20 && code <= 0xD7FF) ||
           (code >= 0xE000 && code <= 0xFFFD) || (code >= 0x10000 && code <= 0x10FFFF);
}

// What stands between & and ;
bool is_reference(std::string_view name) {
    if (!name.starts_with('#')) {
        return std::find(entities.begin(), entities.end(), name) != entities.end();
    }
    const bool hexadecimal = name.starts_with("#x");
    const std::string_view digits = name.substr(hexadecimal ? 2 : 1);
    const auto code = base::consists_of(digits, hexadecimal ? base::hexadecimal_digits : base::digits)
                          ? base::parse_integer(digits, hexadecimal ? 16 : 10)
                          : std::nullopt;
    return code && is_character(*code);
}

class Scanner {
  public:
    explicit Scanner(std::string_view text) : text_(text) {}

    std::optional<Fault> run() {
        if (const std::size_t at = find_control(); at != text_.size()) {
            return Fault{at, fmt::format("a control character 0x{:02X} stands in it", text_[at])};
        }
        at_ = text_.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
        while (at_ < text_.size() && !fault_) {
            text_[at_] == '<' ? markup() : characters();
        }
        return std::move(fault_);
    }

  private:
    std::size_t find_control() const {
        const auto found = std::find_if(text_.begin(), text_.end(), [](char c) {
            return static_cast<unsigned char>(c) < ' ' && !is_blank(c);
        });
        return static_cast<std::size_t>(found - text_.begin());
    }

    void fail(std::size_t offset, std::string what) {
        if (!fault_) {
            fault_ = Fault{offset, std::move(what)};
        }
    }

    void characters() {
        const std::size_t end = std::min(text_.find('<', at_), text_.size());
        const std::string_view found = text_.substr(at_, end - at_);
        const auto first = std::find_if_not(found.begin(), found.end(), is_blank);
        if (depth_ == 0 && first != found.end()) {
            fail(at_ + static_cast<std::size_t>(first - found.begin()),
                 "text stands outside of the root element");
        }
        references(at_, found);
        at_ = end;
    }

    // In `part`, which stands at `offset`.
    void references(std::size_t offset, std::string_view part) {
        for (std::size_t at = part.find('&'); at != std::string_view::npos; at = part.find('&', at + 1)) {
            const std::size_t semicolon = part.find(';', at);
            const std::string_view name = part.substr(at + 1, semicolon - at - 1);
            if (semicolon == std::string_view::npos || !is_reference(name)) {
                fail(offset + at, fmt::format("`&{}` begins no reference to a character",
                                              base::printable(name.substr(0, longest_reference))));
                return;
            }
        }
    }

    void markup() {
        if (rest().starts_with("<!--")) {
            constexpr std::size_t length = 4;
            const std::size_t dashes = text_.find("--", at_ + length);
            if (dashes != std::string_view::npos && text_.substr(dashes, 3) != "-->") {
                fail(dashes, "two hyphens stand in a comment");
            }
            skip_behind("-->");
        } else if (rest().starts_with("<![CDATA[")) {
            if (depth_ == 0) {
                fail(at_, "text stands outside of the root element");
            }
            skip_behind("]]>");
        } else if (rest().starts_with("<?")) {
            skip_behind("?>");
        } else if (rest().starts_with("</")) {
            depth_ -= depth_ > 0 ? 1 : 0;
            skip_behind(">");
        } else {
            tag();
        }
    }

    void tag() {
        const std::size_t begin = at_;
        skip_while([](char c) { return !is_blank(c) && c != '/' && c != '>'; });
        names_.clear();
        while (!fault_) {
            skip_while(is_blank);
            if (at_ >= text_.size() || text_[at_] == '>') {
                ++depth_;
                ++at_;
                break;
            }
            if (text_[at_] == '/') {
                skip_behind(">");
                break;
            }
            attribute();
        }
        judge_names(begin);
    }

    void attribute() {
        const std::size_t begin = at_;
        skip_while([](char c) { return !is_blank(c) && c != '='; });
        names_.push_back(text_.substr(begin, at_ - begin));
        skip_while([](char c) { return c != '"' && c != '\''; });
        if (at_ >= text_.size()) {
            return;
        }
        const std::size_t begin_of_value = at_ + 1;
        const std::size_t end = std::min(text_.find(text_[at_], begin_of_value), text_.size());
        const std::string_view value = text_.substr(begin_of_value, end - begin_of_value);
        if (const std::size_t less = value.find('<'); less != std::string_view::npos) {
            fail(begin_of_value + less, "`<` stands in the value of an attribute");
        }
        references(begin_of_value, value);
        at_ = end + 1;
    }

    void judge_names(std::size_t tag) {
        std::sort(names_.begin(), names_.end());
        const auto twice = std::adjacent_find(names_.begin(), names_.end());
        if (twice != names_.end()) {
            fail(tag, fmt::format("the attribute {} stands twice in one element", base::printable(*twice)));
        }
    }

    std::string_view rest() const { return text_.substr(at_); }

    template <typename Is>
    void skip_while(Is is) {
        while (at_ < text_.size() && is(text_[at_])) {
            ++at_;
        }
    }

    void skip_behind(std::string_view end) {
        const std::size_t found = text_.find(end, at_);
        at_ = found == std::string_view::npos ? text_.size() : found + end.size();
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t depth_ = 0;
    std::vector<std::string_view> names_;
    std::optional<Fault> fault_;
};

}  // namespace

std::optional<Fault> find_fault(std::string_view text) {
    return Scanner(text).run();
}

}  // namespace cgw::xdd
