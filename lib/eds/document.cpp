#include "eds/document.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <numeric>
#include <utility>

#include "base/ascii.hpp"

namespace cgw::eds {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

constexpr bool is_blank(char c) {
    return c == ' ' || c == '\t';
}

// By character.
constexpr auto lower_case = [] {
    std::array<std::uint8_t, 0x100> table{};
    for (unsigned c = 0; c < table.size(); ++c) {
        table[c] = static_cast<std::uint8_t>(base::lower(static_cast<char>(c)));
    }
    return table;
}();

// FNV-1a. Names made to collide cost nothing: equal hashes are ordered by name.
std::uint64_t hash_ignoring_case(std::string_view name) {
    std::uint64_t hash = 0xCBF29CE484222325U;
    for (const char c : name) {
        hash = (hash ^ lower_case[static_cast<std::uint8_t>(c)]) * 0x100000001B3U;
    }
    return hash;
}

// Numbers of the hashes in their order, of equal ones in that of the numbers: put into as many buckets as
// there are hashes, by their first bits, then sorted within each.
std::vector<std::uint32_t> order_of(const std::vector<std::uint64_t>& hashes) {
    std::vector<std::uint32_t> order(hashes.size());
    if (hashes.empty()) {
        return order;
    }
    const auto bits = static_cast<unsigned>(std::bit_width(hashes.size()));
    const auto bucket_of = [shift = 64 - bits](std::uint64_t hash) { return hash >> shift; };
    std::vector<std::uint32_t> begins((std::size_t{1} << bits) + 1);
    for (const std::uint64_t hash : hashes) {
        ++begins[bucket_of(hash) + 1];
    }
    std::partial_sum(begins.begin(), begins.end(), begins.begin());
    std::vector<std::uint32_t> free = begins;
    for (std::uint32_t number = 0; number < hashes.size(); ++number) {
        order[free[bucket_of(hashes[number])]++] = number;
    }
    const auto is_less = [&](std::uint32_t a, std::uint32_t b) {
        return hashes[a] != hashes[b] ? hashes[a] < hashes[b] : a < b;
    };
    for (std::size_t bucket = 0; bucket + 1 < begins.size(); ++bucket) {
        if (begins[bucket + 1] - begins[bucket] > 1) {
            std::sort(order.begin() + begins[bucket], order.begin() + begins[bucket + 1], is_less);
        }
    }
    return order;
}

// The first of a character in [begin, end); `end` when there is none.
const char* next_of(const char* begin, const char* end, char wanted) {
    const void* const found = std::memchr(begin, wanted, static_cast<std::size_t>(end - begin));
    return found != nullptr ? static_cast<const char*>(found) : end;
}

}  // namespace

Document::Document(std::string text) : text_(std::move(text)) {
    text_begin_ = text_.starts_with(byte_order_mark) ? static_cast<std::uint32_t>(byte_order_mark.size()) : 0;
    read_lines();
    index_names();
}

void Document::read_lines() {
    constexpr std::size_t usual_line = 18;  // bytes
    lines_.reserve(text_.size() / usual_line + 1);
    const char* const text = text_.data();
    const char* const text_end = text + text_.size();
    const char* carriage_return = nullptr;  // the next one; each byte is looked at once for it
    const char* line_feed = nullptr;
    for (const char* at = text + text_begin_; at != text_end;) {
        line_feed = line_feed < at ? next_of(at, text_end, '\n') : line_feed;
        carriage_return = carriage_return < at ? next_of(at, text_end, '\r') : carriage_return;
        const char* const end = std::min(line_feed, carriage_return);
        const char* next = end;
        Line line;
        line.begin = static_cast<std::uint32_t>(at - text);
        line.end = static_cast<std::uint32_t>(end - text);
        if (end + 1 == line_feed && line_feed != text_end) {
            line.line_end = LineEnd::crlf;
            next += 2;
        } else if (end != text_end) {
            line.line_end = end == line_feed ? LineEnd::lf : LineEnd::cr;
            next += 1;
        }
        classify(line, at, end);
        if (line.kind == LineKind::section) {
            close_section();
            sections_.push_back({static_cast<std::uint32_t>(lines_.size()), 0});
        }
        lines_.push_back(line);
        at = next;
    }
    close_section();
}

// The last section ends with the lines so far.
void Document::close_section() {
    if (!sections_.empty()) {
        sections_.back().end = static_cast<std::uint32_t>(lines_.size());
    }
}

void Document::classify(Line& line, const char* begin, const char* end) {
    const char* first = begin;
    while (first != end && is_blank(*first)) {
        ++first;
    }
    if (first == end) {
        return;
    }
    if (*first == ';' || *first == '#') {
        line.kind = LineKind::comment;
        line.mark = line.end;
        return;
    }
    const bool is_section = *first == '[';
    const char* const mark = next_of(first, end, is_section ? ']' : '=');
    line.mark = line.begin + static_cast<std::uint32_t>(mark - begin);
    line.kind = is_section ? LineKind::section : mark != end ? LineKind::entry : LineKind::other;
}

void Document::index_names() {
    hashes_.reserve(sections_.size());
    for (const Section& section : sections_) {
        hashes_.push_back(hash_ignoring_case(name(section)));
    }
    by_name_ = order_of(hashes_);
    const auto hash_at = [this](std::size_t place) { return hashes_[by_name_[place]]; };
    for (std::size_t begin = 0, end = 0; begin < by_name_.size(); begin = end) {
        bool alike = true;
        for (end = begin + 1; end < by_name_.size() && hash_at(end) == hash_at(begin); ++end) {
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
                         return base::less_ignoring_case(name(sections_[a]), name(sections_[b]));
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
                                           : base::less_ignoring_case(name(sections_[number]), text);
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
