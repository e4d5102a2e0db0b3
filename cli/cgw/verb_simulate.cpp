#include <fmt/format.h>

#include <csignal>
#include <optional>
#include <utility>

#include "base/files.hpp"
#include "base/json.hpp"
#include "base/numbers.hpp"
#include "base/utf8.hpp"
#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/shared_options.hpp"
#include "cli/cgw/simulation_display.hpp"
#include "cli/cgw/simulation_report.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"
#include "driver/outputs.hpp"
#include "driver/plant.hpp"
#include "driver/scenario_file.hpp"
#include "media/log.hpp"
#include "media/loop.hpp"
#include "scenario/run.hpp"

namespace cgw::cli {
namespace {

using scenario::Time;

constexpr double greatest_speed = 1000;
constexpr Time usual_duration = 10'000'000;
constexpr std::size_t most_logged_frames = 5'000'000;  // some 500 MB while the simulation runs
constexpr media::Time repaint_period = 250'000;        // us of the clock on the wall
constexpr media::Time shortest_wait = 20'000;

std::vector<Word> speed_words() {
    return {{"1", "as fast as the plant"}, {"max", "as fast as this machine"}};
}

std::vector<Word> simulate_format_words() {
    return {{"human", "lines for people"}, {"json", "one JSON object per line"}};
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
    "The governor link on CAN1 is our own protocol, not HEINZMANN's.\n"
    "Exit code 0 when everything expected was seen, 1 when something was not or a\n"
    "file has errors, 3 when something cannot be read or written.\n";

struct SimulateOptions {
    std::string file;
    std::string scenario;
    std::optional<double> speed;  // nothing: as fast as possible
    std::optional<Time> duration;
    std::string log;
    std::optional<media::LogFormat> log_format;
    bool json = false;
    bool live = false;
    bool color = false;         // of standard output
    bool color_errors = false;  // of the other stream
};

double positive_number(const Arguments& arguments, std::string_view key, double greatest) {
    const std::string text = arguments.value(key);
    const std::optional<double> number = base::parse_real(text);
    if (!number || !(*number > 0) || *number > greatest) {
        throw UsageError(fmt::format("{} {}: a number above 0 and up to {} is needed", key, text,
                                     base::to_text(greatest)));
    }
    return *number;
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
        options.duration = std::max<Time>(1, static_cast<Time>(seconds * 1e6 + 0.5));
    }
    options.log = arguments.value("--log");
    options.log_format = media::log_format_of(options.log);
    if (!options.log.empty() && !options.log_format) {
        throw UsageError(fmt::format("--log {}: the name must end in .log (candump) or .pcap", options.log));
    }
    options.json = arguments.value("--format") == "json";
    options.live = terminal && !options.json && !is_dumb_terminal();
    options.color = use_color(arguments, stdout) && !options.json;
    options.color_errors = use_color(arguments, stderr);
    return options;
}

// A configuration in memory; `image` is a view of the bytes.
struct Configuration {
    driver::CheckedFile file;
    base::Bytes bytes;
    image::Image image;
};

// Exit code; says on stderr what is wrong with the file.
int load(const std::string& path, bool color, Configuration& configuration) {
    configuration.file = driver::check_file(path);
    if (!configuration.file.valid()) {
        report_findings(configuration.file, color);
        return exit_code_of(configuration.file);
    }
    base::Result<base::Bytes> bytes = driver::image_bytes(configuration.file);
    if (!bytes) {
        print_error(bytes.error().message);
        return exit_usage;
    }
    configuration.bytes = std::move(*bytes);
    const image::Status status = image::Image::open(configuration.bytes, configuration.image);
    if (status != image::Status::ok) {
        print_error(fmt::format("the configuration is refused: {}", image::to_text(status)));
        return exit_findings;
    }
    return exit_fine;
}

int report_scenario(const driver::ScenarioFile& file, const std::string& path, bool color) {
    if (!file.findings.all().empty()) {
        diagnostic::RenderInput input;
        input.files.push_back({path, file.findings.all()});
        input.sources = file.sources;
        input.color = color;
        report_findings(input);
    }
    return file.unreadable ? exit_environment : file.findings.has_errors() ? exit_findings : exit_fine;
}

// Everything that a run needs, read and checked.
struct Loaded {
    Configuration gateway;
    std::optional<Configuration> governor;  // when it was set up with another file
    std::optional<driver::ScenarioFile> scenario;
    Time end = 0;
};

Time end_of(const SimulateOptions& options, const Loaded& loaded) {
    const scenario::Scenario* scenario = loaded.scenario ? &loaded.scenario->scenario : nullptr;
    if (scenario != nullptr && !scenario->steps.empty() && options.duration &&
        *options.duration < scenario->steps.back().at) {
        throw UsageError(fmt::format("--duration: the last step of the scenario is at {} s",
                                     base::to_text(static_cast<double>(scenario->steps.back().at) / 1e6)));
    }
    if (options.duration) {
        return *options.duration;
    }
    return scenario != nullptr ? scenario->duration : options.live ? canopen::never : usual_duration;
}

int load_governor(const SimulateOptions& options, Loaded& loaded) {
    const std::string& name = loaded.scenario->scenario.governor;
    if (name.empty()) {
        return exit_fine;
    }
    loaded.governor.emplace();
    return load(base::beside(options.scenario, name), options.color_errors, *loaded.governor);
}

int load(const SimulateOptions& options, Loaded& loaded) {
    std::string path = options.file;
    if (!options.scenario.empty()) {
        loaded.scenario = driver::read_scenario_file(options.scenario);
        if (!loaded.scenario->valid()) {
            return report_scenario(*loaded.scenario, options.scenario, options.color_errors);
        }
        const std::string& plant = loaded.scenario->scenario.plant;
        if (path.empty() && plant.empty()) {
            throw UsageError("FILE is missing: the scenario names no plant");
        }
        path = path.empty() ? base::beside(options.scenario, plant) : path;
    }
    if (const int code = load(path, options.color_errors, loaded.gateway); code != exit_fine) {
        return code;
    }
    if (loaded.scenario) {
        if (const int code = load_governor(options, loaded); code != exit_fine) {
            return code;
        }
        scenario::bind(loaded.scenario->scenario, loaded.gateway.image, loaded.scenario->findings);
        if (const int code = report_scenario(*loaded.scenario, options.scenario, options.color_errors);
            code != exit_fine) {
            return code;
        }
    }
    loaded.end = end_of(options, loaded);
    return exit_fine;
}

std::vector<std::string> inputs_of(const SimulateOptions& options, const Loaded& loaded) {
    std::vector<std::string> inputs = loaded.gateway.file.dependencies;
    if (loaded.governor) {
        inputs.insert(inputs.end(), loaded.governor->file.dependencies.begin(),
                      loaded.governor->file.dependencies.end());
    }
    if (loaded.scenario) {
        inputs.push_back(options.scenario);
    }
    return inputs;
}

// Both buses, as they are named in logs.
class FrameLog {
  public:
    void listen(simulation::Plant& plant) {
        plant.can1().observe([this](const frame::Frame& frame, Time now) { record("can1", frame, now); });
        plant.can2().observe([this](const frame::Frame& frame, Time now) { record("can2", frame, now); });
    }

