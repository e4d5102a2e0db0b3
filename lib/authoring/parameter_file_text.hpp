// A parameter file (format 1) written from values, with what the catalogue says about each as comments.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "parameter/catalogue.hpp"
#include "parameter/settings.hpp"

namespace cgw::authoring {

struct WrittenValue {
    const parameter::Row* row = nullptr;
    std::string literal;  // as TOML takes it: "250", "1.0", "0x282"
};

struct Draft {
    std::string title;                           // "": no title
    std::optional<std::uint32_t> main_cycle_us;  // of the governor; none: the usual one
    std::vector<std::string> remarks;            // lines of comment at the top, without '#'
    parameter::DocumentInformation document;     // what is empty, 0 or not stated: left out
    parameter::Identity identity;                // all 0: left out
    std::optional<parameter::BitTiming> can1_bit_timing;
    std::optional<parameter::BitTiming> can2_bit_timing;
    std::vector<std::uint8_t> network_nodes;
    std::vector<const parameter::Row*> declarations;  // of the governor, by number
    std::vector<WrittenValue> governor;               // ascending by number
    std::vector<WrittenValue> gateway;
};

// Parameters in the order given, named as the manuals print them; unit, text and, for what a TPDO carries,
// the name of the measurement as comments. Short arrays that are there whole are written as a list.
std::string parameter_file_text(const Draft& draft, const parameter::Catalogue& catalogue);

}  // namespace cgw::authoring
