// What no check can know about these settings.
#pragma once

#include <string>
#include <vector>

#include "check/checks.hpp"

namespace cgw::check {

// One line each of at most 80 columns, for people, in a fixed order; only what applies. For settings without
// errors: what an error leaves open is the error's business.
std::vector<std::string> not_verified(const Context& context);

}  // namespace cgw::check
