// A text checked as the file of that name, and its findings as lines.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "eds_check/checks.hpp"

namespace cgw::test {

inline diagnostic::Findings checked(const std::string& text, const std::string& name = "example.eds",
                                    eds_check::Options options = {}) {
    diagnostic::Findings findings;
    const eds::Document document(text);
    const eds::Sheet sheet = eds::read(document, name, findings, options.most_findings);
    options.file_name = options.file_name.empty() ? name : options.file_name;
    eds_check::check(document, sheet, name, options, findings);
    findings.sort();
    return findings;
}

// "12:5 warning E0850 eds-sub-number: message"
inline std::string as_lines(const diagnostic::Findings& findings) {
    std::string text;
    for (const diagnostic::Diagnostic& finding : findings.all()) {
        const diagnostic::Position& at = finding.where.range.start;
        text += fmt::format("{}:{} {} {} {}: {}\n", at.line, at.column, to_text(finding.level()),
                            finding.rule->code, finding.rule->name, finding.message);
    }
    return text;
}

inline std::size_t count_of(const diagnostic::Findings& findings, const diagnostic::Rule& rule) {
    return static_cast<std::size_t>(
        std::count_if(findings.all().begin(), findings.all().end(),
                      [&](const diagnostic::Diagnostic& finding) { return finding.rule == &rule; }));
}

}  // namespace cgw::test
