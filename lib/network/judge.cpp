#include "network/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/canopen_text.hpp"
#include "base/numbers.hpp"
#include "config/numbers.hpp"
#include "diagnostic/rules/network.hpp"
#include "network/sources.hpp"

namespace cgw::network {
namespace {

namespace rules = diagnostic::rules;
using base::identifier_text;
using base::milliseconds_text;
using diagnostic::Diagnostic;
using diagnostic::Findings;
using diagnostic::Location;

std::string label_of(const Message& message) {
    return fmt::format("{} {}", identifier_text(message.identifier), message.label());
}

std::string percent(double share) {
    return fmt::format("{:.1f} %", share * 100);
}

// Reports the first findings of a kind, and how many more there are.
class Listed {
  public:
    Listed(Findings& findings, const diagnostic::Rule& rule) : findings_(findings), rule_(rule) {}
    Listed(const Listed&) = delete;
    Listed& operator=(const Listed&) = delete;
    ~Listed() {
        if (count_ > most_findings) {
            last_.message = fmt::format("{}, and {} more like this", last_.message, count_ - most_findings);
        }
        if (count_ != 0) {
            findings_.report(std::move(last_));
        }
    }

    void report(const Location& where, std::string message, std::string help = {}) {
        if (++count_ <= most_findings) {
            if (count_ > 1) {
                findings_.report(std::move(last_));
            }
            last_ = {.rule = &rule_, .message = std::move(message), .where = where, .help = std::move(help)};
        }
    }
    void relate(const Location& where, std::string message) {
        if (count_ <= most_findings) {
            last_.related.push_back({where, std::move(message)});
        }
    }

