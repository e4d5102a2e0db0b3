// Findings as lines of text, for comparing in tests.
#pragma once

#include <fmt/format.h>

#include <string>

#include "diagnostic/diagnostic.hpp"

namespace cgw::test {

// "3:9 key-type: `width` is an integer, not a string", one line each.
inline std::string findings_text(const diagnostic::Findings& findings) {
    std::string text;
    for (const diagnostic::Diagnostic& finding : findings.all()) {
        const diagnostic::Position& place = finding.where.range.start;
        text += fmt::format("{}:{} {}: {}\n", place.line, place.column, finding.rule->name, finding.message);
    }
    return text;
}

}  // namespace cgw::test
