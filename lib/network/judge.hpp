// Will it work: what is wrong with the messages of a bus, as findings (E11).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "config/configuration.hpp"
#include "diagnostic/diagnostic.hpp"
#include "network/analysis.hpp"
#include "parameter/settings.hpp"

namespace cgw::network {

// Of the worst-case load of the bus, as shares: up to `comfortable`, up to `ok`, beyond `fail`.
struct Bands {
    double comfortable = 0.3;
    double ok = 0.5;
    double fail = 0.7;
};

enum class Band : std::uint8_t { comfortable, ok, high, overloaded };
Band band_of(double load, const Bands& bands);
std::string_view to_text(Band band);  // "comfortable", "ok", "high", "overloaded"

// A plant as a member of the bus.
struct Member {
    std::string path;
    std::uint8_t node_id = 0;
    std::optional<std::uint32_t> bit_rate;  // bit/s; not known where it is set by hand and no clock is told
    diagnostic::Location node_where;
    diagnostic::Location rate_where;
};
Member member_of(const parameter::Settings& settings, const config::Configuration& configuration);

// A node that is known by its description.
struct DescribedNode {
    std::uint8_t node_id = 0;
    std::vector<unsigned> offered_kbit;     // bit rates it supports, upwards; empty: not stated
    std::optional<std::uint32_t> set_kbit;  // what a DCF sets it to
    diagnostic::Location offered_where;     // where each stands
    diagnostic::Location set_where;

    bool offers(std::uint32_t kbit) const;
};

// Findings of one kind that are told one by one; of the others the number.
inline constexpr std::size_t most_findings = 20;

// The bit rate of the bus; nothing after a finding.
std::optional<std::uint32_t> judge_bit_rate(std::span<const Member> members, diagnostic::Findings& findings);

// Nodes that are not set to the bit rate of the bus, or cannot be.
void judge_bit_rates(std::span<const DescribedNode> nodes, std::uint32_t bit_rate,
                     diagnostic::Findings& findings);

// Node ids and identifiers that have two owners, of all messages before they are merged.
void judge_owners(std::span<const Member> members, std::span<const Message> messages,
                  diagnostic::Findings& findings);

// Load, response times and lengths. `bus` is where a finding about all of it stands.
void judge(const Analysis& analysis, const Bands& bands, const diagnostic::Location& bus,
           diagnostic::Findings& findings);

// A bus as it was judged.
struct Judged {
    std::vector<Message> messages;     // of all members, not merged
    std::optional<Analysis> analysis;  // nothing where the bit rate is not known
    diagnostic::Findings findings;
};

// All of the above. `conditions` are those of the bus but for its bit rate; `members` is not empty.
Judged judge_bus(std::span<const Member> members, std::span<const DescribedNode> nodes,
                 std::vector<Message> messages, const Bus& conditions, const Bands& bands);

// It is sent no more often than its receiver waits for it.
bool is_too_slow(const Message& message);

// Somebody sends it, and PDOs go with it.
bool is_sync(const Message& message);

// Two messages that are not the same one told twice: an identifier with two senders. What two tell alike but
// for its times is one message.
bool are_in_conflict(const Message& a, const Message& b);

}  // namespace cgw::network
