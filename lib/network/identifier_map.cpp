#include "network/identifier_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/canopen_text.hpp"
#include "facts/identifiers.hpp"
#include "network/judge.hpp"

namespace cgw::network {
namespace {

constexpr std::uint16_t identifiers = facts::cob::highest + 1;

Use use_without_owner(std::uint16_t identifier) {
    if (facts::is_free_identifier(identifier)) {
        return Use::free;
    }
    const bool restricted =
        identifier == facts::cob::nmt ||
        std::any_of(std::begin(facts::restricted_identifiers), std::end(facts::restricted_identifiers),
                    [&](const auto& range) { return identifier >= range.first && identifier <= range.last; });
    return restricted ? Use::restricted : Use::node_bound;
}

// Most telling of the identifiers that share a character.
char symbol_of(Use first, Use second) {
    constexpr std::array<std::pair<Use, char>, 5> symbols{{{Use::conflict, 'X'},
                                                           {Use::taken, '#'},
                                                           {Use::free, '.'},
                                                           {Use::node_bound, ' '},
                                                           {Use::restricted, '-'}}};
    for (const auto& [use, symbol] : symbols) {
        if (first == use || second == use) {
            return symbol;
        }
    }
    return ' ';
}

}  // namespace

std::string_view to_text(Use use) {
    constexpr std::string_view names[] = {"taken", "conflict", "free", "restricted", "node-bound"};
    return names[static_cast<std::size_t>(use)];
}

std::vector<IdentifierRange> identifier_map(std::span<const Message> messages) {
    std::vector<std::vector<const Message*>> owners(identifiers);
    for (const Message& message : messages) {
        if (message.identifier < identifiers) {
            owners[message.identifier].push_back(&message);
        }
    }
    Message commands;  // merged() counts them as well
    commands.name = "NMT";
    commands.assumed = true;
    if (owners[facts::cob::nmt].empty()) {
        owners[facts::cob::nmt].push_back(&commands);
    }
    std::vector<IdentifierRange> map;
    for (std::uint16_t identifier = 0; identifier < identifiers; ++identifier) {
        const std::vector<const Message*>& own = owners[identifier];
        IdentifierRange range{identifier, identifier, use_without_owner(identifier)};
        if (own.empty()) {
            if (!map.empty() && map.back().use == range.use) {
                map.back().last = identifier;
                continue;
            }
        } else {
            range.use = Use::taken;
            for (auto message = own.begin(); message != own.end(); ++message) {
                const auto quarrels = [&](const Message* other) {
                    return are_in_conflict(*other, **message);
                };
                if (range.use != Use::conflict && std::any_of(own.begin(), message, quarrels)) {
                    range.use = Use::conflict;
                }
                const std::string label = (*message)->label();
                constexpr std::size_t most_owners = 8;
                if (range.owners.size() < most_owners &&
                    std::find(range.owners.begin(), range.owners.end(), label) == range.owners.end()) {
                    range.owners.push_back(label);
                }
            }
        }
        map.push_back(std::move(range));
    }
    return map;
}

std::vector<std::uint16_t> free_identifiers(std::span<const Message> messages, std::size_t count) {
    std::vector<std::uint16_t> found;
    const std::vector<IdentifierRange> map = identifier_map(messages);
    for (const Use use : {Use::free, Use::node_bound}) {
        for (const IdentifierRange& range : map) {
            // Below the first TPDO SYNC, EMCY and TIME have their places.
            const bool usable = range.use == use && range.first > facts::cob::tpdo[0];
            for (std::uint32_t i = range.first; usable && i <= range.last && found.size() < count; ++i) {
                found.push_back(static_cast<std::uint16_t>(i));
            }
        }
    }
    return found;
}

std::string identifier_strip(std::span<const IdentifierRange> map) {
    std::vector<Use> uses(identifiers, Use::node_bound);
    for (const IdentifierRange& range : map) {
        std::fill(uses.begin() + range.first, uses.begin() + range.last + 1, range.use);
    }
    constexpr std::uint16_t per_line = 128;
    constexpr std::array<std::string_view, identifiers / per_line> names{
        "NMT",   "EMCY",  "",      "TPDO1",  "RPDO1",  "TPDO2", "RPDO2",   "TPDO3",
        "RPDO3", "TPDO4", "RPDO4", "SDO tx", "SDO rx", "free",  "heartb.", ""};
    std::string text = "           +0      +10     +20     +30     +40     +50     +60     +70\n";
    for (std::uint16_t first = 0; first < identifiers; first = static_cast<std::uint16_t>(first + per_line)) {
        std::string line;
        for (std::uint16_t i = first; i < first + per_line; i = static_cast<std::uint16_t>(i + 2)) {
            line += symbol_of(uses[i], uses[i + 1U]);
        }
        text += fmt::format("{} {:<7}|{}|\n", base::identifier_text(first).substr(0, 3),
                            names[first / per_line], line);
    }
    return text + "# taken, X conflict, . free for everybody, - kept by CiA 301; two in a character\n";
}

}  // namespace cgw::network
