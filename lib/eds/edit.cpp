#include "eds/edit.hpp"

#include <algorithm>

namespace cgw::eds {
namespace {

std::string_view text_of(LineEnd line_end) {
    switch (line_end) {
        case LineEnd::none:
            return "";
        case LineEnd::lf:
            return "\n";
        case LineEnd::crlf:
            return "\r\n";
        case LineEnd::cr:
            return "\r";
    }
    return "";
}

}  // namespace

std::uint32_t Edits::behind(std::uint32_t line) const {
    const Line& of = document_.lines()[line];
    return of.end + static_cast<std::uint32_t>(text_of(of.line_end).size());
}

void Edits::replace(const Span& span, std::string_view text) {
    changes_.push_back({span.begin, span.end, std::string(text)});
}

void Edits::remove(std::uint32_t line) {
    changes_.push_back({document_.lines()[line].begin, behind(line), ""});
}

void Edits::insert_after(std::uint32_t line, std::string_view text) {
    const Line& before = document_.lines()[line];
    const std::uint32_t at = behind(line);
    if (before.line_end != LineEnd::none) {
        changes_.push_back({at, at, std::string(text).append(text_of(before.line_end))});
        return;
    }
    const LineEnd usual = line > 0 ? document_.lines()[line - 1].line_end : LineEnd::lf;
    changes_.push_back({at, at, std::string(text_of(usual)).append(text)});
}

std::string Edits::apply() const {
    std::vector<const Change*> order;
    order.reserve(changes_.size());
    for (const Change& change : changes_) {
        order.push_back(&change);
    }
    std::stable_sort(order.begin(), order.end(),
                     [](const Change* a, const Change* b) { return a->begin < b->begin; });
    const std::string& text = document_.text();
    std::string result;
    result.reserve(text.size());
    std::size_t at = 0;
    for (const Change* const change : order) {
        result.append(text, at, change->begin - at);
        result += change->text;
        at = change->end;
    }
    return result.append(text, at);
}

}  // namespace cgw::eds
