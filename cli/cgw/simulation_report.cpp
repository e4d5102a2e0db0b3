#include "cli/cgw/simulation_report.hpp"

#include <fmt/format.h>

#include "base/json.hpp"
#include "base/sha256.hpp"
#include "base/utf8.hpp"
#include "simulation/text.hpp"

namespace cgw::cli {
namespace {

constexpr int format_version = 1;

std::string title_of(const image::Image& image) {
    image::Label title;
    return image.find_label(0, title) ? std::string(title.name) : "";
}

std::string rate_of(const image::Bus& bus) {
    return fmt::format("{} kbit/s{}", simulation::bus_bit_rate_kbit(bus),
                       bus.manual_timing ? " (manual timing)" : "");
}

double load_of(const simulation::Bus& bus) {
    return bus.now() == 0 ? 0 : 100.0 * static_cast<double>(bus.busy_time()) / static_cast<double>(bus.now());
}

std::string clipped_line(std::string_view text) {
    return simulation::clipped(base::printable(text), simulation::line_width) + '\n';
}

std::string verdict(const scenario::Run& run) {
    const scenario::Run::Count& count = run.count();
    if (count.failed != 0) {
        return fmt::format("not as expected: {} of {} steps failed\n", count.failed, count.steps);
    }
    return count.expectations == 0 ? ""
                                   : fmt::format("as expected: {} of {} expectations met\n",
                                                 count.expectations, count.expectations);
}

}  // namespace

std::string introduction(const image::Image& image, const scenario::Scenario* scenario) {
    const std::string title = title_of(image);
    std::string text = clipped_line(fmt::format("{}{}configuration {}", title, title.empty() ? "" : ", ",
                                                base::short_id(image.configuration_id())));
    text += clipped_line(fmt::format("node {}, CAN1 {}, CAN2 {}, main cycle {:.3f} ms", image.can2().own_node,
                                     rate_of(image.can1()), rate_of(image.can2()),
                                     static_cast<double>(image.governor().main_cycle_us) / 1000));
    if (scenario != nullptr) {
        text += clipped_line(
            fmt::format("scenario: {}", scenario->title.empty() ? scenario->path : scenario->title));
    }
    return text;
}

std::string introduction_json(const image::Image& image, const scenario::Scenario* scenario) {
    base::JsonWriter json;
    json.begin_object();
    json.key("format_version").integer(format_version);
    json.key("event").string("begin");
    json.key("title").string(title_of(image));
    json.key("configuration_id").string(base::short_id(image.configuration_id()));
    json.key("node_id").integer(image.can2().own_node);
    if (scenario != nullptr) {
        json.key("scenario").string(scenario->title);
    }
    json.end_object();
    return json.take();
}

std::string summary(scenario::Run& run, bool complete) {
    simulation::Plant& plant = run.installation().plant();
    const auto bus_text = [](std::string_view name, const simulation::Bus& bus) {
        return fmt::format("{} {} frames, load {:.1f} %", name, bus.frames(), load_of(bus));
    };
    std::string text;
    if (!complete) {
        text += run.steps() == 0
                    ? std::string("interrupted\n")
                    : fmt::format("interrupted after {} of {} steps\n", run.count().steps, run.steps());
    }
    text += fmt::format("{:.3f} s, gateway {}\n{}; {}\n", static_cast<double>(plant.now()) / 1e6,
                        simulation::to_text(plant.gateway().state()), bus_text("CAN1", plant.can1()),
                        bus_text("CAN2", plant.can2()));
    return text + verdict(run);
}

std::string summary_json(scenario::Run& run, bool complete) {
    simulation::Plant& plant = run.installation().plant();
    base::JsonWriter json;
    json.begin_object();
    json.key("time_us").integer(static_cast<std::int64_t>(plant.now()));
    json.key("event").string("end");
    json.key("complete").boolean(complete);
    json.key("state").string(simulation::to_text(plant.gateway().state()));
    json.key("frames").begin_array();
    json.integer(static_cast<std::int64_t>(plant.can1().frames()));
    json.integer(static_cast<std::int64_t>(plant.can2().frames()));
    json.end_array();
    json.key("steps").integer(static_cast<std::int64_t>(run.count().steps));
    json.key("expectations").integer(static_cast<std::int64_t>(run.count().expectations));
    json.key("failed").integer(static_cast<std::int64_t>(run.count().failed));
    json.end_object();
    return json.take();
}

}  // namespace cgw::cli
