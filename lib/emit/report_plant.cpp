#include <fmt/format.h>

#include "base/canopen_text.hpp"
#include "config/numbers.hpp"
#include "emit/report_parts.hpp"

namespace cgw::emit {
namespace {

using config::BusTiming;
using config::CyclicTime;
using config::Pdo;
using page::Cell;

std::string rate_text(const BusTiming& timing, std::optional<std::uint32_t> rate) {
    if (!timing.manual) {
        return fmt::format("{} kbit/s", timing.bit_rate_kbit);
    }
    return rate ? fmt::format("{} kbit/s, set by hand", *rate / 1000.0) : "set by hand, not known";
}

std::string time_or_off(const CyclicTime& time) {
    return time.cycles == 0 ? "off" : base::milliseconds_text(time.effective_us);
}

std::string partner_text(const config::Configuration& configuration) {
    if (configuration.partner_node_id == 0) {
        return "none";
    }
    return fmt::format("node {}, monitored for {}", configuration.partner_node_id,
                       time_or_off(configuration.heartbeat_consumer));
}

std::vector<Cell> time_row(std::string name, std::string_view meaning, const CyclicTime& time) {
    const bool off = time.cycles == 0;
    return {std::move(name), std::string(meaning), off ? "off" : fmt::format("{} ms", time.asked_ms),
            off ? "" : fmt::format("{}", time.cycles),
            off ? "off" : base::milliseconds_text(time.effective_us)};
}

}  // namespace

void add_devices(const Plant& plant, Blocks& blocks) {
    const config::Configuration& c = plant.configuration;
    const parameter::Settings& settings = plant.settings;
    blocks.emplace_back(page::Heading{2, "Devices and buses"});
    page::Table buses{"Both devices on both buses", {{"What"}, {"Governor"}, {"Gateway"}}, {}};
    buses.rows = {
        {"HEINZMANN CAN bus (CAN1), node", std::to_string(c.governor_node), std::to_string(c.gateway_node)},
        {"HEINZMANN CAN bus, bit rate", rate_text(c.governor_can, std::nullopt),
         rate_text(c.can1, config::bit_rate(c.can1, settings.can1_bit_timing))},
        {"start-up delay", fmt::format("{} ms", c.governor_start_up_delay_ms),
         fmt::format("{} ms", c.gateway_start_up_delay_ms)},
        {"main cycle", base::milliseconds_text(c.main_cycle_us),
         base::milliseconds_text(facts::gateway_main_cycle_us)},
        {"CANopen bus (CAN2), node", "", std::to_string(c.node_id)},
        {"CANopen bus, bit rate", "", rate_text(c.can2, config::bit_rate(c.can2, settings.can2_bit_timing))},
        {"heartbeat", "", time_or_off(c.heartbeat_producer)},
        {"partner", "", partner_text(c)},
    };
    blocks.emplace_back(std::move(buses));
}

void add_times(const Plant& plant, Blocks& blocks) {
    const config::Configuration& c = plant.configuration;
    blocks.emplace_back(page::Heading{2, "Times as asked and as they are"});
    blocks.emplace_back(page::Paragraph{fmt::format(
        "Times are whole main cycles, rounded down: {} in the governor, {} for heartbeats in the gateway "
        "(D8).",
        base::milliseconds_text(c.main_cycle_us), base::milliseconds_text(facts::gateway_main_cycle_us))});
    page::Table times{"Cycles and monitoring",
                      {{"What"}, {"Meaning"}, {"Asked", true}, {"Main cycles", true}, {"Effective", true}},
                      {}};
    times.rows.push_back(time_row("heartbeat", "sent", c.heartbeat_producer));
    times.rows.push_back(time_row("heartbeat of the partner", "monitored", c.heartbeat_consumer));
    for (const Pdo& pdo : c.pdos) {
        const bool transmit = pdo.direction == config::Direction::transmit;
        if (pdo.active && (!transmit || pdo.number >= facts::first_analogue_tpdo)) {
            times.rows.push_back(time_row(pdo.name(), transmit ? "sent" : "monitored", pdo.time));
        }
    }
    blocks.emplace_back(std::move(times));
}

}  // namespace cgw::emit
