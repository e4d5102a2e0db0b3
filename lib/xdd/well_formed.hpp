// Inside the xdd room: what XML demands and pugixml lets pass.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace cgw::xdd {

struct Fault {
    std::size_t offset = 0;  // into the text
    std::string what;        // lower case, no final period
};

// The first fault of a text that pugixml has read: characters and references that XML does not have, `<` in a
// value, an attribute that stands twice, text outside of the root element, `--` in a comment. Linear; nothing (nullopt): there is none.
std::optional<Fault> find_fault(std::string_view text);

}  // namespace cgw::xdd
