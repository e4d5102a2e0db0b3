// The parameters assigned to TPDO4..16 (manual 7.1.2.2, D13): what the governor cannot send it leaves out
// without saying so.
#include <fmt/format.h>

#include "check/subjects.hpp"
#include "check/support.hpp"
#include "config/numbers.hpp"
#include "diagnostic/rules/plant.hpp"

namespace cgw::check {

namespace {

using parameter::Assignment;
using parameter::Device;
using parameter::Row;
namespace governor = config::governor;
namespace rules = diagnostic::rules;

// Calls `judge` with every assigned number that cannot be sent, and its row or nullptr.
void for_each_refused(const Context& context,
                      void (*judge)(const Context&, const Assignment&, std::uint16_t, const Row*)) {
    for (std::uint16_t word = governor::tpdo_assignment; word <= governor::last_tpdo_assignment; ++word) {
        const Assignment* assignment = usable(context, Device::governor, word);
        if (assignment == nullptr || assignment->value < 1 || assignment->value > UINT16_MAX) {
            continue;
        }
        const auto number = static_cast<std::uint16_t>(assignment->value);
        const Row* row = context.catalogue.find(Device::governor, number);
        if (!config::transmittable(row)) {
            judge(context, *assignment, number, row);
        }
    }
}

std::string declaration(std::uint16_t number, const Row* row) {
    const bool named = row != nullptr && !row->name.empty();
    const std::string name = named ? std::string(row->name) : fmt::format("Measurement{}", number);
    return fmt::format(
        "if the governor has it as an analogue value, declare it with its width and sign:\n"
        "[[governor.declare]]\n"
        "number = {}\n"
        "name = \"{}\"\n"
        "kind = \"measurement\"\n"
        "width = 16\n"
        "signed = false",
        number, name);
}

void judge_unknown(const Context& context, const Assignment& assignment, std::uint16_t number,
                   const Row* row) {
    if (row != nullptr && row->is_bit()) {
        return;
    }
    const bool is_setting = row != nullptr && row->settable();
    const std::string found = row == nullptr ? fmt::format("{}, which no catalogue knows", number)
                              : is_setting
                                  ? fmt::format("{}, a parameter and no measurement", parameter::label(*row))
                                  : fmt::format("{}, whose width is not known", parameter::label(*row));
    context.findings.report(
        {.rule = &rules::tpdo_parameter_unknown,
         .message = fmt::format("{} is {}; the governor leaves out what it cannot send (manual 7.1.2.2)",
                                parameter::label(*assignment.row), found),
         .where = assignment.where,
         .help = is_setting ? std::string() : declaration(number, row)});
}

void judge_bit(const Context& context, const Assignment& assignment, std::uint16_t number, const Row* row) {
    if (row == nullptr || !row->is_bit()) {
        return;
    }
    diagnostic::Diagnostic finding{
        .rule = &rules::tpdo_parameter_bit,
        .message = fmt::format("{} is {}, a single bit, which a TPDO cannot carry (manual 4.1.2)",
                               parameter::label(*assignment.row), parameter::label(*row)),
        .where = assignment.where};
    if (facts::is_error_number(number)) {
        finding.help =
            fmt::format("error bits travel in TPDO1 and TPDO2: write {} = 1", governor::send_errors);
    }
    context.findings.report(std::move(finding));
}

}  // namespace

void check_known_outputs(const Context& context) {
    for_each_refused(context, judge_unknown);
}
void check_bit_outputs(const Context& context) {
    for_each_refused(context, judge_bit);
}

}  // namespace cgw::check
