// Environment failures (cannot read, cannot write, disk full) travel as Result; mistakes of the user
// are diagnostics instead and never end the work at the first one.
#pragma once

#include <string>
#include <tl/expected.hpp>

namespace cgw::base {

struct Failure {
    std::string message;     // lower case, no final period, names the path
    bool too_large = false;  // reading stopped at the caller's limit
};

template <typename T>
using Result = tl::expected<T, Failure>;

inline tl::unexpected<Failure> failure(std::string message) {
    return tl::unexpected<Failure>(Failure{std::move(message), false});
}

}  // namespace cgw::base
