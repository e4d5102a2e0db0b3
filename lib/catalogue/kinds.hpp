// What `kind` means, by number: lists, roles and the ranges that follow from them.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "parameter/row.hpp"

namespace cgw::catalogue {

struct Kind {
    std::string_view name;
    std::uint16_t first;  // numbers it may have
    std::uint16_t last;
    std::uint16_t first_declared;  // lowest number a declaration may have; 0: not in declarations
    bool governor_only;
    parameter::List list;
    parameter::Role role;
    bool ranged;  // the range below holds where none is given
    double minimum;
    double maximum;
};

std::span<const Kind> all_kinds();

// The kind of that name for that number; nullptr when there is none.
const Kind* find_kind(std::string_view name, parameter::Device device, std::uint16_t number);

// The name that describes a row: "switch", "measurement", …
std::string_view kind_of(const parameter::Row& row);

}  // namespace cgw::catalogue
