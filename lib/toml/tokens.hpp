// The bytes of a text that make a bare key or a literal, before anyone knows what they mean.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cgw::toml {

bool is_bare_key_character(char c);

// The number, boolean, date or time that begins at `begin`, or whatever stands there instead; a date and its
// time may be separated by one blank.
std::string_view literal_token(std::string_view text, std::size_t begin);

// A token for messages, cut short when it is very long.
std::string shortened(std::string_view token);

// What the author of a token that is no value may have meant; empty when nobody knows.
std::string advice_about(std::string_view token);

}  // namespace cgw::toml
