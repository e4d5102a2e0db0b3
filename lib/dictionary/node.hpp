// From the data sheet of a kind of device to the configuration of one node, and back.
#pragma once

#include "dictionary/dictionary.hpp"

namespace cgw::dictionary {

// Every value that follows the node number is resolved. Each variable of the device that states no value yet
// gets its default as the value, unless it has none or changes at run time.
Dictionary of_node(Dictionary sheet, std::uint8_t node_id);

// Without what only a configuration file holds: values, denotations and files of one node. What has been
// resolved stays resolved.
Dictionary without_node(Dictionary configuration);

}  // namespace cgw::dictionary
