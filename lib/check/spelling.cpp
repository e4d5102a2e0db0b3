// How numbers and names are typed: what is read otherwise than its author may think (D2, D10, D15).
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "base/ascii.hpp"
#include "check/subjects.hpp"
#include "check/support.hpp"
#include "diagnostic/rules/notes.hpp"
#include "diagnostic/rules/warnings.hpp"

namespace cgw::check {

namespace {

using parameter::Assignment;
using parameter::Device;
namespace rules = diagnostic::rules;

std::uint32_t read_as_hexadecimal(std::uint32_t value) {
    const std::string digits = fmt::format("{}", value);
    std::uint32_t reading = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), reading, 16);
    return reading;
}

void judge_literal(const Context& context, const Assignment& assignment) {
    if (!decimal_in_doubt(assignment) ||
        sound(context, assignment.row->device, assignment.row->number) == nullptr) {
        return;
    }
    const auto value = static_cast<std::uint32_t>(assignment.value);
    const std::uint32_t printed = read_as_hexadecimal(value);
    const bool printed_fits = !assignment.row->maximum || printed <= *assignment.row->maximum;
    context.findings.report(
        {.rule = &rules::decimal_for_hexadecimal,
         .message = fmt::format("{} is decimal {}, which is {:X}h; the manual prints this parameter in "
                                "hexadecimal (manual 7.2.4)",
                                parameter::label(*assignment.row), value, value),
         .where = assignment.where,
         .help = printed_fits ? fmt::format("write 0x{:X} if {:X}h is meant, 0x{:X} if {:X}h is", printed,
                                            printed, value, value)
                              : fmt::format("write 0x{:X}", value)});
}

// The row that the key means although the manual prints it wrong, or nullptr for any other key.
const parameter::Row* misprinted(const Context& context, const Assignment& assignment) {
    if (assignment.row->misprints.empty()) {
        return nullptr;
    }
    const std::string& key = assignment.spelling;
    const std::size_t start = std::min(key.find_first_not_of(" \t"), key.size());
    std::uint16_t number = 0;
    const auto [end, error] = std::from_chars(key.data() + start, key.data() + key.size(), number);
    if (error != std::errc{}) {
        return nullptr;
    }
    const std::string_view name =
        base::trimmed({end, static_cast<std::size_t>(key.data() + key.size() - end)});
    return context.catalogue.find_misprint(assignment.row->device, number, name);
}

void judge_misprint(const Context& context, const Assignment& assignment) {
    const parameter::Row* meant = misprinted(context, assignment);
    if (meant == nullptr) {
        return;
    }
    context.findings.report({.rule = &rules::manual_misprint,
                             .message = fmt::format("`{}` is a misprint of the manual, read as {}",
                                                    assignment.spelling, parameter::label(*meant)),
                             .where = assignment.key,
                             .help = fmt::format("write \"{}\"", parameter::label(*meant))});
}

void for_each_assignment(const Context& context, void (*judge)(const Context&, const Assignment&)) {
    for (const Device device : {Device::governor, Device::gateway}) {
        for (const auto& [number, assignment] : context.settings.of(device).all()) {
            if (assignment.row != nullptr) {
                judge(context, assignment);
            }
        }
    }
}

}  // namespace

bool decimal_in_doubt(const Assignment& assignment) {
    constexpr double highest_digit = 9;  // up to here both readings are the same
    return assignment.decimal_typed && assignment.row->base == parameter::Base::hexadecimal &&
           assignment.value > highest_digit;
}

void check_decimal_literals(const Context& context) {
    for_each_assignment(context, judge_literal);
}

void check_misprints(const Context& context) {
    for_each_assignment(context, judge_misprint);
}

}  // namespace cgw::check
