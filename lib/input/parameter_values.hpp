// The values of [governor.parameters] and [gateway.parameters].
#pragma once

#include "input/context.hpp"

namespace cgw::input {

// Reads one device's parameters (no table: there are none).
void read_parameters(Context& context, parameter::Device device, std::span<const toml::Entry* const> tables);

// After both devices are read: required parameters that neither stand there nor were rejected.
void report_missing(Context& context, parameter::Device device);

}  // namespace cgw::input
