#include <algorithm>
#include <limits>

#include "config/configuration.hpp"
#include "config/numbers.hpp"
#include "config/parts.hpp"
#include "config/reading.hpp"

namespace cgw::config {

namespace {

constexpr double longest_start_up_delay_s = 100;

std::uint32_t start_up_delay_ms(const parameter::ParameterSet& set, std::uint16_t number) {
    const double seconds = set.value(number);
    const bool usable = seconds > 0 && seconds <= longest_start_up_delay_s;
    return usable ? static_cast<std::uint32_t>(std::lround(seconds * 1000)) : 0;
}

// The registers follow each other in the order of the manual's tables (7.1.1, 7.2.1, 7.2.2).
BusTiming bus_timing(const parameter::ParameterSet& set, std::uint16_t manual, std::uint16_t bit_rate,
                     std::uint16_t prescaler, bool has_prop_segment) {
    constexpr std::int32_t highest_register = 63;
    const auto at = [&](int offset) {
        return setting<std::uint8_t>(set, static_cast<std::uint16_t>(prescaler + offset), highest_register);
    };
    BusTiming timing;
    timing.manual = switched_on(set, manual);
    timing.bit_rate_kbit = setting<std::uint16_t>(set, bit_rate, 1000);
    timing.prescaler = at(0);
    timing.sync_jump_width = at(1);
    timing.sampling_mode = at(2);
    timing.phase_segment_1 = at(3);
    timing.phase_segment_2 = at(4);
    timing.prop_segment = has_prop_segment ? at(5) : std::uint8_t{0};
    return timing;
}

}  // namespace

std::optional<bit_timing::Timing> timing_by_hand(const BusTiming& timing,
                                                 const std::optional<parameter::BitTiming>& controller) {
    if (!timing.manual || !controller) {
        return std::nullopt;
    }
    return bit_timing::Timing{.clock_hz = controller->clock_hz,
                              .controller = controller->controller,
                              .registers = {.prescaler = timing.prescaler,
                                            .sync_jump_width = timing.sync_jump_width,
                                            .sampling_mode = timing.sampling_mode,
                                            .phase_segment_1 = timing.phase_segment_1,
                                            .phase_segment_2 = timing.phase_segment_2,
                                            .prop_segment = timing.prop_segment}};
}

std::optional<std::uint32_t> bit_rate(const BusTiming& timing,
                                      const std::optional<parameter::BitTiming>& controller) {
    if (!timing.manual) {
        return timing.bit_rate_kbit * 1000U;
    }
    const std::optional<bit_timing::Timing> by_hand = timing_by_hand(timing, controller);
    if (!by_hand) {
        return std::nullopt;
    }
    const std::uint64_t clocks_per_bit = by_hand->clocks_per_bit();
    return static_cast<std::uint32_t>((by_hand->clock_hz + clocks_per_bit / 2) / clocks_per_bit);
}

CyclicTime cyclic_time(std::uint32_t asked_ms, std::uint32_t main_cycle_us) {
    const std::uint32_t cycles = facts::whole_cycles(asked_ms, main_cycle_us);
    const std::uint64_t effective_us = std::uint64_t{cycles} * main_cycle_us;
    constexpr std::uint64_t longest_us = std::numeric_limits<std::uint32_t>::max();
    return {.asked_ms = asked_ms,
            .cycles = cycles,
            .effective_us = static_cast<std::uint32_t>(std::min(effective_us, longest_us))};
}

CyclicTime resolve_time(const parameter::Settings& settings, parameter::Device device, std::uint16_t number,
                        std::uint32_t main_cycle_us, std::uint8_t pdo, Configuration& configuration) {
    const CyclicTime time = cyclic_time(time_ms(settings.of(device), number), main_cycle_us);
    if (time.effective_us != std::uint64_t{time.asked_ms} * 1000) {
        configuration.decisions.push_back({.kind = DecisionKind::quantised,
                                           .device = device,
                                           .parameter = number,
                                           .pdo = pdo,
                                           .time = time});
    }
    return time;
}

void resolve_buses(const parameter::Settings& settings, Configuration& configuration) {
    configuration.governor_start_up_delay_ms = start_up_delay_ms(settings.governor, governor::start_up_delay);
    configuration.gateway_start_up_delay_ms = start_up_delay_ms(settings.gateway, gateway::start_up_delay);
    configuration.governor_can = bus_timing(settings.governor, governor::manual_timing, governor::bit_rate,
                                            governor::prescaler, false);
    configuration.can1 = bus_timing(settings.gateway, gateway::hzm_manual_timing, gateway::hzm_bit_rate,
                                    gateway::hzm_prescaler, true);
    configuration.can2 = bus_timing(settings.gateway, gateway::canopen_manual_timing,
                                    gateway::canopen_bit_rate, gateway::canopen_prescaler, true);
}

void resolve_heartbeats(const parameter::Settings& settings, Configuration& configuration) {
    using parameter::Device;
    configuration.heartbeat_producer = resolve_time(settings, Device::gateway, gateway::heartbeat_producer,
                                                    gateway_main_cycle_us, 0, configuration);
    if (configuration.partner_node_id != 0) {  // D14: without a partner nothing is monitored
        configuration.heartbeat_consumer = resolve_time(
            settings, Device::gateway, gateway::heartbeat_consumer, gateway_main_cycle_us, 0, configuration);
    }
}

}  // namespace cgw::config
