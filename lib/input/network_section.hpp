// [network]: the other nodes of the CANopen bus and what they send.
#pragma once

#include "input/table_reader.hpp"

namespace cgw::input {

extern const Table network_table;

}  // namespace cgw::input
