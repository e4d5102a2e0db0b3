// The files that a simulation needs, read and checked.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/cgw/simulation_options.hpp"
#include "driver/check_file.hpp"
#include "driver/scenario_file.hpp"
#include "image/image.hpp"

namespace cgw::cli {

// A configuration in memory; `image` is a view of the bytes.
struct Configuration {
    driver::CheckedFile file;
    base::Bytes bytes;
    image::Image image;
};

// Everything that a run needs, read and checked.
struct LoadedSimulation {
    Configuration gateway;
    std::optional<Configuration> governor;  // when it was set up with another file
    std::optional<driver::ScenarioFile> scenario;
    simulation::Time end = 0;
};

// Exit code; says on stderr what is wrong with the files. Throws UsageError.
int load_simulation(const SimulateOptions& options, LoadedSimulation& loaded);

// All files that were read, none of which the log may be.
std::vector<std::string> simulation_inputs(const SimulateOptions& options, const LoadedSimulation& loaded);

}  // namespace cgw::cli
