#include <fmt/format.h>

#include <algorithm>

#include "base/canopen_text.hpp"
#include "compare/consequences.hpp"
#include "config/numbers.hpp"

namespace cgw::compare {
namespace {

using config::MappedWord;
using config::Pdo;
using config::WordKind;

bool has_time(const Pdo& pdo) {
    return pdo.direction == config::Direction::receive || pdo.number >= config::first_analogue_tpdo;
}

std::string pdo_time_text(const Pdo& pdo) {
    const bool is_unmonitored = pdo.time.effective_us == 0 && pdo.direction == config::Direction::receive;
    return is_unmonitored ? "not monitored" : time_text(pdo.time);
}

std::string summary(const Pdo& pdo) {
    if (!pdo.active) {
        return "inactive";
    }
    return fmt::format("{}, {} bytes{}", base::identifier_text(pdo.cob_id), pdo.length(),
                       has_time(pdo) ? ", " + pdo_time_text(pdo) : "");
}

std::string label(const MappedWord& word) {
    switch (word.kind) {
        case WordKind::dummy:
            return "dummy";
        case WordKind::errors:
            return fmt::format("error bits {}", word.sub_index);
        case WordKind::engine_state:
            return "engine state";
        case WordKind::switches:
            return "switch functions";
        case WordKind::sensor_flags:
            return "sensor error flags";
        case WordKind::measurement:
            return parameter::label(*word.parameter);
        case WordKind::sensor:
            return word.parameter != nullptr ? parameter::label(*word.parameter)
                                             : fmt::format("channel {}", word.sub_index);
    }
    return "";
}

std::string label_at(const Pdo& pdo, std::size_t position) {
    return position < pdo.mapping.size() ? label(pdo.mapping[position]) : "nothing";
}

// ", before in word 3" where the word stood elsewhere in the same PDO.
std::string where_before(const Pdo& before, const Pdo& now, std::size_t position) {
    const std::string text = label_at(now, position);
    for (std::size_t i = 0; i < before.mapping.size(); ++i) {
        const bool is_moved =
            i != position && text != "dummy" && label(before.mapping[i]) == text && label_at(now, i) != text;
        if (is_moved) {
            return fmt::format(", moved from word {}", i + 1);
        }
    }
    return "";
}

void compare_pdo(const Pdo& a, const Pdo& b, Differences& differences) {
    const std::string name = a.name();
    if (!a.active || !b.active) {
        note(differences, "pdo", name, summary(a), summary(b));
        return;
    }
    note(differences, "pdo-identifier", name + " identifier", base::identifier_text(a.cob_id),
         base::identifier_text(b.cob_id));
    if (has_time(a)) {
        const bool transmits = a.direction == config::Direction::transmit;
        note(differences, "pdo-time", fmt::format("{} {}", name, transmits ? "cycle" : "monitoring"),
             pdo_time_text(a), pdo_time_text(b));
    }
    for (std::size_t i = 0; i < std::max(a.mapping.size(), b.mapping.size()); ++i) {
        const std::string before = label_at(a, i);
        const std::string now = label_at(b, i);
        if (before != now) {
            note(differences, "pdo-word", fmt::format("{} word {}", name, i + 1), before,
                 now + where_before(a, b, i));
        }
    }
}

}  // namespace

void compare_pdos(const config::Configuration& a, const config::Configuration& b, Differences& differences) {
    for (std::size_t i = 0; i < a.pdos.size(); ++i) {
        compare_pdo(a.pdos[i], b.pdos[i], differences);
    }
}

}  // namespace cgw::compare
