#include "convert/unread.hpp"

#include <fmt/format.h>

#include <map>

#include "base/ascii.hpp"
#include "base/utf8.hpp"
#include "eds/document.hpp"
#include "eds_check/keys.hpp"

namespace cgw::convert {
namespace {

using eds::SectionKind;

// Counts what stands there several times, by any case, in the order of the first of each.
class Counter {
  public:
    void add(std::string_view name, std::string_view shown) {
        std::string key(name);
        for (char& c : key) {
            c = base::lower(c);
        }
        const auto [found, is_new] = places_.emplace(std::move(key), all_.size());
        if (is_new) {
            all_.push_back({std::string(shown), 0});
        }
        ++all_[found->second].count;
    }
    std::vector<Unread> take() { return std::move(all_); }

  private:
    std::map<std::string, std::size_t> places_;
    std::vector<Unread> all_;
};

bool is_unread(SectionKind kind) {
    return kind == SectionKind::unknown || kind == SectionKind::tools ||
           kind == SectionKind::dynamic_channels;
}

std::vector<std::string> lines_of(const eds::Document& document, const eds::Section& section) {
    std::vector<std::string> lines;
    for (std::uint32_t line = section.header + 1; line < section.end; ++line) {
        const eds::LineKind kind = document.lines()[line].kind;
        if (kind == eds::LineKind::entry || kind == eds::LineKind::other) {
            lines.emplace_back(document.view(document.line_span(line)));
        }
    }
    return lines;
}

// Sub-objects have the keys of objects.
bool is_unknown(SectionKind kind, std::string_view key) {
    const SectionKind of = kind == SectionKind::sub_object ? SectionKind::object : kind;
    return !eds_check::rows_of(of).empty() && eds_check::find_key(of, key) == nullptr;
}

}  // namespace

PassedOver passed_over_in(std::string text) {
    const eds::Document document(std::move(text));
    PassedOver passed_over;
    Counter keys;
    std::size_t comments = 0;
    for (const eds::Section& section : document.sections()) {
        const std::string_view name = document.name(section);
        const SectionKind kind = eds::parse_section_name(name).kind;
        if (is_unread(kind)) {
            passed_over.sections.push_back({std::string(name), lines_of(document, section)});
            continue;
        }
        for (std::uint32_t line = section.header + 1; line < section.end; ++line) {
            if (document.lines()[line].kind == eds::LineKind::entry && is_unknown(kind, document.key(line))) {
                keys.add(document.key(line), "key " + base::printable(document.key(line)));
            }
        }
    }
    for (const eds::Line& line : document.lines()) {
        comments += line.kind == eds::LineKind::comment ? 1U : 0U;
    }
    passed_over.unread = keys.take();
    if (comments != 0) {
        passed_over.unread.push_back({"lines of comment", comments});
    }
    return passed_over;
}

std::vector<Unread> unread_of(const std::vector<FurtherSection>& sections) {
    Counter counter;
    for (const FurtherSection& section : sections) {
        counter.add(section.name, fmt::format("[{}]", base::printable(section.name)));
    }
    return counter.take();
}

}  // namespace cgw::convert
