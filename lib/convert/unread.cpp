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

// Sub-objects have the keys of objects.
bool is_unknown(SectionKind kind, std::string_view key) {
    const SectionKind of = kind == SectionKind::sub_object ? SectionKind::object : kind;
    return !eds_check::rows_of(of).empty() && eds_check::find_key(of, key) == nullptr;
}

}  // namespace

std::vector<Unread> unread_of_sections(std::string text) {
    const eds::Document document(std::move(text));
    Counter sections;
    Counter keys;
    std::size_t comments = 0;
    for (const eds::Section& section : document.sections()) {
        const std::string_view name = document.name(section);
        const SectionKind kind = eds::parse_section_name(name).kind;
        if (is_unread(kind)) {
            sections.add(name, fmt::format("[{}]", base::printable(name)));
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
    std::vector<Unread> all = sections.take();
    for (Unread& each : keys.take()) {
        all.push_back(std::move(each));
    }
    if (comments != 0) {
        all.push_back({"lines of comment", comments});
    }
    return all;
}

}  // namespace cgw::convert
