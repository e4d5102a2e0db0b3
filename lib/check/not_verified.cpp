// What the checks leave open in a valid file, said so that nobody takes silence for approval.
#include "check/not_verified.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "check/support.hpp"
#include "config/numbers.hpp"

namespace cgw::check {

namespace {

using parameter::Device;
namespace governor = config::governor;
namespace gateway = config::gateway;

constexpr std::size_t most_listed = 5;

// "844, 845", or "844, ... (20)" where they would fill the line.
template <typename Numbers>
std::string listed(const Numbers& numbers) {
    return numbers.size() <= most_listed ? fmt::format("{}", fmt::join(numbers, ", "))
                                         : fmt::format("{}, ... ({})", *numbers.begin(), numbers.size());
}

std::string governor_timing(const Context& context) {
    return context.configuration.governor_can.manual
               ? fmt::format("HEINZMANN CAN bus: the governor's bit rate, set by hand ({} = 1)",
                             governor::manual_timing)
               : "";
}

std::string gateway_timing(const Context& context) {
    return context.configuration.can1.manual && !context.settings.can1_bit_timing
               ? "HEINZMANN CAN bus: the gateway's bit rate, set by hand, clock not stated"
               : "";
}

std::string canopen_timing(const Context& context) {
    return context.configuration.can2.manual && !context.settings.can2_bit_timing
               ? fmt::format("CANopen bus: the bit rate, set by hand ({} = 1), clock not stated",
                             gateway::canopen_manual_timing)
               : "";
}

// D13: switches and sensors need no name, but then only the governor's own list tells whether it has them.
std::string unnamed_switches(const Context& context) {
    std::vector<std::uint16_t> numbers;
    for (const config::SwitchFunction& function : context.configuration.switches) {
        if (function.row->name.empty()) {
            numbers.push_back(function.row->number);
        }
    }
    return numbers.empty()
               ? ""
               : fmt::format("switch functions {}: whether this governor has them", listed(numbers));
}

std::string unnamed_sensors(const Context& context) {
    std::vector<std::uint16_t> numbers;
    for (const config::Sensor& sensor : context.configuration.sensors) {
        if (sensor.row->name.empty()) {
            numbers.push_back(sensor.row->number);
        }
    }
    return numbers.empty() ? "" : fmt::format("sensors {}: whether this governor has them", listed(numbers));
}

// A measurement whose end values are parameters: without them its words are bare numbers.
std::string unknown_scaling(const Context& context) {
    std::set<std::uint16_t> words;
    std::set<std::uint16_t> missing;
    for (const config::AnalogueOutput& output : context.configuration.analogue_outputs) {
        if (!output.parameter->scaling) {
            continue;
        }
        const parameter::Scaling& scaling = *output.parameter->scaling;
        for (const std::uint16_t number :
             {scaling.external_minimum_parameter, scaling.external_maximum_parameter}) {
            const bool counts = number == scaling.external_maximum_parameter  // D49
                                    ? context.settings.governor.value(number) != 0
                                    : context.settings.governor.find(number) != nullptr;
            if (number != 0 && !counts) {
                words.insert(output.parameter->number);
                missing.insert(number);
            }
        }
    }
    return words.empty() ? ""
                         : fmt::format("scaling of {}: {} {} not set", listed(words), listed(missing),
                                       missing.size() == 1 ? "is" : "are");
}

std::string other_nodes(const Context& context) {
    std::vector<unsigned> nodes;
    for (const parameter::NetworkNode& node : context.settings.network_nodes) {
        nodes.push_back(node.node_id);
    }
    if (nodes.empty()) {
        return "other nodes: their ids and identifiers; [network] lists none";
    }
    std::sort(nodes.begin(), nodes.end());
    return fmt::format("other nodes: identifiers beyond the default ones of {}", listed(nodes));
}

std::string devices(const Context& /*context*/) {
    return "both devices: whether they hold these values; compare in DcDesk";
}

constexpr std::string (*table[])(const Context&) = {
    governor_timing, gateway_timing,  canopen_timing, unnamed_switches,
    unnamed_sensors, unknown_scaling, other_nodes,    devices,
};

}  // namespace

std::vector<std::string> not_verified(const Context& context) {
    std::vector<std::string> lines;
    for (const auto& line_for : table) {
        if (std::string line = line_for(context); !line.empty()) {
            lines.push_back(std::move(line));
        }
    }
    return lines;
}

}  // namespace cgw::check