    // Exit code.
    int write(const std::string& path, media::LogFormat format) const {
        const base::Result<base::Bytes> content = media::write_log(format, frames_);
        const base::Result<void> written =
            content ? base::write_file(path, *content) : tl::unexpected(content.error());
        if (!written) {
            print_error(written.error().message);
            return exit_environment;
        }
        if (lost_ != 0) {
            print_error(fmt::format("the log holds the first {} frames, {} more are left out", frames_.size(),
                                    lost_));
        }
        return exit_fine;
    }
    std::size_t frames() const { return frames_.size(); }

  private:
    void record(const char* bus, const frame::Frame& frame, Time now) {
        if (frames_.size() < most_logged_frames) {
            frames_.push_back({now, bus, frame});
        } else {
            ++lost_;
        }
    }

    std::vector<media::LoggedFrame> frames_;
    std::size_t lost_ = 0;
};

// Where events and states are shown; remembers a failure of standard output.
class Output {
  public:
    explicit Output(const SimulateOptions& options) : options_(&options), screen_(options.color) {}

    void show(const scenario::Event& event) {
        if (options_->live) {
            good_ = screen_.add(event_line(event, options_->color)) && good_;
        } else {
            say(options_->json ? event_json(event) : event_line(event, options_->color));
        }
    }
    void paint(simulation::Installation& installation) {
        if (options_->live) {
            loads_.look(installation.plant());
            const std::size_t rows = LiveScreen::rows();
            const std::string speed = options_->speed ? base::to_text(*options_->speed) : "max";
            good_ = screen_.paint(live_block(installation, loads_, speed, LiveScreen::columns(),
                                             rows > 2 ? rows - 2 : 1)) &&
                    good_;
        }
    }
    void leave() { screen_.leave(); }
    void say(const std::string& text) { good_ = good_ && print(text); }
    bool good() const { return good_; }

