#include "xdd/source.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/ascii.hpp"
#include "base/utf8.hpp"
#include "diagnostic/rules/xdd.hpp"
#include "xdd/reader.hpp"
#include "xdd/well_formed.hpp"

namespace cgw::xdd {
namespace {

namespace rules = diagnostic::rules;

constexpr std::size_t longest_quote = 60;

}  // namespace

std::string_view local_name(const char* name) {
    const std::string_view whole = name;
    const std::size_t colon = whole.find(':');
    return colon == std::string_view::npos ? whole : whole.substr(colon + 1);
}

std::string quoted(std::string_view text) {
    const bool is_cut = text.size() > longest_quote;
    return fmt::format("`{}{}`", base::printable(text.substr(0, longest_quote)), is_cut ? "..." : "");
}

std::string quoted(pugi::xml_attribute attribute) {
    return fmt::format("{} is {}", base::printable(attribute.name()), quoted(attribute.value()));
}

Source::Source(std::string_view text, const std::string& path, diagnostic::Findings& findings)
    : text_(base::to_utf8(text)),
      from_latin_1_(text_.size() != text.size()),
      path_(path),
      findings_(findings),
      lines_{0} {
    for (std::size_t i = 0; i < text_.size(); ++i) {
        if (text_[i] == '\n') {
            lines_.push_back(i + 1);
        }
    }
}

bool Source::parse() {
    constexpr unsigned options = pugi::parse_default | pugi::parse_doctype | pugi::parse_comments;
    const pugi::xml_parse_result result =
        document_.load_buffer(text_.data(), text_.size(), options, pugi::encoding_utf8);
    if (!result) {
        const diagnostic::Position at =
            position(static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0)));
        add(rules::xdd_text, {at, at},
            fmt::format("this is no well-formed XML: {}", base::lowered(result.description())), "");
        return false;
    }
    std::size_t elements = 0;
    for (const pugi::xml_node child : document_.children()) {
        if (child.type() == pugi::node_doctype) {
            report_whole_file(rules::xdd_text,
                              "the file declares a document type (DOCTYPE), which no device description has");
            return false;
        }
        elements += child.type() == pugi::node_element ? 1U : 0U;
    }
    if (elements != 1) {
        report_whole_file(rules::xdd_text,
                          fmt::format("XML has one element around all others; this file has {}", elements));
        return false;
    }
    if (const std::optional<Fault> fault = find_fault(text_)) {
        const diagnostic::Position at = position(fault->offset);
        add(rules::xdd_text, {at, at}, fmt::format("this is no well-formed XML: {}", fault->what), "");
        return false;
    }
    return true;
}

void Source::add(const diagnostic::Rule& rule, const diagnostic::Range& range, std::string message,
                 std::string help) {
    if (++counts_[&rule] <= most_findings) {
        findings_.report({&rule, std::move(message), {path_, range}, {}, std::move(help)});
    }
}

void Source::report(const diagnostic::Rule& rule, pugi::xml_node element, std::string message,
                    std::string help) {
    add(rule, range_of(element), std::move(message), std::move(help));
}

void Source::report(const diagnostic::Rule& rule, pugi::xml_node element, pugi::xml_attribute attribute,
                    std::string message, std::string help) {
    add(rule, range_of(element, attribute), std::move(message), std::move(help));
}

void Source::report_whole_file(const diagnostic::Rule& rule, std::string message, std::string help) {
    findings_.report({&rule, std::move(message), {path_, {}}, {}, std::move(help)});
}

void Source::finish() {
    for (const auto& [rule, count] : counts_) {
        if (count > most_findings) {
            report_whole_file(*rule, fmt::format("{} more findings of this kind are not told one by one",
                                                 count - most_findings));
        }
    }
}

diagnostic::Position Source::position(std::size_t offset) const {
    const auto next = std::upper_bound(lines_.begin(), lines_.end(), offset);
    const std::size_t line = static_cast<std::size_t>(next - lines_.begin());
    const std::string_view before =
        std::string_view(text_).substr(lines_[line - 1], offset - lines_[line - 1]);
    std::size_t column = before.size() + 1;
    if (from_latin_1_) {  // in the file each character is one byte
        column -= static_cast<std::size_t>(
            std::count_if(before.begin(), before.end(), [](char c) { return (c & 0xC0) == 0x80; }));
    }
    return {static_cast<std::uint32_t>(line), static_cast<std::uint32_t>(column)};
}

// Its name.
diagnostic::Range Source::range_of(pugi::xml_node element) const {
    const std::ptrdiff_t offset = element.offset_debug();
    if (offset < 0) {
        return {};
    }
    const auto begin = static_cast<std::size_t>(offset);
    return {position(begin), position(begin + std::string_view(element.name()).size())};
}

// Its value: looked up behind the name of the element, past the values of the attributes before it.
diagnostic::Range Source::range_of(pugi::xml_node element, pugi::xml_attribute attribute) const {
    const std::ptrdiff_t offset = element.offset_debug();
    if (offset < 0) {
        return {};
    }
    std::size_t at = static_cast<std::size_t>(offset) + std::string_view(element.name()).size();
    for (pugi::xml_attribute each = element.first_attribute(); each; each = each.next_attribute()) {
        const std::size_t begin = text_.find_first_of("\"'", at);
        const std::size_t end = begin != std::string::npos ? text_.find(text_[begin], begin + 1) : begin;
        if (end == std::string::npos) {
            break;
        }
        if (each == attribute) {
            return {position(begin + 1), position(end)};
        }
        at = end + 1;
    }
    return range_of(element);
}

pugi::xml_node Source::child(pugi::xml_node of, std::string_view name) {
    return of.find_child([name](pugi::xml_node child) {
        return child.type() == pugi::node_element && local_name(child.name()) == name;
    });
}

}  // namespace cgw::xdd
