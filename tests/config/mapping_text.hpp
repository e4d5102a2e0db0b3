// A mapping as text: "2001:1 2001:2", "dummy" for 0006h.
#pragma once

#include <fmt/format.h>

#include <string>

#include "config/configuration.hpp"

namespace cgw::test {

inline std::string mapping_text(const config::Pdo& pdo) {
    std::string text;
    for (const config::MappedWord& word : pdo.mapping) {
        text += text.empty() ? "" : " ";
        text += word.kind == config::WordKind::dummy ? "dummy"
                                                     : fmt::format("{:04X}:{}", word.index, word.sub_index);
    }
    return text;
}

// "dropped 16401 2; moved 16402 3->2; quantised 16460 100"
inline std::string decision_text(const config::Configuration& configuration) {
    std::string text;
    for (const config::Decision& decision : configuration.decisions) {
        text += text.empty() ? "" : "; ";
        switch (decision.kind) {
            case config::DecisionKind::dropped:
                text += fmt::format("dropped {} {}", decision.parameter, decision.asked_word);
                break;
            case config::DecisionKind::moved:
                text += fmt::format("moved {} {}->{}", decision.parameter, decision.asked_word,
                                    decision.actual_word);
                break;
            case config::DecisionKind::quantised:
                text += fmt::format("quantised {} {} ms to {} us", decision.parameter, decision.time.asked_ms,
                                    decision.time.effective_us);
                break;
        }
    }
    return text;
}

}  // namespace cgw::test
