// CAN identifiers (COB-IDs) of the device: their form, whose they are, and whether two share one.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "diagnostic/rules/eds_check.hpp"
#include "eds_check/context.hpp"
#include "eds_check/standard_objects.hpp"
#include "eds_check/subjects.hpp"
#include "facts/identifiers.hpp"

namespace cgw::eds_check {
namespace {

namespace rules = diagnostic::rules;
using base::identifier_text;
using dictionary::Value;
using dictionary::Variable;

constexpr std::uint32_t bit_31 = 0x80000000;
constexpr std::uint32_t extended_frame = 0x20000000;  // bit 29
constexpr std::uint32_t extended_mask = 0x1FFFFFFF;
constexpr std::uint8_t highest_node = 127;

// Objects that hold an identifier.
struct UserRow {
    IndexRange range;
    std::uint8_t sub_index;
    bool sub_object;     // false: the object itself is the variable
    bool off_by_bit_31;  // which says that it is not in use
    bool receives_only;  // two receivers of one identifier are in order
    bool follows_node;   // by CiA 301, when it is a base of its table
    std::string_view name;
};
constexpr std::array user_rows{
    UserRow{{0x1005, 0x1005}, 0, false, false, true, false, "SYNC"},
    UserRow{{0x1012, 0x1012}, 0, false, false, true, false, "TIME"},
    UserRow{{0x1014, 0x1014}, 0, false, true, false, true, "EMCY"},
    UserRow{{0x1201, sdo_servers.last}, 1, true, true, true, true, "SDO server, requests"},
    UserRow{{0x1201, sdo_servers.last}, 2, true, true, false, true, "SDO server, answers"},
    UserRow{sdo_clients, 1, true, true, false, true, "SDO client, requests"},
    UserRow{sdo_clients, 2, true, true, true, true, "SDO client, answers"},
    UserRow{receive_communication, 1, true, true, true, true, "RPDO"},
    UserRow{transmit_communication, 1, true, true, false, true, "TPDO"},
};

// CiA 301 version 4.2: identifiers that no PDO, SYNC, TIME, EMCY or further SDO may have.
struct Restricted {
    std::uint32_t first;
    std::uint32_t last;
    std::string_view why;  // "identifier 123h, which ..."
};
constexpr std::array restricted{
    Restricted{0x000, 0x000, "is for NMT commands"},
    Restricted{0x001, 0x07F, "CiA 301 forbids since version 4.2"},
    Restricted{0x101, 0x180, "is for safety objects (SRDO)"},
    Restricted{0x581, 0x5FF, "is for answers of SDO servers"},
    Restricted{0x601, 0x67F, "is for requests to SDO servers"},
    Restricted{0x6E0, 0x6FF, "CiA 301 forbids since version 4.2"},
    Restricted{0x701, 0x77F, "is for heartbeat and boot-up"},
    Restricted{0x780, 0x7FF, "is for LSS and others"},
};

struct User {
    const Group* group;
    const UserRow* row;
    std::uint8_t sub_index;
    Value value;
};

const UserRow* row_of(std::uint16_t index, std::uint8_t sub_index) {
    const auto* const row = std::find_if(user_rows.begin(), user_rows.end(), [&](const UserRow& each) {
        return each.range.contains(index) && each.sub_index == sub_index;
    });
    return row != user_rows.end() ? row : nullptr;
}

std::string name_of(const User& user) {
    const IndexRange& range = user.row->range;
    return range.first == range.last
               ? std::string(user.row->name)
               : fmt::format("{}{}{}", user.row->name, user.row->name.size() > 4 ? " " : "",
                             user.group->index - range.first + 1);
}

// Calls `take(user)` for each identifier whose value is stated and in use.
template <typename Take>
void for_each_user(const Context& context, Take take) {
    for (const Group& group : context.model.groups()) {
        if (group.object == nullptr || !group.has_section) {
            continue;
        }
        const bool has_sub = object::has_sub_objects(group.object->code);
        for (const Variable& variable : group.object->variables) {
            const UserRow* const row = row_of(group.index, variable.sub_index);
            const Value* const value = value_of(variable);
            if (row == nullptr || value == nullptr || row->sub_object != has_sub ||
                !dictionary::is_numeric(dictionary::row_of(variable.type).kind) ||
                (row->off_by_bit_31 && (value->number & bit_31) != 0)) {
                continue;
            }
            take(User{&group, row, variable.sub_index, *value});
        }
    }
}

// Of the node that is known.
std::uint32_t identifier_of(const User& user, std::uint8_t node_id) {
    const std::uint64_t value = user.value.resolve(node_id);
    const std::uint32_t mask = (value & extended_frame) != 0 ? extended_mask : facts::cob::highest;
    return static_cast<std::uint32_t>(value) & mask;
}

bool is_extended(const User& user) {
    return (user.value.number & extended_frame) != 0;
}

bool is_too_long(const Value& value) {
    return (value.number & extended_frame) == 0 && (value.number & extended_mask) > facts::cob::highest;
}

// 180h, 200h, 600h, ..: the identifier of a node when its number is added.
bool is_bare_base(const Value& value) {
    const std::uint64_t identifier = value.number & extended_mask;
    return !value.node_id_relative && identifier >= facts::cob::emergency &&
           identifier <= facts::cob::sdo_request && identifier != facts::cob::time &&
           (identifier & facts::cob::node_mask) == 0;
}

const Restricted* find_restricted(std::uint32_t identifier) {
    const auto* const row = std::find_if(restricted.begin(), restricted.end(), [&](const Restricted& each) {
        return identifier >= each.first && identifier <= each.last;
    });
    return row != restricted.end() ? row : nullptr;
}

// The node for which the identifier is told: the known one, else the first that `is_bad` objects to.
template <typename IsBad>
std::optional<std::uint8_t> bad_node(const Context& context, const User& user, IsBad is_bad) {
    if (context.node_id() || !user.value.node_id_relative) {
        const std::uint8_t node = context.node_id().value_or(1);
        return is_bad(identifier_of(user, node)) ? std::optional(node) : std::nullopt;
    }
    for (std::uint8_t node = 1; node <= highest_node; ++node) {
        if (is_bad(identifier_of(user, node))) {
            return node;
        }
    }
    return std::nullopt;
}

std::string of_node(const User& user, std::uint8_t node) {
    return user.value.node_id_relative ? fmt::format(" with node id {}", node) : std::string();
}

}  // namespace

void check_restricted_identifiers(const Context& context) {
    for_each_user(context, [&](const User& user) {
        if (is_extended(user) || is_too_long(user.value) || is_bare_base(user.value)) {
            return;
        }
        const auto node = bad_node(
            context, user, [](std::uint32_t identifier) { return find_restricted(identifier) != nullptr; });
        if (!node) {
            return;
        }
        const std::uint32_t identifier = identifier_of(user, *node);
        context.reading.report(
            rules::eds_cob_id_restricted, context.value_place(*user.group, user.sub_index),
            fmt::format("{} has identifier {}{}, which {}", name_of(user), identifier_text(identifier),
                        of_node(user, *node), find_restricted(identifier)->why));
    });
}

void check_duplicate_identifiers(const Context& context) {
    struct Key {
        std::uint32_t identifier;
        bool extended;
        bool relative;
        auto operator<=>(const Key&) const = default;
    };
    std::map<Key, User> users;
    for_each_user(context, [&](const User& user) {
        const auto node = context.node_id();
        const bool relative = user.value.node_id_relative && !node;
        const Key key{identifier_of(user, node.value_or(0)), is_extended(user), relative};
        const auto [first, is_new] = users.try_emplace(key, user);
        if (is_new || (first->second.row->receives_only && user.row->receives_only)) {
            return;
        }
        context.reading.report(
            rules::eds_cob_id_twice, context.value_place(*user.group, user.sub_index),
            fmt::format(
                "{} and {} have one identifier, {}", name_of(user), name_of(first->second),
                relative ? fmt::format("$NODEID+0x{:X}", key.identifier) : identifier_text(key.identifier)),
            "",
            {{context.reading.location(context.value_place(*first->second.group, first->second.sub_index)),
              fmt::format("{} has it here", name_of(first->second))}});
    });
}

void check_identifier_forms(const Context& context) {
    for_each_user(context, [&](const User& user) {
        if (is_too_long(user.value)) {
            context.reading.report(
                rules::eds_cob_id_form, context.value_place(*user.group, user.sub_index),
                fmt::format("{} has identifier 0x{:X}, which has more than 11 bits, and bit 29 is not set",
                            name_of(user), user.value.number & extended_mask));
        }
    });
}

// Values that CiA 301 predefines as base + node id: stated as the base alone they are those of no node.
void check_node_bases(const Context& context) {
    for (const Group& group : context.model.groups()) {
        if (group.object == nullptr || !group.has_section) {
            continue;
        }
        for (const Variable& variable : group.object->variables) {
            const Value* const value = value_of(variable);
            const UserRow* const row = row_of(group.index, variable.sub_index);
            const bool of_first_server =
                group.index == sdo_servers.first && (variable.sub_index == 1 || variable.sub_index == 2);
            if (value == nullptr || !is_bare_base(*value) ||
                !(of_first_server || (row != nullptr && row->follows_node))) {
                continue;
            }
            context.reading.report(
                rules::eds_node_id_absent, context.value_place(group, variable.sub_index),
                fmt::format("identifier {} is that of no node: $NODEID is missing",
                            identifier_text(static_cast<std::uint32_t>(value->number & extended_mask))),
                context.sheet.commissioning ? "" : fmt::format("write $NODEID+0x{:X}", value->number));
        }
    }
}

void check_default_server(const Context& context) {
    constexpr std::uint16_t index = 0x1200;
    struct Row {
        std::uint8_t sub_index;
        std::uint32_t base;
        std::string_view what;
    };
    constexpr std::array rows{Row{1, facts::cob::sdo_request, "requests"},
                              Row{2, facts::cob::sdo_answer, "answers"}};
    const Group* const group = context.model.find(index);
    if (group == nullptr || group->object == nullptr || !group->has_section) {
        return;
    }
    for (const Row& row : rows) {
        const Variable* const variable = group->object->find(row.sub_index);
        const Value* const value = variable != nullptr ? value_of(*variable) : nullptr;
        if (value == nullptr || value->number == row.base) {
            continue;  // the base alone is told by check_node_bases
        }
        const auto node = context.node_id();
        const bool right = !value->node_id_relative &&
                           (node ? value->number == row.base + *node
                                 : value->number > row.base && value->number <= row.base + highest_node);
        if (!right) {
            context.reading.report(
                rules::eds_sdo_server, context.value_place(*group, row.sub_index),
                fmt::format(
                    "the first SDO server has its {} at $NODEID+0x{:X}; here stands another identifier",
                    row.what, row.base));
        }
    }
}

}  // namespace cgw::eds_check
