#include "eds_check/fix.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "eds/edit.hpp"
#include "eds_check/context.hpp"

namespace cgw::eds_check {
namespace {

// Repairs that only become possible by others come in a further round; there are few such chains.
constexpr int most_rounds = 32;

// Findings of one rule in one round.
constexpr std::size_t most_per_round = 300'000;

Span span_of(const eds::Document& document, const diagnostic::Range& range) {
    const std::uint32_t line = range.start.line - 1;
    const std::uint32_t begin = document.lines()[line].begin;
    return {line, begin + range.start.column - 1, begin + range.end.column - 1};
}

// One text, its findings, and the repairs that its findings allow for at once.
class Round {
  public:
    Round(const std::string& text, const std::string& path, const Options& options)
        : document_(text),
          sheet_(eds::read(document_, path, findings_, options.most_findings)),
          path_(path),
          options_(options) {
        check(document_, sheet_, path, options, findings_);
        findings_.sort();
    }

    diagnostic::Findings doubts() const {
        diagnostic::Findings doubts;
        for (const diagnostic::Diagnostic& finding : findings_.all()) {
            const Check* const row = find_check(finding.rule);
            if (row != nullptr && row->doubtful) {
                doubts.report(finding);
            }
        }
        return doubts;
    }

    // Calls `take(finding, repair)` for each finding that can be mended; of a line once.
    template <typename Take>
    void repairs(Take take) const {
        diagnostic::Findings unused;
        eds::Reading reading(document_, sheet_.sections, path_, unused, 0);
        const Model model(document_, sheet_);
        const Context context{reading, document_, sheet_, model, options_};
        std::set<std::uint32_t> lines;
        std::map<const Check*, std::uint32_t> waiting;  // the last line that a repair of the rule is about
        for (const diagnostic::Diagnostic& finding : findings_.all()) {
            const Check* const row = find_check(finding.rule);
            if (row == nullptr || row->repair == nullptr || finding.where.range.start.line == 0) {
                continue;
            }
            // A repair of many lines mends other findings as well, or has to wait for the next round with
            // all.
            const std::uint32_t line = finding.where.range.start.line - 1;
            const auto waits = waiting.find(row);
            if (lines.contains(line) || (waits != waiting.end() && line <= waits->second)) {
                continue;
            }
            const auto repair = row->repair(context, span_of(document_, finding.where.range));
            if (repair && !repair->changes.empty()) {
                waiting[row] = repair->changes.back().span.line;
            }
            if (repair && std::none_of(repair->changes.begin(), repair->changes.end(),
                                       [&](const Change& c) { return lines.contains(c.span.line); })) {
                for (const Change& change : repair->changes) {
                    lines.insert(change.span.line);
                }
                take(finding, *repair);
            }
        }
    }

    const eds::Document& document() const { return document_; }

  private:
    eds::Document document_;
    diagnostic::Findings findings_;
    eds::Sheet sheet_;
    const std::string& path_;
    const Options& options_;
};

// Which line of the text as it was each line of the present one is; lines that were added are the one before.
class Origins {
  public:
    explicit Origins(std::size_t lines) {
        for (std::size_t line = 0; line < lines; ++line) {
            lines_.push_back(static_cast<std::uint32_t>(line));
        }
    }

    diagnostic::Location of(diagnostic::Location where) const {
        const std::uint32_t line = lines_[where.range.start.line - 1] + 1;
        where.range.start.line = line;
        where.range.end.line = line;
        return where;
    }

    // Changes of one round.
    void take(std::vector<Change> changes) {
        std::stable_sort(changes.begin(), changes.end(),
                         [](const Change& a, const Change& b) { return a.span.line < b.span.line; });
        std::vector<std::uint32_t> lines;
        auto change = changes.begin();
        for (std::uint32_t line = 0; line < lines_.size(); ++line) {
            bool stays = true;
            std::size_t added = 0;
            for (; change != changes.end() && change->span.line == line; ++change) {
                stays = stays && change->kind != Change::Kind::remove_line;
                added += change->kind == Change::Kind::insert_after ? 1U : 0U;
            }
            lines.insert(lines.end(), added + (stays ? 1U : 0U), lines_[line]);
        }
        lines_ = std::move(lines);
    }

  private:
    std::vector<std::uint32_t> lines_;
};

void apply(const Change& change, eds::Edits& edits) {
    switch (change.kind) {
        case Change::Kind::replace:
            return edits.replace(change.span, change.text);
        case Change::Kind::remove_line:
            return edits.remove(change.span.line);
        case Change::Kind::insert_after:
            return edits.insert_after(change.span.line, change.text);
    }
}

}  // namespace

Fixed fix(std::string text, const std::string& path, const Options& given) {
    Options options = given;
    options.most_findings = most_per_round;
    Fixed fixed{text, {}, {}};
    std::optional<Origins> origins;
    for (int number = 0; number < most_rounds; ++number) {
        const Round round(fixed.text, path, options);
        if (diagnostic::Findings doubts = round.doubts(); !doubts.all().empty()) {
            return {std::move(text), {}, std::move(doubts)};
        }
        if (!origins) {
            origins.emplace(round.document().lines().size());
        }
        eds::Edits edits(round.document());
        std::vector<Change> changes;
        round.repairs([&](const diagnostic::Diagnostic& finding, const Repair& repair) {
            for (const Change& change : repair.changes) {
                apply(change, edits);
                changes.push_back(change);
            }
            fixed.repairs.push_back({finding.rule, origins->of(finding.where), repair.what});
        });
        if (edits.empty()) {
            break;
        }
        fixed.text = edits.apply();
        origins->take(std::move(changes));
    }
    std::stable_sort(fixed.repairs.begin(), fixed.repairs.end(),
                     [](const Repaired& a, const Repaired& b) { return a.where < b.where; });
    return fixed;
}

}  // namespace cgw::eds_check
