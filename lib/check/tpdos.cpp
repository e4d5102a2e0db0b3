// What TPDO4 to 16 carry and when they are sent (manual 7.1.2.2, 7.1.3): the two stand in different tables.
#include <fmt/format.h>

#include <utility>

#include "check/subjects.hpp"
#include "check/support.hpp"
#include "config/numbers.hpp"
#include "diagnostic/rules/notes.hpp"
#include "diagnostic/rules/warnings.hpp"

namespace cgw::check {

namespace {

using config::Decision;
using config::DecisionKind;
using parameter::Assignment;
using parameter::Device;
namespace governor = config::governor;
namespace rules = diagnostic::rules;

bool nothing_assigned(const Context& context, int tpdo) {
    for (int word = 1; word <= config::words_per_pdo; ++word) {
        if (!is_off(context, Device::governor, governor::tpdo_assignment_of(tpdo, word))) {
            return false;
        }
    }
    return true;
}

const Assignment* first_assigned(const Context& context, int tpdo) {
    for (int word = 1; word <= config::words_per_pdo; ++word) {
        const Assignment* assignment =
            sound(context, Device::governor, governor::tpdo_assignment_of(tpdo, word));
        if (assignment != nullptr && assignment->value != 0) {
            return assignment;
        }
    }
    return nullptr;
}

std::string measurement(const Context& context, const Assignment& assignment) {
    return label(context, Device::governor, static_cast<std::uint16_t>(assignment.value));
}

// True when every word that closes up is a 0; another one is an error, and so is what it leads to.
bool closes_up_over_zeros(const Context& context, int tpdo) {
    for (const Decision& decision : context.configuration.decisions) {
        if (decision.kind == DecisionKind::dropped && decision.pdo == tpdo &&
            !is_off(context, Device::governor, decision.parameter)) {
            return false;
        }
    }
    return true;
}

void report_closed_up(const Context& context, int tpdo) {
    const Assignment* place = nullptr;
    std::string moves;
    std::vector<diagnostic::Related> zeros;
    for (const Decision& decision : context.configuration.decisions) {
        const Assignment* assignment = usable(context, Device::governor, decision.parameter);
        if (decision.kind == DecisionKind::quantised || decision.pdo != tpdo || assignment == nullptr) {
            continue;
        }
        if (decision.kind == DecisionKind::dropped) {
            zeros.push_back(here(*assignment));
            continue;
        }
        place = place != nullptr ? place : assignment;
        moves += fmt::format("{}word {} ({}) is sent as word {}", moves.empty() ? "" : ", ",
                             decision.asked_word, measurement(context, *assignment), decision.actual_word);
    }
    if (place != nullptr) {
        context.findings.report(
            {.rule = &rules::tpdo_words_moved,
             .message = fmt::format("TPDO{} closes up over a 0: {} (manual 7.1.2.2)", tpdo, moves),
             .where = place->where,
             .related = std::move(zeros)});
    }
}

}  // namespace

void check_empty_tpdos(const Context& context) {
    for (int tpdo = config::first_analogue_tpdo; tpdo <= config::tpdo_count; ++tpdo) {
        const Assignment* cycle = sound(context, Device::governor, governor::tpdo_cycle_of(tpdo));
        if (cycle == nullptr || cycle->value == 0 || !nothing_assigned(context, tpdo)) {
            continue;
        }
        const std::uint16_t first = governor::tpdo_assignment_of(tpdo, 1);
        context.findings.report(
            {.rule = &rules::tpdo_empty,
             .message = fmt::format("{} is {}, but TPDO{} has nothing to send: {} to {} are 0 "
                                    "(manual 7.1.2.2)",
                                    parameter::label(*cycle->row), quantity(*cycle), tpdo, first,
                                    governor::tpdo_assignment_of(tpdo, config::words_per_pdo)),
             .where = cycle->where,
             .help = fmt::format("assign a measurement to {}, or write {} = 0", first, cycle->row->number)});
    }
}

void check_unsent_tpdos(const Context& context) {
    for (int tpdo = config::first_analogue_tpdo; tpdo <= config::tpdo_count; ++tpdo) {
        const std::uint16_t number = governor::tpdo_cycle_of(tpdo);
        const Assignment* word = first_assigned(context, tpdo);
        if (word == nullptr || !is_off(context, Device::governor, number)) {
            continue;
        }
        diagnostic::Diagnostic finding{
            .rule = &rules::tpdo_unsent,
            .message = fmt::format("{} is {}, but TPDO{} is never sent: {} is {} (manual 7.1.3)",
                                   parameter::label(*word->row), measurement(context, *word), tpdo,
                                   label(context, Device::governor, number),
                                   off_text(context, Device::governor, number)),
            .where = word->where,
            .help = fmt::format("write its cycle time in ms as {}", number)};
        if (const Assignment* cycle = usable(context, Device::governor, number)) {
            finding.related = {here(*cycle)};
        }
        context.findings.report(std::move(finding));
    }
}

void check_closed_up_words(const Context& context) {
    for (int tpdo = config::first_analogue_tpdo; tpdo <= config::tpdo_count; ++tpdo) {
        if (closes_up_over_zeros(context, tpdo)) {
            report_closed_up(context, tpdo);
        }
    }
}

}  // namespace cgw::check
