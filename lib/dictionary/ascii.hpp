// Text for formats that carry ASCII only (EDS, DBC): accents go, umlauts are spelt out, signs become words.
#pragma once

#include <string>
#include <string_view>

namespace cgw::dictionary {

// Printable ASCII, never empty for a text that was not: "Größe 5 °C" becomes "Groesse 5 degC". Control
// characters become blanks; what has no counterpart, and every byte that is not UTF-8, becomes '?'.
std::string to_ascii(std::string_view utf8);

// False where to_ascii() has to put a '?' for something else.
bool has_ascii_form(std::string_view utf8);

// At most `length` characters; a text that had to be cut ends in "...".
std::string shortened(std::string_view ascii, std::size_t length);

}  // namespace cgw::dictionary
