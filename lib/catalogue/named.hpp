// The cells `bits` and `values`: what single bits or values mean.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "catalogue/cells.hpp"

namespace cgw::catalogue {

// [{ bit = 3, name = "SerialNumberPage", text = "…" }, { bit = 1, last = 15, name = "Node{1}", … }]: with
// `last` bits bit..last, their texts counting along. Names and expanded texts are kept in `texts`. Ascending,
// each bit once, 0..31; what is wrong is reported and left out.
std::vector<parameter::NamedBit> named_bits(const toml::Node& value, std::deque<std::string>& texts,
                                            const Reporter& report);

// [{ value = 9, text = "…" }], ascending, each value once.
std::vector<parameter::NamedValue> named_values(const toml::Node& value, const Reporter& report);

}  // namespace cgw::catalogue
