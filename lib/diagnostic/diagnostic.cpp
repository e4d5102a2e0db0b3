#include "diagnostic/diagnostic.hpp"

#include <algorithm>
#include <tuple>

namespace cgw::diagnostic {

std::size_t Findings::count(Level level) const {
    return static_cast<std::size_t>(std::count_if(
        all_.begin(), all_.end(), [level](const Diagnostic& finding) { return finding.level() == level; }));
}

bool Findings::has_errors() const {
    return count(Level::error) > 0;
}

void Findings::sort() {
    std::stable_sort(all_.begin(), all_.end(), [](const Diagnostic& a, const Diagnostic& b) {
        return std::tie(a.where, a.rule->code) < std::tie(b.where, b.rule->code);
    });
}

void Findings::hide(const std::vector<const Rule*>& rules) {
    std::erase_if(all_, [&](const Diagnostic& finding) {
        return finding.rule->level != Level::error &&
               std::find(rules.begin(), rules.end(), finding.rule) != rules.end();
    });
}

void Findings::promote_warnings() {
    for (Diagnostic& finding : all_) {
        finding.promoted = finding.promoted || finding.rule->level == Level::warning;
    }
}

void Findings::promote(const std::vector<const Rule*>& rules) {
    for (Diagnostic& finding : all_) {
        finding.promoted =
            finding.promoted || std::find(rules.begin(), rules.end(), finding.rule) != rules.end();
    }
}

}  // namespace cgw::diagnostic
