// What was counted, for people; and the table of formats.
#include <fmt/format.h>

#include <array>

#include "base/canopen_text.hpp"
#include "traffic/render_parts.hpp"

namespace cgw::traffic {
namespace {

constexpr std::array formats_table{
    Format{"text", "a line for each frame, and at the end what was counted",
           [](const Subject&) { return std::string(); }, text_frame, text_summary},
    Format{"json", "a JSON document on each line", json_head, json_frame, json_foot},
    Format{"csv", "a line for each signal, comma-separated", csv_head, csv_frame,
           [](const Audit&, std::span<const diagnostic::Diagnostic>) { return std::string(); }},
};

std::string ms(double microseconds) {
    return fmt::format("{:.3f}", microseconds / 1000);
}

std::string expected_text(const Rhythm& rhythm) {
    if (rhythm.period_us() != 0) {
        return base::milliseconds(rhythm.period_us());
    }
    return rhythm.monitoring_us() != 0 ? "<= " + base::milliseconds(rhythm.monitoring_us()) : "-";
}

std::string row_of(const Watched& watched, bool timed) {
    const Rhythm& rhythm = watched.rhythm;
    std::string row =
        fmt::format("{:<21}{:>6} {:>9} {:>11}", watched.name, base::identifier_text(watched.identifier),
                    rhythm.frames(), expected_text(rhythm));
    if (timed && rhythm.gaps() != 0) {
        row += fmt::format(" {:>9} {:>9} {:>9}", ms(static_cast<double>(rhythm.shortest_us())),
                           ms(rhythm.mean_us()), ms(static_cast<double>(rhythm.longest_us())));
    }
    return row + "\n";
}

std::string others_text(const Audit& audit) {
    constexpr std::array others{
        Service::nmt,        Service::sync,      Service::time,      Service::emergency, Service::sdo_request,
        Service::sdo_answer, Service::heartbeat, Service::other_pdo, Service::lss,       Service::unknown};
    std::string text;
    for (const Service service : others) {
        if (const std::uint64_t count = audit.of(service); count != 0) {
            text += fmt::format("{}{} {}", text.empty() ? "" : ", ", to_text(service), count);
        }
    }
    return text;
}

}  // namespace

std::span<const Format> formats() {
    return formats_table;
}

std::string text_summary(const Audit& audit, std::span<const diagnostic::Diagnostic> /*findings*/) {
    std::string text = fmt::format("\n{} frames", audit.frames());
    if (audit.timed() && audit.last_us() >= audit.first_us()) {
        text += fmt::format(" in {:.3f} s", static_cast<double>(audit.last_us() - audit.first_us()) / 1e6);
    }
    text += audit.passed_over() == 0
                ? ""
                : fmt::format(", {} error or CAN FD frames passed over", audit.passed_over());
    text += audit.faults() == 0 ? "" : fmt::format(", {} records that are none", audit.faults());
    text += audit.was_operational() ? "\n" : "; the gateway was never seen Operational\n";
    if (const std::string others = others_text(audit); !others.empty()) {
        text += fmt::format("Besides PDOs: {}\n", others);
    }
    text += fmt::format("\n{:<21}{:>6} {:>9} {:>11} {:>9} {:>9} {:>9}\n", "Frame", "COB-ID", "count",
                        "period ms", "min", "mean", "max");
    for (const Watched& watched : audit.watched()) {
        text += row_of(watched, audit.timed());
    }
    return text;
}

}  // namespace cgw::traffic
