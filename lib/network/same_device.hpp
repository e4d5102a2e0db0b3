// Whether a description is that of a gateway which a parameter file tells already.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "network/message.hpp"

namespace cgw::network {

// What tells a node from a plant with the same node id, for people; empty where they are the same device:
// both send and receive the same messages, with the same bytes at the same times. Objects carry whole
// milliseconds (D31), so times are compared as such. `plant` may have messages of others, which do not count.
std::string difference_between(std::span<const Message> plant, std::span<const Message> node,
                               std::uint8_t node_id);

}  // namespace cgw::network
