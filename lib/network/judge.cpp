#include "network/judge.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/canopen_text.hpp"
#include "base/numbers.hpp"
#include "config/numbers.hpp"
#include "diagnostic/rules/network.hpp"
#include "network/judge_parts.hpp"
#include "network/sources.hpp"

namespace cgw::network {
namespace {

namespace rules = diagnostic::rules;
using base::milliseconds_text;
using diagnostic::Findings;
using diagnostic::Location;

std::string percent(double share) {
    return fmt::format("{:.1f} %", share * 100);
}

// What nobody states stands nowhere: then it is a matter of the whole bus.
const Location& place_of(const Message& message, const Location& bus) {
    return message.where.path.empty() ? bus : message.where;
}

// Whether all messages would have a bound without disturbances.
bool is_due_to_errors(const Analysis& analysis) {
    if (analysis.bus.errors_per_second == 0) {
        return false;
    }
    std::vector<Message> messages;
    messages.reserve(analysis.messages.size());
    for (const MessageResult& result : analysis.messages) {
        messages.push_back(result.message);
    }
    Bus calm = analysis.bus;
    calm.errors_per_second = 0;
    const Analysis without = analyse(messages, calm);
    return std::all_of(without.messages.begin(), without.messages.end(),
                       [](const MessageResult& result) { return result.bounded(); });
}

// One finding: what takes the bus from the first takes it from all behind it.
bool judge_bounds(const Analysis& analysis, const Location& bus, Findings& findings) {
    const auto is_unbounded = [](const MessageResult& result) { return !result.bounded(); };
    const auto first = std::find_if(analysis.messages.begin(), analysis.messages.end(), is_unbounded);
    if (first == analysis.messages.end()) {
        return true;
    }
    const auto count = std::count_if(first, analysis.messages.end(), is_unbounded);
    const std::string others = count == 1 ? "" : fmt::format(" and {} others", count - 1);
    std::string reason = first->bound == Bound::none
                             ? "messages of higher or equal priority may take all the bus"
                             : "the search for a bound was given up";
    std::string help = first == analysis.messages.begin()
                           ? "send it less often, or raise the bit rate"
                           : "send it and what is above it less often, or raise the bit rate";
    if (is_due_to_errors(analysis)) {
        reason = fmt::format("{} errors per second may take all the bus",
                             base::to_text(analysis.bus.errors_per_second));
        help = "raise the bit rate, or count with fewer errors";
    }
    findings.report(
        {.rule = &rules::message_unbounded,
         .message = fmt::format("{}{} may wait for ever: {}", label_of(first->message), others, reason),
         .where = place_of(first->message, bus),
         .help = std::move(help)});
    return false;
}

void judge_times(const Analysis& analysis, Findings& findings) {
    Listed missed(findings, rules::deadline_missed);
    Listed late(findings, rules::message_late);
    Listed slow(findings, rules::message_too_slow);
    for (const MessageResult& result : analysis.messages) {
        const Message& message = result.message;
        if (is_too_slow(message)) {
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

bool is_too_slow(const Message& message) {
    return message.monitored_us != 0 && !message.assumed && message.period_us >= message.monitored_us;
}

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

void judge(const Analysis& analysis, const Bands& bands, const Location& bus, Findings& findings) {
    if (judge_bounds(analysis, bus, findings)) {
        judge_load(analysis, bands, bus, findings);
    }
    judge_times(analysis, findings);
    judge_lengths(analysis, findings);
}

bool DescribedNode::offers(std::uint32_t kbit) const {
    return offered_kbit.empty() ||
           std::find(offered_kbit.begin(), offered_kbit.end(), kbit) != offered_kbit.end();
}

void judge_bit_rates(std::span<const DescribedNode> nodes, std::uint32_t bit_rate, Findings& findings) {
    const std::string bus = base::to_text(bit_rate / 1000.0);
    for (const DescribedNode& node : nodes) {
        const bool offered = bit_rate % 1000 == 0 && node.offers(bit_rate / 1000);
        if (!offered && !node.offered_kbit.empty()) {
            findings.report({.rule = &rules::bit_rate_not_offered,
                             .message = fmt::format("node {} has no {} kbit/s, by its description: it has {}",
                                                    node.node_id, bus, fmt::join(node.offered_kbit, ", ")),
                             .where = node.offered_where});
        } else if (node.set_kbit && *node.set_kbit * std::uint64_t{1000} != bit_rate) {
            findings.report({.rule = &rules::bit_rates_differ,
                             .message = fmt::format("node {} is set to {} kbit/s, and the bus has {}",
                                                    node.node_id, *node.set_kbit, bus),
                             .where = node.set_where});
        }
    }
}

namespace {

std::uint64_t latest_sync_us(const Analysis& analysis) {
    std::uint64_t latest = 0;
    for (const MessageResult& result : analysis.messages) {
        if (is_sync(result.message) && result.bounded()) {
            latest = std::max(latest, result.response_us);
        }
    }
    return latest;
}

// A PDO that goes with the SYNC is as late as that comes, its own jitter and what it waits for included. One
// that is sent before the SYNC makes it later in turn.
Analysis analyse_with_sync(std::vector<Message> messages, const Bus& bus) {
    constexpr int most_rounds = 32;
    Analysis analysis = analyse(messages, bus);
    for (int round = 0;; ++round) {
        const std::uint64_t latest = latest_sync_us(analysis);
        bool later = false;
        for (Message& message : messages) {
            if (message.sync_multiple != 0 && message.jitter_us < latest) {
                message.jitter_us = latest;
                later = true;
            }
        }
        if (!later) {
            return analysis;
        }
        if (round == most_rounds) {
            break;
        }
        analysis = analyse(messages, bus);
    }
    for (MessageResult& result : analysis.messages) {
        result.bound = result.bounded() ? Bound::not_found : result.bound;
    }
    return analysis;
}

}  // namespace

Judged judge_bus(std::span<const Member> members, std::span<const DescribedNode> nodes,
                 std::vector<Message> messages, const Bus& conditions, const Bands& bands) {
    Judged judged{std::move(messages), std::nullopt, {}};
    judge_owners(members, judged.messages, judged.findings);
    if (const auto bit_rate = judge_bit_rate(members, judged.findings)) {
        judge_bit_rates(nodes, *bit_rate, judged.findings);
        Bus bus = conditions;
        bus.bit_rate = *bit_rate;
        judged.analysis = analyse_with_sync(merged(judged.messages), bus);
        judge(*judged.analysis, bands, members.front().rate_where, judged.findings);
    }
    return judged;
}

}  // namespace cgw::network
