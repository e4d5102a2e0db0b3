// What a file says of a device, and of one node where it is a configuration.
#pragma once

#include <optional>

#include "dictionary/dictionary.hpp"

namespace cgw::convert {

struct Description {
    dictionary::Dictionary dictionary;
    std::optional<dictionary::Commissioning> node;

    friend bool operator==(const Description&, const Description&) = default;
};

}  // namespace cgw::convert
