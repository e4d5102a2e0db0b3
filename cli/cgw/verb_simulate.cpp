#include <fmt/format.h>

#include <cmath>

#include "base/numbers.hpp"
#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/shared_options.hpp"
#include "cli/cgw/simulation_run.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"
#include "driver/outputs.hpp"
#include "media/open_channel.hpp"
#include "scenario/run.hpp"

namespace cgw::cli {
namespace {

using scenario::Time;

constexpr double greatest_speed = 1000;

std::vector<Word> speed_words() {
    return {{"1", "as fast as the plant"}, {"max", "as fast as this machine"}};
}

std::vector<Word> simulate_format_words() {
    return {{"human", "lines for people"}, {"json", "one JSON object per line"}};
}

std::vector<Word> bus_words() {
    std::vector<Word> words;
    for (const media::ChannelKind& kind : media::channel_kinds()) {
        words.push_back({kind.form, kind.summary});
    }
    return words;
}

constexpr Option simulate_options[] = {
    {.names = "FILE",
     .summary = "parameter file of the plant; without it the one that the scenario names",
     .completes = Completes::files},
    {.names = "--scenario",
     .value = "SCENARIO",
     .summary = "scenario file: what happens, and what is expected",
     .completes = Completes::files},
    {.names = "--speed",
     .value = "FACTOR",
     .summary = "simulated seconds per second, or max; default 1 on a terminal, max otherwise",
     .words = speed_words,
     .only_words = false},
    {.names = "--duration",
     .value = "SECONDS",
     .summary = "simulated time; default the scenario's, 10 without one, no end on a terminal"},
    {.names = "--can2",
     .value = "BUS",
     .summary = "in real time on a CAN bus, for a PLC of your own: hub:HOST:PORT[/NAME], …",
     .words = bus_words,
     .only_words = false},
    {.names = "--log",
     .value = "PATH",
     .summary = "write the frames of both buses: .log is candump, .pcap is pcap",
     .completes = Completes::files},
    {.names = "--format",
     .value = "FORMAT",
     .summary = "how events are printed",
     .default_value = "human",
     .words = simulate_format_words},
    color_option,
};

constexpr std::string_view simulate_details =
    "Runs the gateway of a parameter file with a simulated governor, an engine and a\n"
    "PLC: the PLC sends every active RPDO and the heartbeat that is watched, and\n"
    "starts the gateway after its boot-up. A scenario changes outputs, cuts buses,\n"
    "resets devices and says what is to be seen then; its steps are described in\n"
    "docs/scenarios.md. One line is printed per event, with its simulated time; on a\n"
    "terminal states and values stand below. SIGINT ends the run and prints the\n"
    "summary.\n"
    "With --can2 governor and gateway run in real time, and the PLC is whoever is on\n"
    "that bus: a hub, an interface of the kernel, a serial adapter. SIGUSR1 then\n"
    "prints the measurements, SIGUSR2 clears errors.\n"
    "The governor link on CAN1 is our own protocol, not HEINZMANN's.\n"
    "Exit code 0 when everything expected was seen; 1 when something was not, when a\n"
    "scenario was interrupted before its last step, or when a file has errors; 3 when\n"
    "something cannot be read or written.\n";

double positive_number(const Arguments& arguments, std::string_view key, double greatest) {
    const std::string text = arguments.value(key);
    const std::optional<double> number = base::parse_real(text);
    if (!number || !(*number > 0) || *number > greatest) {
        throw UsageError(fmt::format("{} {}: a number above 0 and up to {} is needed", key, text,
                                     base::to_text(greatest)));
    }
    return *number;
}

// On a bus there is no PLC of ours, and time passes by itself.
void refuse_on_bus(const Arguments& arguments) {
    for (const std::string_view other : {"--scenario", "--speed", "--format"}) {
        if (arguments.given("--can2") && arguments.given(other)) {
            throw UsageError(
                fmt::format("--can2 is for a PLC of your own, in real time: not with {}", other));
        }
    }
}

SimulateOptions options_of(const Arguments& arguments) {
    SimulateOptions options;
    options.file = arguments.value("FILE");
    options.scenario = arguments.value("--scenario");
    if (options.file.empty() && options.scenario.empty()) {
        throw UsageError("FILE is missing: name a parameter file, or a scenario that names one");
    }
    if (options.file == "-" && options.scenario == "-") {
        throw UsageError("standard input (-) can be read only once");
    }
    refuse_dash(arguments, "--log");
    const bool terminal = is_terminal(stdout);
    if (arguments.given("--speed") ? arguments.value("--speed") != "max" : terminal) {
        options.speed =
            arguments.given("--speed") ? positive_number(arguments, "--speed", greatest_speed) : 1;
    }
    if (arguments.given("--duration")) {
        const double seconds = positive_number(arguments, "--duration", scenario::longest_duration);
        options.duration = std::max<Time>(1, static_cast<Time>(std::llround(seconds * 1e6)));
    }
    refuse_on_bus(arguments);
    options.can2 = arguments.value("--can2");
    if (arguments.given("--can2")) {
        if (const std::string mistake = media::channel_mistake(options.can2); !mistake.empty()) {
            throw UsageError("--can2: " + mistake);
        }
    }
    options.log = arguments.value("--log");
    options.log_format = media::log_format_of(options.log);
    if (!options.log.empty() && !options.log_format) {
        throw UsageError(fmt::format("--log {}: the name must end in .log (candump) or .pcap", options.log));
    }
    options.json = arguments.value("--format") == "json";
    options.live = terminal && options.can2.empty() && !options.json && !is_dumb_terminal();
    options.color = use_color(arguments, stdout) && !options.json;
    options.color_errors = use_color(arguments, stderr);
    return options;
}

int run_simulate(const Arguments& arguments) {
    const SimulateOptions options = options_of(arguments);
    LoadedSimulation loaded;
    if (const int code = load_simulation(options, loaded); code != exit_fine) {
        return code;
    }
    if (!options.log.empty()) {
        if (const std::string why = driver::clash({options.log}, simulation_inputs(options, loaded));
            !why.empty()) {
            print_error(why);
            return exit_usage;
        }
    }
    return options.can2.empty() ? simulate(options, loaded) : simulate_on_bus(options, loaded);
}

}  // namespace

const Verb simulate_verb = {"simulate", "run gateway, simulated governor and PLC, with or without a scenario",
                            simulate_options, run_simulate, simulate_details};

}  // namespace cgw::cli
