// UTF-8 well-formedness (RFC 3629): no overlong forms, no surrogates, at most U+10FFFF.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cgw::base {

// Bytes of the character at the start of `text`, 1..4; 0 when it is not well-formed or `text` is empty.
std::size_t utf8_sequence_length(std::string_view text);

// A text that is UTF-8 as it is, any other one taken as Latin-1.
std::string to_utf8(std::string_view text);

// Columns that UTF-8 text takes on a terminal; every character counts one.
std::size_t width_of(std::string_view text);

// Characters that steer a terminal or hide what stands there: C0 and C1 controls, DEL, line and paragraph
// separators, zero-width and bidirectional controls. `character` is one well-formed sequence.
bool is_control(std::string_view character);

bool has_control(std::string_view text);

// Every control character, and every byte that is not UTF-8, as '?'. What a person reads passes through
// here, so that no file, name or argument can steer the terminal.
std::string printable(std::string_view text);

}  // namespace cgw::base
