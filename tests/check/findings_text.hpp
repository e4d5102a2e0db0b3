// Findings as text, one a line: "12:8 E0201 hzm-node-mismatch: message", related places below it.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "check/checks.hpp"
#include "diagnostic/rules.hpp"
#include "support/plant_builder.hpp"

namespace cgw::test {

inline std::string findings_text(const diagnostic::Findings& findings, bool with_help = true) {
    std::string text;
    for (const diagnostic::Diagnostic& finding : findings.all()) {
        const auto& start = finding.where.range.start;
        text += fmt::format("{}:{} {} {}: {}\n", start.line, start.column, finding.rule->code,
                            finding.rule->name, finding.message);
        for (const diagnostic::Related& related : finding.related) {
            text += fmt::format("  see {}:{}: {}\n", related.where.range.start.line,
                                related.where.range.start.column, related.message);
        }
        if (with_help && !finding.help.empty()) {
            text += fmt::format("  help: {}\n", finding.help);
        }
    }
    return text;
}

inline std::string checked(PlantBuilder& plant) {
    diagnostic::Findings findings;
    const config::Configuration configuration = plant.resolve();
    check::check({plant.settings(), plant.catalogue(), configuration, findings});
    findings.sort();
    return findings_text(findings);
}

// The errors alone: a plant made for one error need not be complete otherwise.
inline std::string errors_of(PlantBuilder& plant) {
    diagnostic::Findings findings;
    const config::Configuration configuration = plant.resolve();
    check::check({plant.settings(), plant.catalogue(), configuration, findings});
    std::vector<const diagnostic::Rule*> others;
    for (const diagnostic::Rule* rule : diagnostic::all_rules()) {
        others.push_back(rule);
    }
    findings.hide(others);
    findings.sort();
    return findings_text(findings);
}

}  // namespace cgw::test