  private:
    Findings& findings_;
    const diagnostic::Rule& rule_;
    Diagnostic last_;
    std::size_t count_ = 0;
};

// One finding: what takes the bus from the first takes it from all behind it.
bool judge_bounds(const Analysis& analysis, Findings& findings) {
    const auto is_unbounded = [](const MessageResult& result) { return !result.bounded(); };
    const auto first = std::find_if(analysis.messages.begin(), analysis.messages.end(), is_unbounded);
    if (first == analysis.messages.end()) {
        return true;
    }
    const auto count = std::count_if(first, analysis.messages.end(), is_unbounded);
    const std::string others = count == 1 ? "" : fmt::format(" and {} others", count - 1);
    const std::string_view reason = first->bound == Bound::none
                                        ? "messages of higher or equal priority may take all the bus"
                                        : "the search for a bound was given up";
    findings.report(
        {.rule = &rules::message_unbounded,
         .message = fmt::format("{}{} may wait for ever: {}", label_of(first->message), others, reason),
         .where = first->message.where,
         .help = "send what is above less often, or raise the bit rate"});
    return false;
}

void judge_times(const Analysis& analysis, Findings& findings) {
    Listed missed(findings, rules::deadline_missed);
    Listed late(findings, rules::message_late);
    Listed slow(findings, rules::message_too_slow);
    for (const MessageResult& result : analysis.messages) {
        const Message& message = result.message;
        if (message.monitored_us != 0 && !message.assumed && message.period_us >= message.monitored_us) {
            slow.report(message.where, fmt::format("{} is sent every {}, and its receiver waits for {} only",
                                                   label_of(message), milliseconds_text(message.period_us),
                                                   milliseconds_text(message.monitored_us)));
            continue;
        }
        if (!result.bounded()) {
            continue;
        }
        const std::string through =
            fmt::format("{} may take {}", label_of(message), milliseconds_text(result.response_us));
        if (!result.in_time()) {
            missed.report(message.where,
                          fmt::format("{}, and has {}", through, milliseconds_text(message.deadline_us)));
        } else if (message.deadline_us != 0 && result.response_us > message.period_us) {
            late.report(message.where, fmt::format("{}, and the next one is due after {}", through,
                                                   milliseconds_text(message.period_us)));
        } else if (message.monitored_us != 0 &&
                   message.period_us + result.response_us > message.monitored_us) {
            late.report(message.where, fmt::format("{} and is sent every {}: its receiver waits for {} only",
                                                   through, milliseconds_text(message.period_us),
                                                   milliseconds_text(message.monitored_us)));
        }
    }
}

void judge_load(const Analysis& analysis, const Bands& bands, const Location& bus, Findings& findings) {
    const Band band = band_of(analysis.load.worst, bands);
    const auto report = [&](const diagnostic::Rule& rule, double limit) {
        findings.report(
            {.rule = &rule,
             .message = fmt::format("the bus is loaded with up to {} of {} kbit/s, more than {}",
                                    percent(analysis.load.worst),
                                    base::to_text(analysis.bus.bit_rate / 1000.0), percent(limit)),
             .where = bus,
             .help = "cgw network --suggest proposes what to change"});
    };
    if (band == Band::overloaded) {
        report(rules::bus_overloaded, bands.fail);
    } else if (band == Band::high) {
        report(rules::bus_load_high, bands.ok);
    }
}

void judge_lengths(const Analysis& analysis, Findings& findings) {
    Listed shorter(findings, rules::message_too_short);
    for (const MessageResult& result : analysis.messages) {
        const Message& message = result.message;
        if (message.bytes < message.received_bytes) {
            shorter.report(message.where,
                           fmt::format("{} has {} bytes, and its receiver takes no fewer than {}",
                                       label_of(message), message.bytes, message.received_bytes));
        }
    }
}

Location place_of(const parameter::Settings& settings, std::uint16_t number) {
    const parameter::Assignment* assignment = settings.gateway.find(number);
    return assignment != nullptr ? assignment->where : settings.gateway_table;
}

}  // namespace

Band band_of(double load, const Bands& bands) {
    return load <= bands.comfortable ? Band::comfortable
           : load <= bands.ok        ? Band::ok
           : load <= bands.fail      ? Band::high
                                     : Band::overloaded;
}

std::string_view to_text(Band band) {
    constexpr std::string_view names[] = {"comfortable", "ok", "high", "overloaded"};
    return names[static_cast<std::size_t>(band)];
}

Member member_of(const parameter::Settings& settings, const config::Configuration& configuration) {
    namespace gateway = config::gateway;
    const std::uint16_t rate =
        configuration.can2.manual ? gateway::canopen_manual_timing : gateway::canopen_bit_rate;
    return {.path = settings.path,
            .node_id = configuration.node_id,
            .bit_rate = config::bit_rate(configuration.can2, settings.can2_bit_timing),
            .node_where = place_of(settings, gateway::node_id),
            .rate_where = place_of(settings, rate)};
}

std::optional<std::uint32_t> judge_bit_rate(std::span<const Member> members, Findings& findings) {
    const Member* first = nullptr;
    bool agreed = true;
    for (const Member& member : members) {
        if (!member.bit_rate) {
            findings.report({.rule = &rules::bus_bit_rate_unknown,
                             .message = "the bit rate of CAN2 is set by hand, and the file tells no clock",
                             .where = member.rate_where,
                             .help = "state gateway.bit_timing.can2, or ask with --what-if baud=KBIT"});
            agreed = false;
        } else if (first == nullptr) {
            first = &member;
        } else if (*member.bit_rate != *first->bit_rate) {
            const auto kbit = [](const Member& of) { return base::to_text(*of.bit_rate / 1000.0); };
            findings.report(
                {.rule = &rules::bit_rates_differ,
                 .message = fmt::format("node {} has {} kbit/s, and node {} has {}", member.node_id,
                                        kbit(member), first->node_id, kbit(*first)),
                 .where = member.rate_where,
                 .related = {{first->rate_where, fmt::format("{} kbit/s", kbit(*first))}}});
            agreed = false;
        }
    }
    return agreed && first != nullptr ? first->bit_rate : std::nullopt;
}

// A message of which only the time is assumed has a sender all the same.
bool has_owner(const Message& message) {
    return !message.receiver && (!message.assumed || !message.sender.empty());
}

bool are_in_conflict(const Message& a, const Message& b) {
    const bool told_twice = a.label() == b.label() && a.bytes == b.bytes && a.plant != b.plant;
    const bool two_senders = !a.sender.empty() && !b.sender.empty() && a.sender != b.sender;
    return a.identifier == b.identifier && has_owner(a) && has_owner(b) && !told_twice &&
           (two_senders || (!a.assumed && !b.assumed));
}

void judge_owners(std::span<const Member> members, std::span<const Message> messages, Findings& findings) {
    std::map<std::uint8_t, const Member*> nodes;
    bool shared = false;
    for (const Member& member : members) {
        const auto [first, is_new] = nodes.try_emplace(member.node_id, &member);
        if (!is_new) {
            shared = true;
            findings.report({.rule = &rules::node_shared,
                             .message = fmt::format("two plants have node id {}", member.node_id),
                             .where = member.node_where,
                             .related = {{first->second->node_where, "also here"}}});
        }
    }
    std::map<std::uint32_t, const Message*> owners;
    Listed conflicts(findings, rules::identifier_conflict);
    for (const Message& message : messages) {
        if (!has_owner(message)) {
            continue;
        }
        const auto [first, is_new] = owners.try_emplace(message.identifier, &message);
        const Message& other = *first->second;
        // What follows from a node id that two have is one finding.
        const bool follows = shared && !message.sender.empty() && message.sender == other.sender;
        if (is_new || follows || !are_in_conflict(message, other)) {
            continue;
        }
        conflicts.report(message.where,
                         fmt::format("{} is sent as {} and as {}", identifier_text(message.identifier),
                                     other.label(), message.label()));
        conflicts.relate(other.where, other.label());
    }
}

void judge(const Analysis& analysis, const Bands& bands, const Location& bus, Findings& findings) {
    if (judge_bounds(analysis, findings)) {
        judge_load(analysis, bands, bus, findings);
    }
    judge_times(analysis, findings);
    judge_lengths(analysis, findings);
}

Judged judge_bus(std::span<const Member> members, std::vector<Message> messages, const Bus& conditions,
                 const Bands& bands) {
    Judged judged{std::move(messages), std::nullopt, {}};
    judge_owners(members, judged.messages, judged.findings);
    if (const auto bit_rate = judge_bit_rate(members, judged.findings)) {
        Bus bus = conditions;
        bus.bit_rate = *bit_rate;
        judged.analysis = analyse(merged(judged.messages), bus);
        judge(*judged.analysis, bands, members.front().rate_where, judged.findings);
    }
    return judged;
}

}  // namespace cgw::network
