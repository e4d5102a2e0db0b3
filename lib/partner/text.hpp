// Inside the partner room: texts and numbers as the languages take them.
#pragma once

#include <string>
#include <string_view>

namespace cgw::partner {

// For a comment of any of the languages: one line of ASCII, at most 160 characters. What could end a comment,
// begin another, continue a line or be a pragma (* / \ ? { } $ ` and double quotes) is left out or written
// otherwise.
std::string comment(std::string_view utf8);

// At most `bytes` bytes from the beginning, whole characters.
std::string_view cut(std::string_view utf8, std::size_t bytes);
inline constexpr std::size_t longest_unit = 64;  // bytes, in strings of the languages

// A string literal of C and C++ with its quotes: the bytes of `utf8`, nothing in it is a trigraph.
std::string c_string(std::string_view utf8);

// The same in Python, in ASCII: what is not well-formed becomes U+FFFD.
std::string python_string(std::string_view utf8);

// "4000.0", "0.0625", "1e-07": the shortest text that reads back as the same double, with a point or an
// exponent.
std::string real(double value);

// "TPDO4" becomes "tpdo4".
std::string lower(std::string_view ascii);
std::string upper(std::string_view ascii);

}  // namespace cgw::partner
