#include "cli/cgw/simulation_run.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "base/numbers.hpp"
#include "base/utf8.hpp"
#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/simulation_display.hpp"
#include "cli/cgw/simulation_report.hpp"
#include "cli/cgw/terminal.hpp"
#include "media/loop.hpp"
#include "runtime/run.hpp"
#include "scenario/run.hpp"
#include "simulation/plant_log.hpp"

namespace cgw::cli {
namespace {

using scenario::Time;

constexpr media::Time repaint_period = 250'000;  // us of the clock on the wall
constexpr media::Time shortest_wait = 20'000;

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

// Said before a long run, not after it.
bool log_has_a_place(const std::string& path) {
    const std::filesystem::path directory = std::filesystem::absolute(path).parent_path();
    if (::access(directory.c_str(), W_OK | X_OK) == 0) {
        return true;
    }
    print_error(fmt::format("cannot write {}: {}", path, std::strerror(errno)));
    return false;
}

int write_log(const simulation::PlantLog& log, const SimulateOptions& options) {
    if (const base::Result<void> written = log.write(options.log, *options.log_format); !written) {
        print_error(written.error().message);
        return exit_environment;
    }
    if (log.left_out() != 0) {
        print_error(fmt::format("the log holds the first {} frames, {} more are left out", log.frames(),
                                log.left_out()));
    }
    return exit_fine;
}

}  // namespace

int simulate(const SimulateOptions& options, LoadedSimulation& loaded) {
    if (options.log_format && !log_has_a_place(options.log)) {
        return exit_environment;
    }
    const Configuration& governor = loaded.governor ? *loaded.governor : loaded.gateway;
    simulation::Installation installation(loaded.gateway.image, governor.image);
    if (installation.plant().status() != device::OpenStatus::ok) {
        print_error(fmt::format("the gateway refuses the configuration: {}",
                                device::to_text(installation.plant().status())));
        return exit_findings;
    }
    std::optional<simulation::PlantLog> log;
    if (options.log_format) {
        log.emplace(installation.plant());
    }
    const scenario::Scenario* scenario = loaded.scenario ? &loaded.scenario->scenario : nullptr;
    Output output(options);
    scenario::Run run(installation, scenario, loaded.end,
                      [&output](const scenario::Event& event) { output.show(event); });
    output.say(options.json ? introduction_json(installation.image(), scenario)
                            : introduction(installation.image(), scenario));
    const bool complete = run_to_end(run, options, output);
    output.say(options.json ? summary_json(run, complete) : summary(run, complete));
    const bool all_seen = complete || run.count().steps == run.steps();
    int code = run.count().failed == 0 && all_seen ? exit_fine : exit_findings;
    if (log) {
        code = worse(code, write_log(*log, options));
        if (code != exit_environment && !options.json) {
            output.say(fmt::format("{} frames in {}\n", log->frames(), base::printable(options.log)));
        }
    }
    return output.good() ? code : exit_environment;
}

int simulate_on_bus(const SimulateOptions& options, const LoadedSimulation& loaded) {
    runtime::Settings settings;
    settings.can2 = options.can2;
    settings.log = options.log;
    settings.duration = loaded.end;
    settings.introduction = introduction(loaded.gateway.image, nullptr);
    std::signal(SIGPIPE, SIG_IGN);  // whoever reads the lines may go; the gateway stays on its bus
    bool good = true;
    const runtime::Output output{
        .print = [&good](std::string_view text) { good = print(text) && good; },
        .complain = [](std::string_view line) { print_error(line); },
        .show = [](std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); },
    };
    switch (runtime::run(loaded.gateway.image, settings, output)) {
        case runtime::Ending::fine:
            return good ? exit_fine : exit_environment;
        case runtime::Ending::refused:
            return exit_findings;
        case runtime::Ending::environment:
            break;
    }
    return exit_environment;
}

}  // namespace cgw::cli
