// Inside the emit room: the configuration of the one node that a plant describes, whatever form it is written
// in.
#pragma once

#include <string>

#include "emit/emitter.hpp"

namespace cgw::emit {

struct NodeFile {
    dictionary::Dictionary dictionary;  // with the values of the node
    dictionary::Commissioning node;
};

NodeFile node_file(const Plant& plant, const Options& options, std::string file_name);

}  // namespace cgw::emit
