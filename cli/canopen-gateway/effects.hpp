// Process data as the master sees them: the transmit PDOs' words, and what a receive PDO changes.
#pragma once

#include "cli/canopen-gateway/plant_run.hpp"

namespace cgw::gateway_cli {

void show_transmit_pdos(PlantRun& plant_run);

// Changes a sensor and a switch, where the configuration has them, and shows which transmit words follow.
void show_effects(PlantRun& plant_run);

}  // namespace cgw::gateway_cli
