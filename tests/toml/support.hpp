// Short ways to parse and to say what came out.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <string_view>

#include "toml/document.hpp"

namespace cgw::test {

inline toml::Node parsed(std::string_view text) {
    diagnostic::Findings findings;
    std::optional<toml::Node> document = toml::parse(text, "f.toml", findings);
    for (const diagnostic::Diagnostic& finding : findings.all()) {
        ADD_FAILURE() << finding.where.range.start.line << ':' << finding.where.range.start.column << ": "
                      << finding.message;
    }
    return document.value_or(toml::Node{});
}

inline std::string show(const diagnostic::Range& range) {
    return fmt::format("{}:{}-{}:{}", range.start.line, range.start.column, range.end.line, range.end.column);
}

// "E0004 3:7 message", one line per finding; "fine" when there is none.
inline std::string findings_of(std::string_view text) {
    diagnostic::Findings findings;
    const bool ok = toml::parse(text, "f.toml", findings).has_value();
    if (findings.all().empty()) {
        return ok ? "fine" : "refused without a finding";
    }
    std::string result = ok ? "accepted in spite of: " : "";
    for (const diagnostic::Diagnostic& finding : findings.all()) {
        const auto& start = finding.where.range.start;
        result += fmt::format("{}{} {}:{} {}", result.empty() ? "" : "\n", finding.rule->code, start.line,
                              start.column, finding.message);
    }
    return result;
}

// The part of `text` that a range covers.
inline std::string slice(std::string_view text, const diagnostic::Range& range) {
    const auto offset = [&](const diagnostic::Position& position) {
        std::size_t at = 0;
        for (std::uint32_t line = 1; line < position.line; ++line) {
            at = text.find('\n', at) + 1;
        }
        return at + position.column - 1;
    };
    return std::string(text.substr(offset(range.start), offset(range.end) - offset(range.start)));
}

// The value under keys separated by '/'; a number selects an element of a list.
inline const toml::Node& at(const toml::Node& root, std::string_view path) {
    const std::size_t end = path.find('/');
    const std::string_view part = path.substr(0, end);
    const toml::Node* next = nullptr;
    if (root.kind == toml::Kind::array) {
        next = &root.elements.at(std::stoul(std::string(part)));
    } else if (const toml::Entry* entry = root.find(part)) {
        next = &entry->value;
    }
    if (next == nullptr) {
        throw std::runtime_error("no " + std::string(path));
    }
    return end == std::string_view::npos ? *next : at(*next, path.substr(end + 1));
}

}  // namespace cgw::test
