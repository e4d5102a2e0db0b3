#include "check/support.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "parameter/value_text.hpp"

namespace cgw::check {

namespace {

std::string owned(parameter::Device device, const std::string& name) {
    return fmt::format("the {}'s {}", parameter::to_text(device), name);
}

}  // namespace

const parameter::Assignment* usable(const Context& context, parameter::Device device, std::uint16_t number) {
    const parameter::Assignment* assignment = context.settings.of(device).find(number);
    const bool good =
        assignment != nullptr && assignment->row != nullptr && assignment->row->allows(assignment->value);
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
    return quantity_text(*assignment.row, assignment.value);
}

diagnostic::Related here(const parameter::Assignment& assignment) {
    const std::string name = owned(assignment.row->device, parameter::label(*assignment.row));
    return {.where = assignment.where, .message = fmt::format("{} is {} here", name, quantity(assignment))};
}

}  // namespace cgw::check
