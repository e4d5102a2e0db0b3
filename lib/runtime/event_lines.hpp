// What happens to the gateway, as lines for people.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "device/governor_link.hpp"
#include "link/gateway_end.hpp"

namespace cgw::runtime {

// The state, and each error that appeared or was cleared; an error that only sums up or repeats another one
// (3074, 12421..12424) has no line of its own.
std::vector<std::string> lines_of_change(const device::GatewayStatus& before,
                                         const device::GatewayStatus& now);

// "the governor is refused: …", with what differs
std::string line_of_refusal(const link::Refusal& refusal);

}  // namespace cgw::runtime
