// Numbers, booleans, dates and times as TOML 1.0 writes them.
#pragma once

#include <string_view>

#include "toml/document.hpp"

namespace cgw::toml {

enum class Verdict { ok, out_of_range, not_a_value };

struct Literal {
    Verdict verdict = Verdict::not_a_value;
    Node node;  // kind, text and value; no range
};

// The whole of `token` must be one literal. Out of range: an integer beyond 64 bits with sign, a decimal
// number beyond a double; infinities and NaN written as such are fine.
Literal read_literal(std::string_view token);

// dddd-dd-dd, whatever the digits.
bool looks_like_date(std::string_view token);

}  // namespace cgw::toml
