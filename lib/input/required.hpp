// Parameters whose absence is a finding of its own.
#pragma once

#include <cstdint>

#include "parameter/row.hpp"

namespace cgw::input {

// No default: nobody can guess them. A bit rate gives way to manual timing.
struct Required {
    parameter::Device device;
    std::uint16_t number;
    std::uint16_t manual_timing;  // when this one is 1 the number may be missing; 0: never
};

inline constexpr Required required_parameters[] = {
    {parameter::Device::governor, 401, 0},    {parameter::Device::governor, 403, 0},
    {parameter::Device::governor, 416, 4416}, {parameter::Device::gateway, 401, 0},
    {parameter::Device::gateway, 402, 0},     {parameter::Device::gateway, 416, 4416},
    {parameter::Device::gateway, 426, 4426},  {parameter::Device::gateway, 427, 0},
};

// Not required, but next to no file is right without them (manual 7.1.1, 7.2.1).
struct Expected {
    parameter::Device device;
    std::uint16_t number;
};

inline constexpr Expected communication_switches[] = {
    {parameter::Device::governor, 4406},
    {parameter::Device::gateway, 4400},
};

}  // namespace cgw::input
