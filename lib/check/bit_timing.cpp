// Bit timing that is set by hand in the gateway, where the file states clock and family (D7, D77).
#include <fmt/format.h>

#include <optional>

#include "check/subjects.hpp"
#include "check/support.hpp"
#include "config/numbers.hpp"
#include "diagnostic/rules/plant.hpp"
#include "diagnostic/rules/warnings.hpp"

namespace cgw::check {

namespace {

using config::BusTiming;
using parameter::Assignment;
using parameter::Device;
namespace gateway = config::gateway;
namespace rules = diagnostic::rules;

struct Bus {
    std::string_view name;
    std::uint16_t manual;  // number of the parameter that asks for the registers
    std::uint16_t first_register;
    BusTiming config::Configuration::*timing;
    std::optional<parameter::BitTiming> parameter::Settings::*controller;
};

constexpr Bus can1{"CAN1", gateway::hzm_manual_timing, gateway::hzm_prescaler, &config::Configuration::can1,
                   &parameter::Settings::can1_bit_timing};
constexpr Bus can2{"CAN2", gateway::canopen_manual_timing, gateway::canopen_prescaler,
                   &config::Configuration::can2, &parameter::Settings::can2_bit_timing};

// What the registers make, and the place to say so: 4416 or 4426.
struct ByHand {
    bit_timing::Timing timing;
    const Assignment* place;
};

// nullopt where timing is not manual, the clock not stated, or a value refused already.
std::optional<ByHand> by_hand(const Context& context, const Bus& bus) {
    const Assignment* manual = usable(context, Device::gateway, bus.manual);
    for (std::size_t i = 0; i < bit_timing::registers().size(); ++i) {
        if (context.settings.gateway.rejected(static_cast<std::uint16_t>(bus.first_register + i))) {
            return std::nullopt;
        }
    }
    const auto timing =
        config::timing_by_hand(context.configuration.*bus.timing, context.settings.*bus.controller);
    return manual != nullptr && timing ? std::optional(ByHand{*timing, manual}) : std::nullopt;
}

std::optional<ByHand> possible(const Context& context, const Bus& bus) {
    const std::optional<ByHand> found = by_hand(context, bus);
    return found && bit_timing::violations(found->timing).empty() ? found : std::nullopt;
}

}  // namespace

void check_possible_timing(const Context& context) {
    for (const Bus& bus : {can1, can2}) {
        const std::optional<ByHand> found = by_hand(context, bus);
        if (!found) {
            continue;
        }
        for (const std::string& violation : bit_timing::violations(found->timing)) {
            context.findings.report(
                {.rule = &rules::bit_timing_impossible,
                 .message =
                     fmt::format("bit timing by hand of {}, {}..{}: {} ({})", bus.name, bus.first_register,
                                 bus.first_register + 5, violation, found->timing.controller->name),
                 .where = found->place->where});
        }
    }
}

void check_usual_bit_rate(const Context& context) {
    const std::optional<ByHand> found = possible(context, can2);
    if (!found || bit_timing::near_standard_rate(found->timing.bit_rate()) != nullptr) {
        return;
    }
    context.findings.report(
        {.rule = &rules::bit_rate_unusual,
         .message =
             fmt::format("bit timing by hand of CAN2 makes {:.3f} kbit/s, which is no bit rate of CANopen",
                         found->timing.bit_rate() / 1000),
         .where = found->place->where,
         .help = fmt::format("cgw bit-timing --clock {} --family {} lists registers for each rate",
                             found->timing.clock_hz, found->timing.controller->name)});
}

void check_sample_point(const Context& context) {
    const std::optional<ByHand> found = possible(context, can2);
    const bit_timing::StandardRate* rate =
        found ? bit_timing::near_standard_rate(found->timing.bit_rate()) : nullptr;
    if (rate == nullptr) {
        return;
    }
    const double sample = found->timing.sample_point();
    if (sample >= rate->lowest_sample && sample <= rate->highest_sample) {
        return;
    }
    context.findings.report(
        {.rule = &rules::sample_point,
         .message = fmt::format(
             "bit timing by hand of CAN2 samples at {:.1f} % of a bit; at {} kbit/s {:.0f} to "
             "{:.0f} % work together with other devices",
             sample * 100, rate->bit_rate / 1000, rate->lowest_sample * 100, rate->highest_sample * 100),
         .where = found->place->where,
         .help = fmt::format("cgw bit-timing --clock {} --family {} --rate {} proposes registers",
                             found->timing.clock_hz, found->timing.controller->name, rate->bit_rate / 1000)});
}

}  // namespace cgw::check
