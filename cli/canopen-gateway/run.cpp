#include "cli/canopen-gateway/run.hpp"

#include <fmt/format.h>

#include "base/files.hpp"
#include "base/utf8.hpp"
#include "cli/canopen-gateway/demonstration.hpp"
#include "cli/canopen-gateway/display.hpp"
#include "cli/canopen-gateway/options.hpp"
#include "cli/canopen-gateway/plant_run.hpp"

namespace cgw::gateway_cli {
namespace {

constexpr std::size_t shown_id_bytes = 8;

std::string configuration_id(const image::Image& image) {
    std::string text;
    for (const std::uint8_t byte : image.configuration_id().first(shown_id_bytes)) {
        text += fmt::format("{:02x}", byte);
    }
    return text;
}

void introduce(const image::Image& image, std::ostream& out) {
    image::Label title;
    const bool titled = image.find_label(0, title) && !title.name.empty();
    out << clipped(fmt::format("canopen-gateway {}, configuration {}", CGW_VERSION, configuration_id(image)),
                   line_width)
        << '\n';
    if (titled) {
        out << clipped(title.name, line_width) << '\n';
    }
    const image::Bus can2 = image.can2();
    const std::string rate = can2.manual_timing ? fmt::format("manual bit timing, run at {} kbit/s",
                                                              simulation::manual_bit_rate_kbit)
                                                : fmt::format("{} kbit/s", can2.bit_rate_kbit);
    out << fmt::format("node {}, {}, governor main cycle {:.3f} ms\n", can2.own_node, rate,
                       static_cast<double>(image.governor().main_cycle_us) / 1000);
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

int run_plant(const Options& options, const image::Image& image, std::ostream& out, std::ostream& error) {
    PlantRun plant_run(image, options.duration_us, out);
    if (plant_run.plant().status() != device::OpenStatus::ok) {
        error << fmt::format("canopen-gateway: the embedded configuration is refused: {}\n",
                             device::to_text(plant_run.plant().status()));
        return exit_refused;
    }
    introduce(image, out);
    bool fine = true;
    if (options.master) {
        fine = demonstrate(plant_run);
    } else {
        plant_run.run_for(options.duration_us);
    }
    summarise(plant_run, out);
    if (!options.log.empty()) {
        const auto written = base::write_file(options.log, plant_run.log().content());
        if (!written) {
            error << "canopen-gateway: " << base::printable(written.error().message) << '\n';
            return exit_environment;
        }
        out << clipped(fmt::format("log of {} frames: {}", plant_run.log().frames(), options.log), line_width)
            << '\n';
    }
    return fine ? exit_fine : exit_refused;
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
    return run_plant(options, image, out, error);
}

}  // namespace cgw::gateway_cli
