// The faults that a scenario can bring about by name. Those of the devices come from outside: drivers,
// supply, memory tests; what the gateway sees itself (a late RPDO, a lost heartbeat, a silent governor) is
// brought about, not reported. Those of the engine raise the governor's alarms (simulation/alarms.hpp).
#pragma once

#include <span>
#include <string_view>
#include <variant>

#include "device/gateway_errors.hpp"
#include "simulation/engine.hpp"

namespace cgw::simulation {

struct NamedFault {
    std::string_view name;
    std::variant<device::Fault, EngineFault> cause;
    std::string_view summary;
};

std::span<const NamedFault> named_faults();

}  // namespace cgw::simulation
