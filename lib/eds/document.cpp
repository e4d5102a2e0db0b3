#include "eds/document.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include "base/ascii.hpp"

namespace cgw::eds {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

constexpr bool is_blank(char c) {
    return c == ' ' || c == '\t';
}

// FNV-1a. Names made to collide cost nothing: equal hashes are ordered by name.
std::uint64_t hash_ignoring_case(std::string_view name) {
    std::uint64_t hash = 0xCBF29CE484222325U;
    for (const char c : name) {
        hash = (hash ^ static_cast<std::uint8_t>(base::lower(c))) * 0x100000001B3U;
    }
    return hash;
}

bool less_ignoring_case(std::string_view a, std::string_view b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(),
                                        [](char x, char y) { return base::lower(x) < base::lower(y); });
}

// The next of one character, remembered until it is passed: each byte is looked at once for each of them.
class Next {
  public:
    Next(const std::string& text, char wanted) : text_(text), wanted_(wanted) {}

    // At or behind `from`, which never goes back; the end of the text when there is none.
    std::size_t at(std::size_t from) {
        if (found_ < from || !searched_) {
            found_ = std::min(text_.find(wanted_, from), text_.size());
            searched_ = true;
        }
        return found_;
    }

  private:
    const std::string& text_;
    char wanted_;
    std::size_t found_ = 0;
    bool searched_ = false;
};

}  // namespace

Document::Document(std::string text) : text_(std::move(text)) {
    text_begin_ = text_.starts_with(byte_order_mark) ? static_cast<std::uint32_t>(byte_order_mark.size()) : 0;
    read_lines();
    index_names();
}

void Document::read_lines() {
    constexpr std::size_t usual_line = 18;  // bytes
    lines_.reserve(text_.size() / usual_line + 1);
    Next line_feed(text_, '\n');
    Next carriage_return(text_, '\r');
    for (std::size_t at = text_begin_; at < text_.size();) {
        const std::size_t end = std::min(line_feed.at(at), carriage_return.at(at));
        const bool crlf = end + 1 < text_.size() && text_[end] == '\r' && text_[end + 1] == '\n';
        Line& line = lines_.emplace_back();
        line.begin = static_cast<std::uint32_t>(at);
        line.end = static_cast<std::uint32_t>(end);
        line.line_end = end == text_.size()  ? LineEnd::none
                        : crlf               ? LineEnd::crlf
                        : text_[end] == '\n' ? LineEnd::lf
                                             : LineEnd::cr;
        classify(line);
        const auto number = static_cast<std::uint32_t>(lines_.size() - 1);
        if (line.kind == LineKind::section) {
            sections_.push_back({number, number + 1});
        } else if (!sections_.empty()) {
            sections_.back().end = number + 1;
        }
        at = end + (crlf ? 2 : 1);
    }
}

void Document::classify(Line& line) const {
    const char* const text = text_.data();
    std::uint32_t first = line.begin;
    while (first < line.end && is_blank(text[first])) {
        ++first;
    }
    if (first == line.end) {
        return;
    }
    line.mark = line.end;
    if (text[first] == ';' || text[first] == '#') {
        line.kind = LineKind::comment;
        return;
    }
    line.kind = text[first] == '[' ? LineKind::section : LineKind::other;
    const char mark = text[first] == '[' ? ']' : '=';
    if (const void* const found = std::memchr(text + first, mark, line.end - first)) {
        line.mark = static_cast<std::uint32_t>(static_cast<const char*>(found) - text);
        line.kind = mark == '=' ? LineKind::entry : LineKind::section;
    }
}

void Document::index_names() {
    hashes_.reserve(sections_.size());
    for (const Section& section : sections_) {
        hashes_.push_back(hash_ignoring_case(name(section)));
    }
    std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
    order.reserve(sections_.size());
    for (std::uint32_t number = 0; number < sections_.size(); ++number) {
        order.emplace_back(hashes_[number], number);
    }
    std::sort(order.begin(), order.end());
    by_name_.reserve(order.size());
    for (const auto& [hash, number] : order) {
        by_name_.push_back(number);
    }
    for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
        bool alike = true;
        for (end = begin + 1; end < order.size() && order[end].first == order[begin].first; ++end) {
            alike = alike && same_name(by_name_[begin], by_name_[end]);
        }
        if (!alike) {
            sort_by_name(begin, end);
        }
    }
}

// Names of one hash, which is rare or meant to be slow.
void Document::sort_by_name(std::size_t begin, std::size_t end) {
    const auto first = by_name_.begin();
    std::stable_sort(first + static_cast<std::ptrdiff_t>(begin), first + static_cast<std::ptrdiff_t>(end),
                     [this](std::uint32_t a, std::uint32_t b) {
                         return less_ignoring_case(name(sections_[a]), name(sections_[b]));
                     });
}

std::uint32_t Document::preamble_end() const {
    return sections_.empty() ? static_cast<std::uint32_t>(lines_.size()) : sections_.front().header;
}

Span Document::name_span(const Section& section) const {
    const Line& line = lines_[section.header];
    std::uint32_t begin = line.begin;
    while (is_blank(text_[begin])) {
        ++begin;
    }
    return trimmed(section.header, begin + 1, line.mark);
}

diagnostic::Range Document::range(const Span& span) const {
    const std::uint32_t begin = lines_[span.line].begin;
    return {{span.line + 1, span.begin - begin + 1}, {span.line + 1, span.end - begin + 1}};
}

const Section* Document::find(std::string_view wanted) const {
    const std::uint64_t hash = hash_ignoring_case(wanted);
    const auto found = std::lower_bound(
        by_name_.begin(), by_name_.end(), wanted, [&](std::uint32_t number, std::string_view text) {
            return hashes_[number] != hash ? hashes_[number] < hash
                                           : less_ignoring_case(name(sections_[number]), text);
        });
    const bool is_it = found != by_name_.end() && base::equal_ignoring_case(name(sections_[*found]), wanted);
    return is_it ? &sections_[*found] : nullptr;
}

std::optional<std::uint32_t> Document::find(const Section& section, std::string_view wanted) const {
    for (std::uint32_t line = section.header + 1; line < section.end; ++line) {
        if (lines_[line].kind == LineKind::entry && base::equal_ignoring_case(key(line), wanted)) {
            return line;
        }
    }
    return std::nullopt;
}

std::optional<std::string_view> Document::value(std::string_view section, std::string_view wanted) const {
    const Section* const found = find(section);
    const std::optional<std::uint32_t> line = found != nullptr ? find(*found, wanted) : std::nullopt;
    return line ? std::optional(value(*line)) : std::nullopt;
}

bool Document::same_name(std::uint32_t a, std::uint32_t b) const {
    return hashes_[a] == hashes_[b] && base::equal_ignoring_case(name(sections_[a]), name(sections_[b]));
}

}  // namespace cgw::eds
