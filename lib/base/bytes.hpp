// The one type for the content of an artefact, text and binary alike.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cgw::base {

using Bytes = std::vector<std::uint8_t>;

inline Bytes to_bytes(const std::string& text) {
    return {text.begin(), text.end()};
}

}  // namespace cgw::base
