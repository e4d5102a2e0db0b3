#include "check/support.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace cgw::check {

namespace {

bool fits(const parameter::Row& row, double value) {
    if ((row.minimum && value < *row.minimum) || (row.maximum && value > *row.maximum)) {
        return false;
    }
    return row.choices.empty() ||
           std::any_of(row.choices.begin(), row.choices.end(),
                       [value](std::uint32_t choice) { return static_cast<double>(choice) == value; });
}

std::string owned(parameter::Device device, const std::string& name) {
    return fmt::format("the {}'s {}", parameter::to_text(device), name);
}

}  // namespace

const parameter::Assignment* usable(const Context& context, parameter::Device device, std::uint16_t number) {
    const parameter::Assignment* assignment = context.settings.of(device).find(number);
    const bool good =
        assignment != nullptr && assignment->row != nullptr && fits(*assignment->row, assignment->value);
    return good ? assignment : nullptr;
}

const parameter::Assignment* sound(const Context& context, parameter::Device device, std::uint16_t number) {
    const parameter::Assignment* assignment = usable(context, device, number);
    if (assignment == nullptr) {
        return nullptr;
    }
    const auto& findings = context.findings.all();
    const bool refused =
        std::any_of(findings.begin(), findings.end(), [&](const diagnostic::Diagnostic& finding) {
            return finding.level() == diagnostic::Level::error &&
                   finding.where.range == assignment->where.range &&
                   finding.where.path == assignment->where.path;
        });
    return refused ? nullptr : assignment;
}

bool absent(const Context& context, parameter::Device device, std::uint16_t number) {
    const parameter::ParameterSet& set = context.settings.of(device);
    return set.find(number) == nullptr && !set.rejected(number) &&
           table_of(context, device).range.start.line != 0;
}

bool is_off(const Context& context, parameter::Device device, std::uint16_t number) {
    const parameter::Assignment* assignment = usable(context, device, number);
    return assignment != nullptr ? assignment->value == 0 : absent(context, device, number);
}

std::string_view off_text(const Context& context, parameter::Device device, std::uint16_t number) {
    return usable(context, device, number) != nullptr ? "0" : "not set";
}

const diagnostic::Location& place_of(const Context& context, parameter::Device device, std::uint16_t number) {
    const parameter::Assignment* assignment = usable(context, device, number);
    return assignment != nullptr ? assignment->where : table_of(context, device);
}

const diagnostic::Location& table_of(const Context& context, parameter::Device device) {
    return device == parameter::Device::governor ? context.settings.governor_table
                                                 : context.settings.gateway_table;
}

std::string label(const Context& context, parameter::Device device, std::uint16_t number) {
    const parameter::Row* row = context.catalogue.find(device, number);
    return row == nullptr ? fmt::format("{}", number) : parameter::label(*row);
}

std::string owned_label(const Context& context, parameter::Device device, std::uint16_t number) {
    return owned(device, label(context, device, number));
}

std::string quantity(const parameter::Assignment& assignment) {
    const std::string_view unit = assignment.row->unit;
    return fmt::format("{}{}{}", assignment.value, unit.empty() ? "" : " ", unit);
}

std::string milliseconds(std::uint64_t microseconds) {
    return fmt::format("{} ms", static_cast<double>(microseconds) / 1000);
}

std::string identifier_text(std::uint32_t identifier) {
    return fmt::format("{:03X}h", identifier);
}

diagnostic::Related here(const parameter::Assignment& assignment) {
    const std::string name = owned(assignment.row->device, parameter::label(*assignment.row));
    return {.where = assignment.where, .message = fmt::format("{} is {} here", name, quantity(assignment))};
}

}  // namespace cgw::check
