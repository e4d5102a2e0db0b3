// Inside the proof room: what all proofs have in common.
#pragma once

#include <string>
#include <string_view>

#include "proof/proof.hpp"

namespace cgw::proof {

// `found` as configuration_id() tells it of the artefact: a difference, or not compared where there is none.
void compare_id(Proof& proof, std::string_view expected, const std::string& found);

}  // namespace cgw::proof
