// The values of [governor.parameters] and [gateway.parameters].
#pragma once

#include "input/context.hpp"

namespace cgw::input {

// Reads one device's parameters (no table: there are none) and says which required ones are missing.
void read_parameters(Context& context, parameter::Device device, std::span<const toml::Entry* const> tables);

}  // namespace cgw::input
