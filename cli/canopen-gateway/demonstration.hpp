// What a CANopen master sees of the gateway, step by step.
#pragma once

#include "cli/canopen-gateway/plant_run.hpp"

namespace cgw::gateway_cli {

// False: the gateway did not boot, or did not reach Operational; the lines say so. A duration that ends early
// only ends the steps.
bool demonstrate(PlantRun& plant_run);

}  // namespace cgw::gateway_cli
