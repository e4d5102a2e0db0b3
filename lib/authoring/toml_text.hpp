// Pieces of TOML as a parameter file is written.
#pragma once

#include <string>
#include <string_view>

namespace cgw::authoring {

// A basic string with its quotes, everything escaped that TOML wants escaped.
std::string toml_string(std::string_view text);

}  // namespace cgw::authoring
