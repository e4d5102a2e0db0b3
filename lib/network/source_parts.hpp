// What plants and other nodes have in common.
#pragma once

#include <vector>

#include "network/message.hpp"

namespace cgw::network {

// The requests to the SDO server of a node, and its answers (D75).
void add_sdo(std::vector<Message>& messages, unsigned node_id, const diagnostic::Location& where);

}  // namespace cgw::network
