// The causes of errors that come from outside: drivers, supply, memory tests. What the gateway sees itself (a
// late RPDO, a lost heartbeat, a silent governor) is brought about, not reported.
#pragma once

#include <span>
#include <string_view>

#include "device/gateway_errors.hpp"

namespace cgw::simulation {

struct NamedFault {
    std::string_view name;
    device::Fault fault;
    std::string_view summary;
};

std::span<const NamedFault> named_faults();

}  // namespace cgw::simulation
