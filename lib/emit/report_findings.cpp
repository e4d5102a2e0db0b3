#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <tuple>

#include "diagnostic/rules/network.hpp"
#include "diagnostic/rules/notes.hpp"
#include "emit/report_parts.hpp"
#include "parameter/value_text.hpp"

namespace cgw::emit {
namespace {

using diagnostic::Diagnostic;
using page::Tone;

constexpr std::array<Tone, 3> tones{Tone::bad, Tone::warning, Tone::plain};  // of error, warning, note

// Those about the plant and its bus, the gravest first. How the file spells its numbers and in which order is
// no matter of the plant; that the bit rate is not known stands with the bus.
std::vector<const Diagnostic*> by_weight(std::span<const Diagnostic> of_plant, const network::Judged& bus) {
    std::vector<const Diagnostic*> sorted;
    for (const std::span<const Diagnostic> findings : {of_plant, std::span(bus.findings.all())}) {
        for (const Diagnostic& finding : findings) {
            if (finding.rule != &diagnostic::rules::manual_misprint &&
                finding.rule != &diagnostic::rules::bus_bit_rate_unknown) {
                sorted.push_back(&finding);
            }
        }
    }
    std::stable_sort(sorted.begin(), sorted.end(), [](const Diagnostic* a, const Diagnostic* b) {
        return std::tuple(a->level(), a->rule->code, std::string_view(a->message)) <
               std::tuple(b->level(), b->rule->code, std::string_view(b->message));
    });
    return sorted;
}

std::string change_text(const parameter::Row& row, double value) {
    return parameter::value_text(row, value);
}

}  // namespace

std::string counted(std::size_t count, std::string_view what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

void add_findings(const Plant& plant, const network::Judged& bus, Blocks& blocks, Judgement& judgement) {
    const std::vector<const Diagnostic*> findings = by_weight(plant.findings, bus);
    std::array<std::size_t, 3> counts{};
    for (const Diagnostic* const finding : findings) {
        ++counts[static_cast<std::size_t>(finding->level())];
    }
    const auto [errors, warnings, notes] = counts;
    judgement.add(errors > 0     ? Tone::bad
                  : warnings > 0 ? Tone::warning
                                 : Tone::good,
                  fmt::format("checks: {}, {}, {}", errors > 0 ? counted(errors, "error") : "no errors",
                              counted(warnings, "warning"), counted(notes, "note")));
    blocks.emplace_back(page::Heading{2, "Findings"});
    if (findings.empty()) {
        blocks.emplace_back(page::Paragraph{"No check has anything to say."});
        return;
    }
    page::Table table{
        "What the checks found", {{"Level"}, {"Finding"}, {"What to do, or why"}, {"Rule"}}, {}};
    for (const Diagnostic* const finding : findings) {
        const Tone tone = tones[static_cast<std::size_t>(finding->level())];
        table.rows.push_back(
            {{std::string(to_text(finding->level())), tone},
             finding->message,
             finding->help.empty() ? std::string(finding->rule->why) : finding->help,
             fmt::format("{} {}: {}", finding->rule->code, finding->rule->name, finding->rule->reference)});
    }
    blocks.emplace_back(std::move(table));
}

void add_not_verified(const Plant& plant, Blocks& blocks, Judgement& judgement) {
    if (plant.not_verified.empty()) {
        return;
    }
    judgement.reasons.push_back(
        fmt::format("{} nobody can check from here", counted(plant.not_verified.size(), "point")));
    blocks.emplace_back(page::Heading{2, "What no check can know"});
    blocks.emplace_back(page::Items{false, {plant.not_verified.begin(), plant.not_verified.end()}});
}

void add_changes(const Plant& plant, Blocks& blocks) {
    if (plant.against == nullptr) {
        return;
    }
    const compare::Comparison& changes = *plant.against;
    blocks.emplace_back(page::Heading{2, "Changes"});
    if (changes.same()) {
        blocks.emplace_back(page::Paragraph{fmt::format("Nothing differs from {}.", plant.against_name)});
        return;
    }
    blocks.emplace_back(page::Paragraph{fmt::format("Compared with {}.", plant.against_name)});
    if (!changes.parameters.empty()) {
        page::Table table{"Parameters to type again",
                          {{"Device"}, {"Number", true}, {"Parameter"}, {"Before", true}, {"Now", true}},
                          {}};
        for (const compare::ParameterDifference& difference : changes.parameters) {
            const parameter::Row& row = *difference.row;
            table.rows.push_back({std::string(parameter::to_text(row.device)), std::to_string(row.number),
                                  std::string(row.name), change_text(row, difference.a),
                                  change_text(row, difference.b)});
        }
        blocks.emplace_back(std::move(table));
    }
    page::Table table{"What follows from it", {{"What"}, {"Before"}, {"Now"}}, {}};
    for (const auto* differences : {&changes.consequences, &changes.otherwise}) {
        for (const compare::Difference& difference : *differences) {
            table.rows.push_back({difference.subject, difference.a, difference.b});
        }
    }
    if (!table.rows.empty()) {
        blocks.emplace_back(std::move(table));
    }
}

}  // namespace cgw::emit
