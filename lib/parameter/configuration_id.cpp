#include <algorithm>

#include <fmt/format.h>

#include "base/bytes.hpp"
#include "base/json.hpp"
#include "base/numbers.hpp"
#include "base/sha256.hpp"
#include "parameter/settings.hpp"

namespace cgw::parameter {

namespace {

constexpr int canonical_format = 1;

std::string_view list_text(List list) {
    constexpr std::array<std::string_view, 4> texts = {"parameter", "measurement", "function", "curve"};
    return texts[static_cast<std::size_t>(list)];
}

std::string_view role_text(Role role) {
    constexpr std::array<std::string_view, 5> texts = {"", " switch", " switch-type", " sensor",
                                                       " sensor-type"};
    return texts[static_cast<std::size_t>(role)];
}

std::string limit_text(std::optional<double> constant, std::uint16_t reference) {
    if (reference != 0) {
        return fmt::format("@{}", reference);
    }
    return constant ? base::to_text(*constant) : "?";
}

std::string row_line(const Row& row) {
    std::string line = fmt::format("row {} {} {} {}{}", to_text(row.device), row.number,
                                   base::json_quote(row.name), list_text(row.list), role_text(row.role));
    if (row.list == List::measurement) {
        line += fmt::format(" {} {} {}", row.width, row.is_signed ? "signed" : "unsigned",
                            base::json_quote(row.unit));
        if (row.scaling) {
            const Scaling& scaling = *row.scaling;
            line += fmt::format(" {}..{} {}..{}", scaling.internal_minimum, scaling.internal_maximum,
                                limit_text(scaling.external_minimum, scaling.external_minimum_parameter),
                                limit_text(scaling.external_maximum, scaling.external_maximum_parameter));
        }
    }
    return line + "\n";
}

std::string row_lines(std::vector<const Row*> rows) {
    const auto by_number = [](const Row* a, const Row* b) {
        return a->device != b->device ? a->device < b->device : a->number < b->number;
    };
    // What the bootloader means by a number goes into no telegram.
    std::erase_if(rows, [](const Row* row) { return row->program != Program::application; });
    // The latest of one number wins: a later declaration completes an earlier row.
    std::stable_sort(rows.begin(), rows.end(), by_number);
    std::string text;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (i + 1 == rows.size() || by_number(rows[i], rows[i + 1])) {
            text += row_line(*rows[i]);
        }
    }
    return text;
}

std::string value_lines(Device device, const ParameterSet& set) {
    std::string text;
    for (const auto& [number, assignment] : set.all()) {
        if (assignment.value != 0) {
            text += fmt::format("{} {} {}\n", to_text(device), number, base::to_text(assignment.value));
        }
    }
    return text;
}

}  // namespace

std::string canonical_text(const Settings& settings) {
    const Identity& identity = settings.identity;
    std::string text = fmt::format("cgw-configuration {}\n", canonical_format);
    text += fmt::format("title {}\n", base::json_quote(settings.title));
    text += fmt::format("identity {} {} {}\n", identity.software_version, identity.serial_date,
                        identity.serial_number);
    text += fmt::format("main-cycle-us {}\n", settings.main_cycle_us);
    text += row_lines(settings.declarations);
    text += value_lines(Device::governor, settings.governor);
    text += value_lines(Device::gateway, settings.gateway);
    return text;
}

std::array<std::uint8_t, 32> configuration_id(const Settings& settings) {
    return base::sha256(base::to_bytes(canonical_text(settings)));
}

}  // namespace cgw::parameter
