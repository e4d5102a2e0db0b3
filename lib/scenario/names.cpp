#include "scenario/names.hpp"

#include <fmt/format.h>

#include <vector>

#include "catalogue/catalogue.hpp"
#include "facts/gateway.hpp"

namespace cgw::scenario {
namespace {

using parameter::Device;

const parameter::Catalogue& shipped() {
    static const parameter::Catalogue catalogue{catalogue::shipped_rows()};
    return catalogue;
}

// The gateway shows the errors of both devices; where only the governor has a name for one, that counts.
const parameter::Row* row_of(std::uint16_t number) {
    const parameter::Row* row = shipped().find(Device::gateway, number);
    return row != nullptr ? row : shipped().find(Device::governor, number);
}

}  // namespace

bool is_error(std::uint16_t number) {
    return facts::is_error_number(number) ||
           (number >= facts::first_canopen_error && number <= facts::last_canopen_error);
}

std::optional<std::uint16_t> error_by_name(std::string_view name) {
    for (const Device device : {Device::gateway, Device::governor}) {
        const parameter::Row* row = shipped().find(device, name);
        if (row != nullptr && is_error(row->number)) {
            return row->number;
        }
    }
    return std::nullopt;
}

std::span<const std::string_view> error_names() {
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> all;
        for (const parameter::Row* row : shipped().rows(Device::gateway)) {
            if (is_error(row->number) && !row->name.empty()) {
                all.push_back(row->name);
            }
        }
        return all;
    }();
    return names;
}

std::string error_text(std::uint16_t number) {
    const parameter::Row* row = row_of(number);
    return row != nullptr && !row->name.empty() ? fmt::format("{} {}", number, row->name)
                                                : fmt::format("{}", number);
}

}  // namespace cgw::scenario
