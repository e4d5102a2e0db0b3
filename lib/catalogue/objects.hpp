// What the objects of the Gateway hold, bit by bit where bits have a meaning: schemas/objects/*.toml,
// compiled in. Names, types and access of objects stand in the room `profile`.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "parameter/catalogue.hpp"

namespace cgw::catalogue {

struct ObjectDescription {
    std::uint16_t index = 0;
    bool whole = false;          // the object itself, not one of its entries
    std::uint8_t first_sub = 0;  // entries first_sub..last_sub
    std::uint8_t last_sub = 0;
    std::string_view text{};
    std::string_view source{};        // parameters it comes from; "" for none
    std::uint16_t bit_parameter = 0;  // shown by bit 0 of first_sub; 0: bits are no parameters (D21, D52)
    std::uint8_t bit_count = 0;       // bits of an entry that are parameters
    std::span<const parameter::NamedBit> bits{};
    std::string_view section{};
};

// Sorted by index, the whole object before its entries.
std::span<const ObjectDescription> shipped_objects();

// nullptr when the object is not described: the Gateway has none of that index.
const ObjectDescription* find_object(std::uint16_t index);

// The entry's own description; the object's where a VAR is asked for with sub 0 or the entry has none.
const ObjectDescription* find_object(std::uint16_t index, std::uint8_t sub);

// The bits of an entry that have a meaning, ascending: those named in the table, and those that are
// parameters (2000h:1..6, 2005h), with the parameter's name and text. A parameter that only one device knows
// has that device's name; where both know it, the gateway's.
std::vector<parameter::NamedBit> object_bits(std::uint16_t index, std::uint8_t sub,
                                             const parameter::Catalogue& catalogue);

struct ObjectBit {
    std::uint16_t index = 0;
    std::uint8_t sub = 0;
    std::uint8_t bit = 0;
};

// Where a bit parameter is seen in the object dictionary: 12412 is bit 1 of 2005h, 3074 bit 10 of 2000h:5.
std::optional<ObjectBit> find_object_bit(std::uint16_t number);

}  // namespace cgw::catalogue
