// The second judge of a TOML text: an independent parser that must agree with what the scanner read.
#pragma once

#include <optional>
#include <string>

#include "toml/complaint.hpp"
#include "toml/document.hpp"

namespace cgw::toml {

// nullopt when `text` is valid TOML and says the same as `document`: the same keys, kinds, strings and
// booleans, and the same integers unless written in binary.
std::optional<Complaint> judge(const std::string& text, const Node& document);

}  // namespace cgw::toml
