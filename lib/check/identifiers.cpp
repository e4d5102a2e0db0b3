// The identifiers of all active PDOs (manual 7.3, D33). Only TPDO5..16 can be wrong: the predefined ones
// differ from each other and from everything reserved by their construction. Each PDO is judged once, by
// the first judge that objects.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "check/identifiers.hpp"
#include "check/subjects.hpp"
#include "check/support.hpp"
#include "config/numbers.hpp"
#include "diagnostic/rules/notes.hpp"
#include "diagnostic/rules/plant.hpp"
#include "diagnostic/rules/warnings.hpp"

namespace cgw::check {

namespace {

using config::Configuration;
using config::Pdo;
using diagnostic::Diagnostic;
using parameter::Assignment;
using parameter::Device;
namespace cob = facts::cob;
namespace gateway = config::gateway;
namespace rules = diagnostic::rules;

struct Reserved {
    std::uint16_t base;
    std::uint16_t parameter;            // that says whose node id is added; 0: nobody's
    std::uint8_t Configuration::*node;  // that node id, or null
    std::string_view purpose;
};

constexpr Reserved reserved_identifiers[] = {
    {cob::nmt, 0, nullptr, "NMT commands"},
    {cob::sync, 0, nullptr, "SYNC"},
    {cob::time, 0, nullptr, "TIME"},
    {cob::sdo_answer, gateway::node_id, &Configuration::node_id, "the gateway's SDO answers"},
    {cob::sdo_request, gateway::node_id, &Configuration::node_id, "SDO requests to the gateway"},
    {cob::heartbeat, gateway::node_id, &Configuration::node_id, "the gateway's heartbeat"},
    {cob::heartbeat, gateway::partner_node_id, &Configuration::partner_node_id, "the partner's heartbeat"},
};

// From the free pool, a different one for each TPDO.
std::string free_identifier_help(const Context& context, const Pdo& pdo) {
    constexpr std::uint16_t count = facts::last_free_identifier - facts::first_free_identifier + 1;
    const auto& pdos = context.configuration.pdos;
    for (std::uint16_t step = 0; step < count; ++step) {
        const auto offset =
            static_cast<std::uint16_t>(pdo.number - gateway::first_tpdo_of_own_identifier + step);
        const auto candidate = static_cast<std::uint16_t>(facts::first_free_identifier + offset % count);
        if (std::none_of(pdos.begin(), pdos.end(), [&](const Pdo& p) { return p.cob_id == candidate; })) {
            return fmt::format("0x{:X} is free: write {} = 0x{:X}", candidate, identifier_parameter(pdo),
                               candidate);
        }
    }
    return {};
}

std::optional<Diagnostic> judge_absent(const Context& context, const Pdo& pdo) {
    if (!absent(context, Device::gateway, identifier_parameter(pdo))) {
        return std::nullopt;
    }
    Diagnostic finding = finding_at(context, pdo, rules::cob_id_reserved);
    finding.message = fmt::format(
        "{} is active, but {} is not set; without it the identifier is 000h, reserved for NMT "
        "commands (manual 7.3)",
        pdo.name(), identifier_label(context, pdo));
    const std::uint16_t cycle = config::governor::tpdo_cycle_of(pdo.number);
    if (const Assignment* assignment = usable(context, Device::governor, cycle)) {
        finding.related = {here(*assignment)};
    }
    return finding;
}

std::optional<Diagnostic> judge_reserved(const Context& context, const Pdo& pdo) {
    const Configuration& configuration = context.configuration;
    for (const Reserved& reserved : reserved_identifiers) {
        const unsigned node = reserved.node == nullptr ? 0U : configuration.*reserved.node;
        if ((reserved.node != nullptr && node == 0) || pdo.cob_id != reserved.base + node) {
            continue;
        }
        Diagnostic finding = finding_at(context, pdo, rules::cob_id_reserved);
        finding.message =
            fmt::format("{} is {}, reserved for {} (manual 7.3)", identifier_label(context, pdo),
                        identifier_text(pdo.cob_id), reserved.purpose);
        if (const Assignment* source = usable(context, Device::gateway, reserved.parameter)) {
            finding.related = {here(*source)};
        }
        return finding;
    }
    return std::nullopt;
}

// The predefined PDOs come first, then TPDO5..16 in order.
bool comes_before(const Pdo& one, const Pdo& other) {
    return one.cob_id_source == config::CobIdSource::predefined || one.number < other.number;
}

diagnostic::Related identifier_source(const Context& context, const Pdo& pdo) {
    const bool predefined = pdo.cob_id_source == config::CobIdSource::predefined;
    const std::uint16_t number = predefined ? gateway::node_id : identifier_parameter(pdo);
    const Assignment* source = usable(context, Device::gateway, number);
    return {.where = source != nullptr ? source->where : context.settings.gateway_table,
            .message = fmt::format("{} has {} from {} here", pdo.name(), identifier_text(pdo.cob_id),
                                   owned_label(context, Device::gateway, number))};
}

std::optional<Diagnostic> judge_duplicate(const Context& context, const Pdo& pdo) {
    const auto& pdos = context.configuration.pdos;
    const auto* const earlier = std::find_if(pdos.begin(), pdos.end(), [&](const Pdo& other) {
        return other.active && other.cob_id == pdo.cob_id && &other != &pdo && comes_before(other, pdo);
    });
    if (earlier == pdos.end()) {
        return std::nullopt;
    }
    Diagnostic finding = finding_at(context, pdo, rules::cob_id_duplicate);
    finding.message =
        fmt::format("{} is {}, which {} uses already (manual 7.3)", identifier_label(context, pdo),
                    identifier_text(pdo.cob_id), earlier->name());
    finding.related = {identifier_source(context, *earlier)};
    return finding;
}

// Errors first, notes last.
constexpr std::optional<Diagnostic> (*judges[])(const Context&, const Pdo&) = {
    judge_reserved,   judge_duplicate,      judge_foreign,
    judge_restricted, judge_unlisted_owner, judge_default_rpdo,
};

std::optional<Diagnostic> judge(const Context& context, const Pdo& pdo) {
    if (usable(context, Device::gateway, identifier_parameter(pdo)) == nullptr) {
        return judge_absent(context, pdo);
    }
    for (const auto& judge_one : judges) {
        std::optional<Diagnostic> finding = judge_one(context, pdo);
        if (finding) {
            return finding;
        }
    }
    return std::nullopt;
}

void report(const Context& context, const diagnostic::Rule& rule) {
    for (const Pdo& pdo : context.configuration.pdos) {
        if (!pdo.active || pdo.cob_id_source != config::CobIdSource::parameter) {
            continue;
        }
        std::optional<Diagnostic> finding = judge(context, pdo);
        if (finding && finding->rule == &rule) {
            context.findings.report(std::move(*finding));
        }
    }
}

}  // namespace

std::uint16_t identifier_parameter(const Pdo& pdo) {
    return gateway::tpdo_identifier_of(pdo.number);
}

Diagnostic finding_at(const Context& context, const Pdo& pdo, const diagnostic::Rule& rule) {
    const Assignment* assignment = usable(context, Device::gateway, identifier_parameter(pdo));
    return {.rule = &rule,
            .message = {},
            .where = assignment != nullptr ? assignment->where : context.settings.gateway_table,
            .help = free_identifier_help(context, pdo)};
}

std::string identifier_label(const Context& context, const Pdo& pdo) {
    return label(context, Device::gateway, identifier_parameter(pdo));
}

bool is_in_doubt(const Context& context, const Pdo& pdo) {
    const Assignment* assignment = usable(context, Device::gateway, identifier_parameter(pdo));
    return assignment != nullptr && decimal_in_doubt(*assignment);
}

void check_reserved_identifiers(const Context& context) {
    report(context, rules::cob_id_reserved);
}
void check_duplicate_identifiers(const Context& context) {
    report(context, rules::cob_id_duplicate);
}
void check_foreign_identifiers(const Context& context) {
    report(context, rules::cob_id_foreign);
}

void check_restricted_identifiers(const Context& context) {
    report(context, rules::cob_id_restricted);
}
void check_unlisted_owners(const Context& context) {
    report(context, rules::cob_id_unlisted_owner);
}
void check_default_rpdos(const Context& context) {
    report(context, rules::cob_id_default_rpdo);
}

}  // namespace cgw::check
