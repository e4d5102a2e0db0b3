#include <algorithm>

#include <fmt/format.h>

#include "explain/entries.hpp"

namespace cgw::explain {

namespace {

std::vector<std::string> lines_of(std::string_view text) {
    std::vector<std::string> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

}  // namespace

Entry rule_entry(const diagnostic::Rule& rule) {
    Entry entry{
        "check", fmt::format("{} {} ({})", rule.code, rule.name, diagnostic::to_text(rule.level)), {}};
    entry.add("demands", rule.summary);
    entry.add("why", rule.why);
    entry.add("bad", lines_of(rule.bad), Style::verbatim);
    entry.add("good", lines_of(rule.good), Style::verbatim);
    if (rule.level != diagnostic::Level::error) {
        entry.add("to hide", fmt::format("-W no-{}", rule.name));
    }
    entry.add("source", rule.reference);
    return entry;
}

Entry abort_code_entry(const base::AbortCodeRow& row) {
    Entry entry{"abort code", fmt::format("SDO abort code 0x{:08X}", row.code), {}};
    entry.add("meaning", row.meaning);
    entry.add("gateway",
              row.gateway.empty() ? "does not send it" : fmt::format("sends it for {}", row.gateway));
    entry.add("action", row.action);
    entry.add("source", row.gateway.empty() ? "CiA 301" : "CiA 301, GWM 5.2, D51");
    return entry;
}

}  // namespace cgw::explain
