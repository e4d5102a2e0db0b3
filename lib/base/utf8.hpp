// UTF-8 well-formedness (RFC 3629): no overlong forms, no surrogates, at most U+10FFFF.
#pragma once

#include <cstddef>
#include <string_view>

namespace cgw::base {

// Bytes of the character at the start of `text`, 1..4; 0 when it is not well-formed or `text` is empty.
std::size_t utf8_sequence_length(std::string_view text);

}  // namespace cgw::base
