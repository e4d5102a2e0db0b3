// Inside the dbc room: the text of a database as tokens.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "diagnostic/location.hpp"

namespace cgw::dbc {

enum class TokenKind : std::uint8_t {
    word,    // a name or a keyword
    number,  // with a sign, a point and an exponent, where it has them
    text,    // without its quotes; may hold line ends
    sign,    // one character
};

struct Token {
    TokenKind kind = TokenKind::sign;
    std::string_view text;
    diagnostic::Position at;
    bool begins_line = false;  // nothing but blanks before it
};

// `open` is where a text begins that is not closed, {0, 0} otherwise: the rest of the file is that text.
struct Tokens {
    std::vector<Token> all;
    diagnostic::Position open{};
};

Tokens tokens_of(std::string_view text);

}  // namespace cgw::dbc
