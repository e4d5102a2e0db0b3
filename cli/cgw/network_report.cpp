#include "cli/cgw/network_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/canopen_text.hpp"
#include "base/numbers.hpp"
#include "base/text_cells.hpp"
#include "base/utf8.hpp"
#include "base/wrap.hpp"

namespace cgw::cli {
namespace {

using network::Analysis;
using network::Bound;
using network::MessageResult;

constexpr std::size_t page_width = 80;

std::string percent(double share, int digits) {
    return fmt::format("{:.{}f}", share * 100, digits);
}

std::string response_text(const MessageResult& result) {
    return result.bounded() ? fmt::format("{:.2f}", static_cast<double>(result.response_us) / 1000)
                            : "unbounded";
}

std::string time_text(std::uint64_t us) {
    return us == 0 ? "" : base::milliseconds(us);
}

bool is_in_conflict(const NetworkReport& report, std::uint32_t identifier) {
    return std::any_of(report.map.begin(), report.map.end(), [&](const network::IdentifierRange& range) {
        return range.use == network::Use::conflict && identifier >= range.first && identifier <= range.last;
    });
}

// What is wrong with the message, the worst of it; the findings say all.
std::string_view trouble_with(const NetworkReport& report, const MessageResult& result) {
    const network::Message& message = result.message;
    return is_in_conflict(report, message.identifier) ? "conflict"
           : message.bytes < message.received_bytes   ? "too short"
           : network::is_too_slow(message)            ? "too slow"
           : result.bound == Bound::not_found         ? "no bound found"
           : result.bounded() && !result.in_time()    ? "too late"
                                                      : "";
}

std::string remark_of(const NetworkReport& report, const MessageResult& result) {
    std::vector<std::string_view> remarks;
    if (const std::string_view trouble = trouble_with(report, result); !trouble.empty()) {
        remarks.push_back(trouble);
    }
    if (result.message.assumed) {
        remarks.emplace_back("assumed");
    } else if (result.message.release == network::Release::event) {
        remarks.emplace_back("event");
    }
    return fmt::format("{}", fmt::join(remarks, ", "));
}

// The same message as it was: identifiers, names and senders do not change by a what-if.
const MessageResult* same_message(const Analysis& analysis, const MessageResult& result, std::size_t place) {
    return place < analysis.messages.size() &&
                   analysis.messages[place].message.identifier == result.message.identifier
               ? &analysis.messages[place]
               : nullptr;
}

std::string lines_of(std::string_view text) {
    std::string lines;
    for (const std::string& line : base::wrap(text, page_width)) {
        lines += base::printable(line) + "\n";
    }
    return lines;
}

std::size_t count_of(const Analysis& analysis, bool (*wanted)(const MessageResult&)) {
    return static_cast<std::size_t>(
        std::count_if(analysis.messages.begin(), analysis.messages.end(), wanted));
}

std::vector<std::string> verdicts_of(const NetworkReport& report) {
    if (!report.before) {
        return {network_verdict(report, report.analysis, report.fails)};
    }
    return {"as it is, " + network_verdict(report, *report.before, report.fails_before),
            fmt::format("with {}, {}", fmt::join(report.changes, " and "),
                        network_verdict(report, report.analysis, report.fails))};
}

// How the table is to be read, and what is not in it.
std::vector<std::string> notes_on(const NetworkReport& report) {
    std::vector<std::string> notes{
        "Times in ms: shortest period, worst-case response time, deadline.",
        "`assumed`: nobody states it (D75); `event`: now and then, not in the average."};
    for (const std::string& left_out : report.left_out) {
        notes.push_back("not counted: " + left_out);
    }
    std::string ranges;
    for (const network::IdentifierRange& range : report.map) {
        if (range.use == network::Use::free) {
            ranges += fmt::format("{}{}", ranges.empty() ? "" : ", ", base::identifier_text(range.first));
            ranges += range.last == range.first ? "" : ".." + base::identifier_text(range.last);
        }
    }
    notes.push_back("free identifiers: " + (ranges.empty() ? "none" : ranges));
    return notes;
}

}  // namespace

std::string network_verdict(const NetworkReport& report, const Analysis& analysis, bool fails) {
    const std::size_t unbounded = count_of(analysis, [](const auto& result) { return !result.bounded(); });
    const std::size_t late =
        count_of(analysis, [](const auto& result) { return result.bounded() && !result.in_time(); });
    std::string text = fmt::format(
        "{}: {} kbit/s, load {} % on average and up to {} % ({}), {} messages",
        fails ? "it will not work" : "it will work", base::to_text(analysis.bus.bit_rate / 1000.0),
        percent(analysis.load.average, 1), percent(analysis.load.worst, 1),
        to_text(network::band_of(analysis.load.worst, report.bands)), analysis.messages.size());
    if (unbounded != 0) {
        text += fmt::format(", {} of them unbounded", unbounded);
    }
    if (late != 0) {
        text += fmt::format(", {} of them too late", late);
    }
    return text;
}

explain::Table network_table(const NetworkReport& report) {
    using explain::everywhere;
    using explain::in_data;
    // On a terminal there is not room for all.
    const unsigned unless_compared =
        report.before ? explain::in_page | in_data : static_cast<unsigned>(everywhere);
    explain::Table table{"messages", false, {}, {}};
    table.columns = {{"identifier", "id"},
                     {"message", "message"},
                     {"bytes", "n", unless_compared, true},
                     {"period_ms", "period", everywhere, true},
                     {"jitter_ms", "jitter", in_data, true},
                     {"average_percent", "avg %", in_data, true},
                     {"worst_percent", "load %", everywhere, true},
                     {"response_ms", "resp.", everywhere, true},
                     {"deadline_ms", "deadl.", unless_compared, true},
                     {"period_before_ms", "(period)", everywhere, true},
                     {"response_before_ms", "(resp.)", everywhere, true},
                     {"remark", "remark"}};
    for (std::size_t i = 0; i < report.analysis.messages.size(); ++i) {
        const MessageResult& result = report.analysis.messages[i];
        const network::Message& message = result.message;
        const MessageResult* before = report.before ? same_message(*report.before, result, i) : nullptr;
        table.rows.push_back(
            {base::identifier_text(message.identifier), base::printable(message.label()),
             std::to_string(message.bytes), time_text(message.period_us), time_text(message.jitter_us),
             percent(result.load.average, 2), percent(result.load.worst, 2), response_text(result),
             time_text(message.deadline_us), before != nullptr ? time_text(before->message.period_us) : "",
             before != nullptr ? response_text(*before) : "", remark_of(report, result)});
    }
    return table;
}

std::string network_text(const NetworkReport& report, bool with_map) {
    std::string text;
    for (const std::string& verdict : verdicts_of(report)) {
        text += lines_of(verdict);
    }
    text += "\n" + explain::find_table_format("table")->render(network_table(report)) + "\n";
    for (const std::string& note : notes_on(report)) {
        text += lines_of(note);
    }
    return with_map ? text + "\n" + identifier_strip(report.map) : text;
}

std::string network_markdown(const NetworkReport& report) {
    std::string text;
    for (const std::string& verdict : verdicts_of(report)) {
        text += fmt::format("**{}**\n\n", base::markdown_cell(verdict));
    }
    text += explain::find_table_format("md")->render(network_table(report)) + "\n";
    for (const diagnostic::FileReport& file : report.findings) {
        for (const diagnostic::Diagnostic& finding : file.findings) {
            text += fmt::format("- {}: {} [{} {}]\n", diagnostic::to_text(finding.rule->level),
                                base::markdown_cell(finding.message), finding.rule->code, finding.rule->name);
        }
    }
    for (const std::string& note : notes_on(report)) {
        text += fmt::format("- {}\n", base::markdown_cell(note));
    }
    return text;
}

}  // namespace cgw::cli
