#include "catalogue/kinds.hpp"

#include <algorithm>

namespace cgw::catalogue {

namespace {

using parameter::List;
using parameter::Role;

// Ranges: 48nn and 49nn by D17; 8nn and 9nn print none, a signed word by D19. 810/4810, the engine stop, is
// known already and not to be declared.
constexpr Kind table[] = {
    {"parameter", 1, 29999, 0, false, List::parameter, Role::none, false, 0, 0},
    {"measurement", 1, 29999, 1, false, List::measurement, Role::none, false, 0, 0},
    {"function", 1, 29999, 0, false, List::function, Role::none, false, 0, 0},
    {"curve", 1, 29999, 0, false, List::curve, Role::none, false, 0, 0},
    {"switch", 810, 849, 811, true, List::parameter, Role::switch_assignment, true, -32768, 32767},
    {"switch", 4810, 4849, 4811, true, List::function, Role::switch_type, true, 0, 4},
    {"sensor", 900, 929, 900, true, List::parameter, Role::sensor_assignment, true, -32768, 32767},
    {"sensor", 4900, 4929, 4900, true, List::function, Role::sensor_type, true, 0, 4},
};

}  // namespace

std::span<const Kind> all_kinds() {
    return table;
}

const Kind* find_kind(std::string_view name, parameter::Device device, std::uint16_t number) {
    const auto* const end = std::end(table);
    const auto* const place = std::find_if(std::begin(table), end, [&](const Kind& kind) {
        return kind.name == name && number >= kind.first && number <= kind.last &&
               (!kind.governor_only || device == parameter::Device::governor);
    });
    return place != end ? place : nullptr;
}

std::string_view kind_of(const parameter::Row& row) {
    const auto* const place = std::find_if(std::begin(table), std::end(table), [&](const Kind& kind) {
        return kind.list == row.list && kind.role == row.role;
    });
    return place != std::end(table) ? place->name : std::string_view{};
}

}  // namespace cgw::catalogue
