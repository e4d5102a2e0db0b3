#include "runtime/event_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "device/gateway_errors.hpp"
#include "runtime/measurements.hpp"
#include "simulation/error_numbers.hpp"
#include "simulation/text.hpp"

namespace cgw::runtime {
namespace {

// 12421..12424 say again what 3070..3073 say.
bool repeats_own_error(std::uint16_t canopen_error) {
    const auto rows = device::fault_rows();
    return std::any_of(rows.begin(), rows.end(), [canopen_error](const device::FaultRow& row) {
        return row.canopen_error == canopen_error && row.error != 0;
    });
}

std::set<std::uint16_t> numbers_of(const device::GatewayStatus& status) {
    std::set<std::uint16_t> numbers;
    for (const std::uint16_t number : simulation::error_numbers(status.canopen_errors, status.errors)) {
        if (number != device::GatewayErrors::can_open_error && !repeats_own_error(number)) {
            numbers.insert(number);
        }
    }
    return numbers;
}

std::string line_of_error(std::uint16_t number) {
    const parameter::Row* const row = gateway_row(number);
    return row == nullptr ? fmt::format("error {}", number)
                          : fmt::format("error {}: {}", parameter::label(*row), row->text);
}

}  // namespace

std::vector<std::string> lines_of_change(const device::GatewayStatus& before,
                                         const device::GatewayStatus& now) {
    std::vector<std::string> lines;
    const std::set<std::uint16_t> old_errors = numbers_of(before);
    const std::set<std::uint16_t> new_errors = numbers_of(now);
    for (const std::uint16_t number : new_errors) {
        if (!old_errors.contains(number)) {
            lines.push_back(line_of_error(number));
        }
    }
    if (before.state != now.state) {
        lines.push_back(fmt::format("state {}", simulation::to_text(now.state)));
    }
    for (const std::uint16_t number : old_errors) {
        if (!new_errors.contains(number)) {
            lines.push_back(fmt::format("cleared {}", gateway_label(number)));
        }
    }
    return lines;
}

std::string line_of_refusal(const link::Refusal& refusal) {
    return fmt::format("the governor is refused: {}", simulation::refusal_text(refusal));
}

}  // namespace cgw::runtime
