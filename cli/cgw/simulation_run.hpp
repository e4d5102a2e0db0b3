// A simulation from its first event to its summary.
#pragma once

#include "cli/cgw/simulation_inputs.hpp"

namespace cgw::cli {

// In simulated time, with a PLC and perhaps a scenario. Exit code.
int simulate(const SimulateOptions& options, LoadedSimulation& loaded);

// Gateway and simulated governor in real time, CAN2 being a bus where others are. Exit code.
int simulate_on_bus(const SimulateOptions& options, const LoadedSimulation& loaded);

}  // namespace cgw::cli
