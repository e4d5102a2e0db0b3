// How this program names things: as the simulation does.
#pragma once

#include "base/abort_codes.hpp"
#include "device/governor_link.hpp"
#include "simulation/text.hpp"

namespace cgw::gateway_cli {

using base::abort_text;
using device::to_text;
using simulation::clipped;
using simulation::line_width;
using simulation::parameter_text;
using simulation::pdo_text;
using simulation::to_text;
using simulation::value_text;

}  // namespace cgw::gateway_cli