  private:
    const SimulateOptions* options_;
    LiveScreen screen_;
    BusLoads loads_;
    bool good_ = true;
};

// Runs to the end, or until a signal comes; true: to the end.
bool run_to_end(scenario::Run& run, const SimulateOptions& options, Output& output) {
    constexpr Time at_once = 1'000'000;  // simulated, between two looks at signals
    bool interrupted = false;
    media::Loop loop;
    media::Signals signals({SIGINT, SIGTERM}, [&](int) { interrupted = true; });
    loop.add(signals);
    const media::Time began = loop.now();
    media::Time next_paint = began;
    while (!run.over() && !interrupted && output.good()) {
        const Time farthest = run.installation().now() + at_once;
        Time target = farthest;
        if (options.speed) {
            const double passed = static_cast<double>(loop.now() - began) * *options.speed;
            target = std::min(target, static_cast<Time>(passed));
        }
        run.advance(std::min(target, run.end()));
        if (loop.now() >= next_paint) {
            output.paint(run.installation());
            next_paint = loop.now() + repaint_period;
        }
        const bool early = options.speed && target < farthest && !run.over();
        loop.turn(early ? loop.now() + shortest_wait : loop.now());
    }
    output.paint(run.installation());
    output.leave();
    return !interrupted;
}

int simulate(const SimulateOptions& options, Loaded& loaded) {
    const Configuration& governor = loaded.governor ? *loaded.governor : loaded.gateway;
    simulation::Installation installation(loaded.gateway.image, governor.image);
    if (installation.plant().status() != device::OpenStatus::ok) {
        print_error(fmt::format("the gateway refuses the configuration: {}",
                                device::to_text(installation.plant().status())));
        return exit_findings;
    }
    FrameLog log;
    if (options.log_format) {
        log.listen(installation.plant());
    }
    const scenario::Scenario* scenario = loaded.scenario ? &loaded.scenario->scenario : nullptr;
    Output output(options);
    scenario::Run run(installation, scenario, loaded.end,
                      [&output](const scenario::Event& event) { output.show(event); });
    output.say(options.json ? introduction_json(installation.image(), scenario)
                            : introduction(installation.image(), scenario));
    const bool complete = run_to_end(run, options, output);
    output.say(options.json ? summary_json(run, complete) : summary(run, complete));
    int code = run.count().failed == 0 ? exit_fine : exit_findings;
    if (options.log_format) {
        code = worse(code, log.write(options.log, *options.log_format));
        if (code != exit_environment && !options.json) {
            output.say(fmt::format("{} frames in {}\n", log.frames(), base::printable(options.log)));
        }
    }
    return output.good() ? code : exit_environment;
}

int run_simulate(const Arguments& arguments) {
    const SimulateOptions options = options_of(arguments);
    Loaded loaded;
    if (const int code = load(options, loaded); code != exit_fine) {
        return code;
    }
    if (!options.log.empty()) {
        if (const std::string why = driver::clash({options.log}, inputs_of(options, loaded)); !why.empty()) {
            print_error(why);
            return exit_usage;
        }
    }
    return simulate(options, loaded);
}

}  // namespace

const Verb simulate_verb = {"simulate", "run gateway, simulated governor and PLC, with or without a scenario",
                            simulate_options, run_simulate, simulate_details};

}  // namespace cgw::cli
