#include "authoring/toml_text.hpp"

#include "base/json.hpp"

namespace cgw::authoring {

std::string toml_string(std::string_view text) {
    std::string quoted = base::json_quote(text);  // TOML's basic strings have JSON's escapes
    // DEL is a control character to TOML and none to JSON.
    for (std::size_t at = quoted.find('\x7F'); at != std::string::npos; at = quoted.find('\x7F', at)) {
        quoted.replace(at, 1, "\\u007F");
    }
    return quoted;
}

}  // namespace cgw::authoring
