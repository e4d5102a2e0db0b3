#include "cli/cgw/simulation_inputs.hpp"

#include <fmt/format.h>

#include <utility>

#include "base/files.hpp"
#include "base/numbers.hpp"
#include "cli/cgw/command.hpp"
#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/terminal.hpp"
#include "driver/plant.hpp"
#include "scenario/run.hpp"

namespace cgw::cli {
namespace {

constexpr simulation::Time usual_duration = 10'000'000;  // us

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

simulation::Time end_of(const SimulateOptions& options, const LoadedSimulation& loaded) {
    const scenario::Scenario* scenario = loaded.scenario ? &loaded.scenario->scenario : nullptr;
    if (scenario != nullptr && !scenario->steps.empty() && options.duration &&
        *options.duration < scenario->steps.back().at) {
        throw UsageError(fmt::format("--duration: the last step of the scenario is at {} s",
                                     base::to_text(static_cast<double>(scenario->steps.back().at) / 1e6)));
    }
    if (options.duration) {
        return *options.duration;
    }
    return scenario != nullptr                     ? scenario->duration
           : options.live || !options.can2.empty() ? canopen::never
                                                   : usual_duration;
}

int load_governor(const SimulateOptions& options, LoadedSimulation& loaded) {
    const std::string& name = loaded.scenario->scenario.governor;
    if (name.empty()) {
        return exit_fine;
    }
    loaded.governor.emplace();
    return load(base::beside(options.scenario, name), options.color_errors, *loaded.governor);
}

}  // namespace

int load_simulation(const SimulateOptions& options, LoadedSimulation& loaded) {
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

std::vector<std::string> simulation_inputs(const SimulateOptions& options, const LoadedSimulation& loaded) {
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

}  // namespace cgw::cli
