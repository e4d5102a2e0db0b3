#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "base/canopen_text.hpp"
#include "emit/report_parts.hpp"
#include "facts/identifiers.hpp"
#include "network/analysis.hpp"
#include "network/identifier_map.hpp"
#include "network/judge.hpp"
#include "network/sources.hpp"

namespace cgw::emit {
namespace {

using network::Analysis;
using network::MessageResult;
using page::Bar;
using page::Cell;
using page::Tone;

std::string percent(double share) {
    return fmt::format("{:.1f} %", share * 100);
}

std::string milliseconds(std::uint64_t microseconds) {
    return fmt::format("{:.2f} ms", static_cast<double>(microseconds) / 1000);
}

Tone tone_of(const MessageResult& result) {
    return result.in_time() ? Tone::good : Tone::bad;
}

Cell response_cell(const MessageResult& result) {
    if (!result.bounded()) {
        return {"no bound", Tone::bad};
    }
    const std::string text = milliseconds(result.response_us);
    const std::uint64_t deadline = result.message.deadline_us;
    if (deadline == 0) {
        return {text};
    }
    const double share = static_cast<double>(result.response_us) / static_cast<double>(deadline);
    return {text, tone_of(result), Bar{share, fmt::format("{} of the deadline", percent(share))}};
}

std::string verdict_text(const MessageResult& result) {
    if (!result.bounded()) {
        return "may wait for ever";
    }
    return result.message.deadline_us == 0 ? "" : result.in_time() ? "in time" : "late";
}

std::string period_text(const network::Message& message) {
    const std::string every = base::milliseconds_text(message.period_us);
    return fmt::format("{}{}{}", message.release == network::Release::event ? "at most every " : "every ",
                       every, message.assumed ? ", assumed" : "");
}

page::Table messages_table(const Analysis& analysis) {
    page::Table table{"Messages by priority, all released at the same moment",
                      {{"Identifier"},
                       {"Message"},
                       {"Bytes", true},
                       {"Sent"},
                       {"Load", true},
                       {"Worst response", true},
                       {"Deadline", true},
                       {"Verdict"}},
                      {}};
    for (const MessageResult& result : analysis.messages) {
        const network::Message& message = result.message;
        table.rows.push_back(
            {base::identifier_text(message.identifier),
             message.label(),
             std::to_string(message.bytes),
             period_text(message),
             {percent(result.load.worst), Tone::plain,
              Bar{result.load.worst, percent(result.load.worst) + " of the bus"}},
             response_cell(result),
             message.deadline_us == 0 ? "none" : base::milliseconds_text(message.deadline_us),
             verdict_text(result)});
    }
    return table;
}

Tone tone_of(network::Use use) {
    return use == network::Use::conflict ? Tone::bad : Tone::plain;
}

std::string range_text(const network::IdentifierRange& range) {
    return range.first == range.last ? base::identifier_text(range.first)
                                     : fmt::format("{} to {}", base::identifier_text(range.first),
                                                   base::identifier_text(range.last));
}

// Who has which identifier; what is free stands in the table only.
void add_identifiers(std::span<const network::IdentifierRange> map, Blocks& blocks) {
    page::Strip strip{
        "Identifiers in use, from 000h with the highest priority to 7FFh", 0, facts::cob::highest, {}};
    page::Table table{"All 2048 identifiers", {{"Identifiers"}, {"Use"}, {"Owner"}}, {}};
    for (const network::IdentifierRange& range : map) {
        const std::string owners = fmt::format("{}", fmt::join(range.owners, ", "));
        table.rows.push_back(
            {range_text(range), {std::string(to_text(range.use)), tone_of(range.use)}, owners});
        if (range.use == network::Use::taken || range.use == network::Use::conflict) {
            const std::string_view mark = range.use == network::Use::conflict ? " conflict:" : "";
            strip.fields.push_back({range.first, range.last,
                                    fmt::format("{}{} {}", range_text(range), mark, owners),
                                    tone_of(range.use)});
        }
    }
    blocks.emplace_back(page::Heading{3, "Identifiers"});
    blocks.emplace_back(std::move(strip));
    blocks.emplace_back(std::move(table));
}

Tone tone_of(network::Band band) {
    switch (band) {
        case network::Band::high:
            return Tone::warning;
        case network::Band::overloaded:
            return Tone::bad;
        default:
            return Tone::good;
    }
}

void judge(const Analysis& analysis, std::size_t conflicts, Judgement& judgement) {
    std::size_t late = 0;
    std::size_t unbounded = 0;
    for (const MessageResult& result : analysis.messages) {
        unbounded += result.bounded() ? 0U : 1U;
        late += result.bounded() && !result.in_time() ? 1U : 0U;
    }
    const network::Band band = network::band_of(analysis.load.worst, network::Bands{});
    judgement.add(tone_of(band),
                  fmt::format("CANopen bus: {} of {} kbit/s in the worst case, {}",
                              percent(analysis.load.worst), analysis.bus.bit_rate / 1000, to_text(band)));
    if (conflicts > 0) {
        judgement.add(Tone::bad, counted(conflicts, "identifier") + " with two senders");
    }
    if (late + unbounded == 0) {
        judgement.add(Tone::good, fmt::format("all {} messages are in time", analysis.messages.size()));
    }
    if (late > 0) {
        judgement.add(Tone::bad, counted(late, "message") + " may be late");
    }
    if (unbounded > 0) {
        judgement.add(Tone::bad, counted(unbounded, "message") + " may wait for ever");
    }
}

}  // namespace

network::Judged judge_network(const Plant& plant) {
    const std::vector<network::Member> members{network::member_of(plant.settings, plant.configuration)};
    return network::judge_bus(members, {}, network::messages_of(plant.settings, plant.configuration, 0), {}, {});
}

void add_network(const network::Judged& bus, Blocks& blocks, Judgement& judgement) {
    blocks.emplace_back(page::Heading{2, "CANopen bus"});
    if (!bus.analysis) {
        blocks.emplace_back(page::Paragraph{
            "The bit rate is set by hand and not known: nothing can be said of load and response times (D7).",
            Tone::warning});
        judgement.add(Tone::warning, "CANopen bus: bit rate not known");
        return;
    }
    const Analysis& analysis = *bus.analysis;
    const std::vector<network::IdentifierRange> map = network::identifier_map(bus.messages);
    const auto conflicts = std::count_if(map.begin(), map.end(), [](const network::IdentifierRange& range) {
        return range.use == network::Use::conflict;
    });
    judge(analysis, static_cast<std::size_t>(conflicts), judgement);
    blocks.emplace_back(page::Paragraph{fmt::format(
        "{} on average and {} in the worst case, at {} kbit/s. Other nodes count as far as the parameter "
        "file names them.",
        percent(analysis.load.average), percent(analysis.load.worst), analysis.bus.bit_rate / 1000)});
    blocks.emplace_back(messages_table(analysis));
    add_identifiers(map, blocks);
}

}  // namespace cgw::emit
