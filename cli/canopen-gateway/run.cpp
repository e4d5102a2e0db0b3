#include "cli/canopen-gateway/run.hpp"

#include <fmt/format.h>

#include <csignal>

#include "base/sha256.hpp"
#include "base/utf8.hpp"
#include "cli/canopen-gateway/demonstration.hpp"
#include "cli/canopen-gateway/display.hpp"
#include "cli/canopen-gateway/options.hpp"
#include "cli/canopen-gateway/plant_run.hpp"
#include "media/log.hpp"
#include "runtime/run.hpp"
#include "simulation/plant_log.hpp"

namespace cgw::gateway_cli {
namespace {

// `simulated_can2`: a bus with manual timing runs at a rate of our choice.
std::string introduction(const image::Image& image, bool simulated_can2) {
    image::Label title;
    const bool titled = image.find_label(0, title) && !title.name.empty();
    std::string text = fmt::format("canopen-gateway {}, configuration {}\n", CGW_VERSION,
                                   base::short_id(image.configuration_id()));
    if (titled) {
        text += clipped(base::printable(title.name), line_width) + "\n";
    }
    const image::Bus can2 = image.can2();
    std::string rate = fmt::format("{} kbit/s", can2.bit_rate_kbit);
    if (can2.manual_timing) {
        rate = simulated_can2
                   ? fmt::format("manual bit timing, run at {} kbit/s", simulation::manual_bit_rate_kbit)
                   : "manual bit timing";
    }
    text += fmt::format("node {}, {}, governor main cycle {:.3f} ms\n", can2.own_node, rate,
                        static_cast<double>(image.governor().main_cycle_us) / 1000);
    return text;
}

void summarise(PlantRun& plant_run, std::ostream& out) {
    simulation::Bus& bus = plant_run.plant().can2();
    const canopen::Slave& slave = plant_run.plant().gateway().slave();
    const double load = 100.0 * static_cast<double>(bus.busy_time()) / static_cast<double>(plant_run.now());
    out << fmt::format("{} frames on CAN2, bus load {:.1f} %, gateway {}\n", bus.frames(), load,
                       to_text(plant_run.plant().gateway().state()));
    out << fmt::format("boot-ups {}, heartbeats {}, TPDOs {}, RPDOs {}, SDO answers {}, aborts {}\n",
                       plant_run.node().boot_ups().size(), plant_run.node().heartbeats().size(),
                       slave.transmitter().counters().sent, slave.receiver().counters().received,
                       slave.sdo().counters().answers, slave.sdo().counters().aborts);
}

void complain(std::ostream& error, std::string_view line) {
    error << "canopen-gateway: " << base::printable(line) << '\n' << std::flush;
}

int run_plant(const Options& options, const image::Image& image, std::ostream& out, std::ostream& error) {
    const std::uint64_t duration = options.duration_us.value_or(simulated_duration_us);
    PlantRun plant_run(image, duration, out);
    if (plant_run.plant().status() != device::OpenStatus::ok) {
        error << fmt::format("canopen-gateway: the embedded configuration is refused: {}\n",
                             device::to_text(plant_run.plant().status()));
        return exit_refused;
    }
    std::optional<simulation::PlantLog> log;
    if (!options.log.empty()) {
        log.emplace(plant_run.plant());
    }
    out << introduction(image, true);
    bool fine = true;
    if (options.master) {
        fine = demonstrate(plant_run);
    } else {
        plant_run.run_for(duration);
    }
    summarise(plant_run, out);
    if (log) {
        const base::Result<void> written =
            log->write(options.log, media::log_format_of(options.log).value_or(media::LogFormat::candump));
        if (!written) {
            complain(error, written.error().message);
            return exit_environment;
        }
        out << clipped(fmt::format("log of {} frames: {}", log->frames(), base::printable(options.log)),
                       line_width)
            << '\n';
    }
    return fine ? exit_fine : exit_refused;
}

int run_in_real_time(const Options& options, const image::Image& image, std::ostream& out,
                     std::ostream& error) {
    runtime::Settings settings;
    settings.can1 = options.can1;
    settings.can2 = options.can2;
    settings.log = options.log;
    settings.state = options.state;
    settings.duration = options.duration_us.value_or(media::never);
    settings.status_at_end = options.status;
    settings.introduction = introduction(image, false);
    const runtime::Output output{
        .print = [&out](std::string_view text) { out << text << std::flush; },
        .complain = [&error](std::string_view line) { complain(error, line); },
        .show = [&error](std::string_view text) { error << text << std::flush; },
    };
    std::signal(SIGPIPE, SIG_IGN);  // whoever reads the lines may go; the gateway stays
    switch (runtime::run(image, settings, output)) {
        case runtime::Ending::fine:
            break;
        case runtime::Ending::refused:
            return exit_refused;
        case runtime::Ending::environment:
            return exit_environment;
    }
    return exit_fine;
}

}  // namespace

int run(std::span<const char* const> arguments, std::span<const std::uint8_t> image_bytes, std::ostream& out,
        std::ostream& error) {
    Options options;
    std::string mistake;
    if (!parse_options(arguments, options, mistake)) {
        error << "canopen-gateway: " << base::printable(mistake) << '\n';
        return exit_usage;
    }
    if (options.help) {
        out << help_text();
        return exit_fine;
    }
    if (options.version) {
        out << "canopen-gateway " << CGW_VERSION << '\n';
        return exit_fine;
    }
    image::Image image;
    const image::Status status = image::Image::open(image_bytes, image);
    if (status != image::Status::ok) {
        error << fmt::format("canopen-gateway: the embedded configuration is refused: {} (status {})\n",
                             image::to_text(status), static_cast<int>(status));
        return exit_refused;
    }
    return options.real_time() ? run_in_real_time(options, image, out, error)
                               : run_plant(options, image, out, error);
}

}  // namespace cgw::gateway_cli
