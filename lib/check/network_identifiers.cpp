// Whose identifiers an active PDO meets beyond the gateway's own (D33): those CiA 301 restricts, and those
// that the other nodes of the bus have by default.
#include <fmt/format.h>

#include <algorithm>

#include "check/identifiers.hpp"
#include "check/support.hpp"
#include "config/numbers.hpp"
#include "diagnostic/rules/notes.hpp"
#include "diagnostic/rules/plant.hpp"
#include "diagnostic/rules/warnings.hpp"

namespace cgw::check {

namespace {

using config::Pdo;
using diagnostic::Diagnostic;
namespace cob = facts::cob;
namespace rules = diagnostic::rules;

struct Owned {
    std::uint16_t base;
    std::string_view purpose;
};

// What another node sends, and where its SDO server listens.
constexpr Owned owned_identifiers[] = {
    {cob::emergency, "its emergency messages"},
    {cob::tpdo[0], "its TPDO1"},
    {cob::tpdo[1], "its TPDO2"},
    {cob::tpdo[2], "its TPDO3"},
    {cob::tpdo[3], "its TPDO4"},
    {cob::sdo_answer, "its SDO answers"},
    {cob::sdo_request, "SDO requests to it"},
    {cob::heartbeat, "its heartbeat"},
};

// What another node receives by default.
struct Received {
    std::uint16_t base;
    int rpdo;
};

constexpr Received received_identifiers[] = {
    {cob::rpdo[0], 1}, {cob::rpdo[1], 2}, {cob::rpdo[2], 3}, {cob::rpdo[3], 4}};

// The node whose identifier this is, 0 for none: `identifier` minus a base of the table.
template <typename Row>
std::uint16_t node_of(const Row& row, std::uint16_t identifier) {
    const int node = identifier - row.base;
    return static_cast<std::uint16_t>(node >= 1 && node <= facts::maximum_node_id ? node : 0);
}

// The row of the table that gives the identifier to another node than the gateway, or nullptr.
template <typename Table>
const auto* find_row(const Context& context, const Table& table, std::uint16_t identifier) {
    const auto* const row = std::find_if(std::begin(table), std::end(table), [&](const auto& candidate) {
        const std::uint16_t node = node_of(candidate, identifier);
        return node != 0 && node != context.configuration.node_id;
    });
    return row != std::end(table) ? row : nullptr;
}

}  // namespace

std::optional<Diagnostic> judge_foreign(const Context& context, const Pdo& pdo) {
    for (const parameter::NetworkNode& node : context.settings.network_nodes) {
        const auto* const owned =
            std::find_if(std::begin(owned_identifiers), std::end(owned_identifiers),
                         [&](const Owned& row) { return pdo.cob_id == row.base + node.node_id; });
        // The gateway's own node id in the list is another finding.
        if (owned == std::end(owned_identifiers) || node.node_id == context.configuration.node_id) {
            continue;
        }
        Diagnostic finding = finding_at(context, pdo, rules::cob_id_foreign);
        finding.message =
            fmt::format("{} is {}, which belongs to node {} for {}", identifier_label(context, pdo),
                        identifier_text(pdo.cob_id), node.node_id, owned->purpose);
        finding.related = {
            {.where = node.where, .message = fmt::format("node {} is listed here", node.node_id)}};
        return finding;
    }
    return std::nullopt;
}

std::optional<Diagnostic> judge_restricted(const Context& context, const Pdo& pdo) {
    const auto* const range =
        std::find_if(std::begin(facts::restricted_identifiers), std::end(facts::restricted_identifiers),
                     [&](const facts::RestrictedIdentifiers& row) {
                         return pdo.cob_id >= row.first && pdo.cob_id <= row.last;
                     });
    if (range == std::end(facts::restricted_identifiers) || is_in_doubt(context, pdo)) {
        return std::nullopt;
    }
    Diagnostic finding = finding_at(context, pdo, rules::cob_id_restricted);
    finding.message =
        fmt::format("{} is {}, in the range {} to {} that CiA 301 {}", identifier_label(context, pdo),
                    identifier_text(pdo.cob_id), identifier_text(range->first), identifier_text(range->last),
                    range->purpose);
    return finding;
}

std::optional<Diagnostic> judge_unlisted_owner(const Context& context, const Pdo& pdo) {
    const Owned* owned = find_row(context, owned_identifiers, pdo.cob_id);
    if (owned == nullptr || is_in_doubt(context, pdo)) {
        return std::nullopt;
    }
    Diagnostic finding = finding_at(context, pdo, rules::cob_id_unlisted_owner);
    const std::uint16_t node = node_of(*owned, pdo.cob_id);
    finding.message =
        fmt::format("{} is {}, which belongs to node {} for {}, if there is such a node",
                    identifier_label(context, pdo), identifier_text(pdo.cob_id), node, owned->purpose);
    finding.help += "; or list the nodes of the bus in [network]";
    return finding;
}

std::optional<Diagnostic> judge_default_rpdo(const Context& context, const Pdo& pdo) {
    const Received* received = find_row(context, received_identifiers, pdo.cob_id);
    if (received == nullptr || is_in_doubt(context, pdo)) {
        return std::nullopt;
    }
    Diagnostic finding = finding_at(context, pdo, rules::cob_id_default_rpdo);
    finding.message =
        fmt::format("{} is {}, received by node {}\'s default RPDO{}", identifier_label(context, pdo),
                    identifier_text(pdo.cob_id), node_of(*received, pdo.cob_id), received->rpdo);
    finding.help.clear();
    return finding;
}

}  // namespace cgw::check
