#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "base/numbers.hpp"
#include "bit_timing/proposals.hpp"
#include "cli/cgw/bit_timing_table.hpp"
#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/shared_options.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"

namespace cgw::cli {
namespace {

using bit_timing::Controller;
using bit_timing::Registers;
using bit_timing::Timing;

constexpr std::size_t most_proposals = 5;

std::vector<Word> family_words() {
    std::vector<Word> words;
    for (const Controller& controller : bit_timing::controllers) {
        words.push_back({controller.name, controller.members});
    }
    return words;
}

std::vector<Word> table_format_words() {
    std::vector<Word> words;
    for (const explain::TableFormat& format : explain::table_formats()) {
        words.push_back({format.name, format.summary});
    }
    return words;
}

constexpr Option bit_timing_options[] = {
    {.names = "FILE",
     .summary = "parameter file, to show its buses; - is standard input",
     .completes = Completes::files},
    {.names = "--clock", .value = "HZ", .summary = "clock of the CAN controller: 16000000, 16M"},
    {.names = "--family",
     .value = "FAMILY",
     .summary = "family of the CAN controller",
     .words = family_words},
    {.names = "--registers",
     .value = "LIST",
     .summary = "say what these six registers make, with commas between"},
    {.names = "--rate", .value = "KBIT", .summary = "propose registers for this bit rate in kbit/s"},
    {.names = "--sample-point",
     .value = "PERCENT",
     .summary = "where the proposals shall sample a bit",
     .default_value = "87.5"},
    {.names = "--format",
     .value = "FORMAT",
     .summary = "form of the list",
     .default_value = "table",
     .words = table_format_words},
    color_option,
};

constexpr std::string_view bit_timing_details =
    "With FILE: what both buses of the plant have. With --registers: what they make.\n"
    "With --rate: registers that make it, the best first. With --clock and --family\n"
    "alone: the best registers for each bit rate of CANopen.\n"
    "Registers are BRP,SJW,SAM,PS1,PS2,Prop and hold the quantity less one, as the\n"
    "parameters 410..415 and 420..425 do (D7). The manuals give neither clock nor\n"
    "family of the gateway's controllers: read them off the board. SP % is the sample\n"
    "point, osc. % what each oscillator may be off, bus m the longest bus in metres\n"
    "(D77).\n"
    "Exit code 1 when the controller forbids the registers, or when no registers\n"
    "make the rate.\n";

double positive(const Arguments& arguments, std::string_view key, std::string_view text, double most) {
    const std::optional<double> value = base::parse_real(text);
    if (!value || *value <= 0 || *value > most) {
        throw UsageError(fmt::format("{}: '{}' is not a number above 0 and up to {}", key,
                                     arguments.value(key), base::to_text(most)));
    }
    return *value;
}

// "16000000", "16M", "16MHz", "7372.8k"
std::uint32_t clock_of(const Arguments& arguments) {
    constexpr double highest = 1e9;
    const std::string given = arguments.value("--clock");
    std::string_view text = given;
    if (text.ends_with("Hz")) {
        text.remove_suffix(2);
    }
    double unit = 1;
    if (text.ends_with('M') || text.ends_with('k')) {
        unit = text.back() == 'M' ? 1e6 : 1e3;
        text.remove_suffix(1);
    }
    const double clock = positive(arguments, "--clock", text, highest) * unit;
    if (clock > highest || std::abs(clock - std::round(clock)) > 1e-6 || clock < 1) {
        throw UsageError(fmt::format("--clock: '{}' is not a whole number of Hz, 1 to 1000000000", given));
    }
    return static_cast<std::uint32_t>(std::round(clock));
}

Registers registers_of(const Arguments& arguments) {
    const std::string given = arguments.value("--registers");
    std::string_view rest = given;
    Registers registers;
    std::size_t count = 0;
    bool sound = true;
    while (sound) {
        const std::size_t comma = rest.find(',');
        const std::optional<std::int64_t> value = base::parse_integer(rest.substr(0, comma));
        sound = value && *value >= 0 && *value <= std::numeric_limits<std::uint8_t>::max() &&
                count < bit_timing::registers().size();
        if (sound) {
            registers.*bit_timing::registers()[count++].member = static_cast<std::uint32_t>(*value);
        }
        if (comma == std::string_view::npos) {
            break;
        }
        rest.remove_prefix(comma + 1);
    }
    if (!sound || count != bit_timing::registers().size()) {
        throw UsageError(
            fmt::format("--registers: '{}' is not six numbers: BRP,SJW,SAM,PS1,PS2,Prop", given));
    }
    return registers;
}

TimingLine line_of(const Timing& timing) {
    TimingLine line{.bit_rate = timing.bit_rate(), .timing = timing};
    line.remark = fmt::format("{}", fmt::join(bit_timing::violations(timing), "; "));
    return line;
}

std::vector<TimingLine> lines_of_rate(const bit_timing::Wish& wish, std::size_t most) {
    std::vector<TimingLine> lines;
    for (const Timing& timing : bit_timing::propose(wish)) {
        if (lines.size() < most) {
            lines.push_back(line_of(timing));
        }
    }
    if (lines.empty()) {
        lines.push_back({.bit_rate = wish.bit_rate, .remark = "this clock cannot make it"});
    }
    return lines;
}

std::vector<TimingLine> lines_of_controller(const Arguments& arguments) {
    Timing timing{.clock_hz = clock_of(arguments),
                  .controller = bit_timing::find_controller(arguments.value("--family"))};
    if (arguments.given("--registers")) {
        timing.registers = registers_of(arguments);
        return {line_of(timing)};
    }
    bit_timing::Wish wish{.clock_hz = timing.clock_hz, .controller = timing.controller};
    wish.sample_point = positive(arguments, "--sample-point", arguments.value("--sample-point"), 100) / 100;
    if (arguments.given("--rate")) {
        constexpr double highest_kbit = 1000;
        const double bit_rate = positive(arguments, "--rate", arguments.value("--rate"), highest_kbit) * 1000;
        wish.bit_rate = std::max(1U, static_cast<std::uint32_t>(std::round(bit_rate)));
        return lines_of_rate(wish, most_proposals);
    }
    std::vector<TimingLine> lines;
    for (const bit_timing::StandardRate& rate : bit_timing::standard_rates()) {
        wish.bit_rate = rate.bit_rate;
        lines.push_back(lines_of_rate(wish, 1).front());
    }
    return lines;
}

void refuse_contradictions(const Arguments& arguments) {
    const bool from_file = arguments.given("FILE");
    for (const std::string_view key : {"--clock", "--family", "--registers", "--rate", "--sample-point"}) {
        if (from_file && arguments.given(key)) {
            throw UsageError(fmt::format("{} and FILE exclude each other: the file states its own", key));
        }
    }
    if (!from_file && (!arguments.given("--clock") || !arguments.given("--family"))) {
        throw UsageError("FILE is missing, or --clock and --family of a controller");
    }
    if (arguments.given("--registers") && (arguments.given("--rate") || arguments.given("--sample-point"))) {
        throw UsageError("--registers go with neither --rate nor --sample-point");
    }
}

int run_bit_timing(const Arguments& arguments) {
    refuse_contradictions(arguments);
    int exit_code = exit_fine;
    std::vector<TimingLine> lines;
    if (arguments.given("FILE")) {
        const driver::CheckedFile file = driver::check_file(arguments.value("FILE"));
        report_findings(file, use_color(arguments, stderr));
        if (!file.valid()) {
            return exit_code_of(file);
        }
        lines = timing_lines(file.settings, file.configuration);
    } else {
        lines = lines_of_controller(arguments);
        const bool single = arguments.given("--registers") || arguments.given("--rate");
        exit_code = single && !lines.front().remark.empty() ? exit_findings : exit_fine;
    }
    const explain::TableFormat& format = *explain::find_table_format(arguments.value("--format"));
    return print(format.render(timing_table(lines))) ? exit_code : exit_environment;
}

}  // namespace

const Verb bit_timing_verb = {"bit-timing", "bit rates and the registers of CAN controllers",
                              bit_timing_options, run_bit_timing, bit_timing_details};

}  // namespace cgw::cli
