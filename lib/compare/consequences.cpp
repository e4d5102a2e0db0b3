#include "compare/consequences.hpp"

#include <fmt/format.h>

#include <map>

#include "base/canopen_text.hpp"
#include "base/numbers.hpp"
#include "config/numbers.hpp"

namespace cgw::compare {
namespace {

using config::BusTiming;
using config::Configuration;

std::string bit_rate_text(const BusTiming& timing) {
    if (!timing.manual) {
        return fmt::format("{} kbit/s", timing.bit_rate_kbit);
    }
    return fmt::format("by hand {}/{}/{}/{}/{}/{}", timing.prescaler, timing.sync_jump_width,
                       timing.sampling_mode, timing.phase_segment_1, timing.phase_segment_2,
                       timing.prop_segment);
}

std::string monitoring_text(const Configuration& configuration) {
    const bool is_on = configuration.heartbeat_consumer.cycles != 0 && configuration.partner_node_id != 0;
    return is_on ? fmt::format("node {} within {}", configuration.partner_node_id,
                               time_text(configuration.heartbeat_consumer))
                 : "off";
}

constexpr std::pair<std::uint32_t, const char*> node_identifiers[] = {
    {facts::cob::sdo_request, "SDO requests to the gateway"},
    {facts::cob::sdo_answer, "SDO answers of the gateway"},
    {facts::cob::heartbeat, "boot-up and heartbeat identifier"},
};

std::string node_identifier_text(std::uint32_t first, std::uint8_t node_id) {
    return node_id == 0 ? "none" : base::identifier_text(first + node_id);
}

using Inputs = std::map<std::uint16_t, std::pair<std::string, std::string>>;  // by number: name and meaning

Inputs switches_of(const Configuration& configuration) {
    Inputs inputs;
    for (const config::SwitchFunction& function : configuration.switches) {
        inputs[function.row->number] = {
            parameter::label(*function.row),
            fmt::format("RPDO1 bit {}{}", function.bit, function.low_active ? ", low-active" : "")};
    }
    return inputs;
}

Inputs sensors_of(const Configuration& configuration) {
    Inputs inputs;
    for (const config::Sensor& sensor : configuration.sensors) {
        inputs[sensor.row->number] = {parameter::label(*sensor.row), channel_word_text(sensor.channel)};
    }
    return inputs;
}

void compare_input_maps(std::string_view kind, const Inputs& a, const Inputs& b, Differences& differences) {
    Inputs all = a;
    all.insert(b.begin(), b.end());
    const auto meaning = [](const Inputs& inputs, std::uint16_t number) {
        const auto found = inputs.find(number);
        return found != inputs.end() ? found->second.second : "not over CANopen";
    };
    for (const auto& [number, input] : all) {
        note(differences, kind, fmt::format("{} {}", kind, input.first), meaning(a, number),
             meaning(b, number));
    }
}

}  // namespace

std::string channel_word_text(unsigned channel) {
    return fmt::format("{} word {}", base::pdo_name(false, facts::rpdo_of_channel(channel)),
                       facts::word_of_channel(channel));
}

std::string time_text(const config::CyclicTime& time) {
    return time.effective_us == 0 ? "off" : base::milliseconds_text(time.effective_us);
}

void compare_communication(const parameter::Settings& a, const parameter::Settings& b,
                           Differences& differences) {
    const auto meaning = [](const parameter::Settings& settings) {
        const bool is_on = settings.governor.value(config::governor::gateway_communication) == 1 &&
                           settings.gateway.value(config::gateway::governor_communication) == 1;
        return is_on ? "on" : "off: governor and gateway exchange nothing";
    };
    note(differences, "communication", "HZM communication", meaning(a), meaning(b));
}

void compare_buses(const Configuration& a, const Configuration& b, Differences& differences) {
    const auto number = [&](std::string_view kind, const char* subject, std::uint8_t of_a,
                            std::uint8_t of_b) {
        note(differences, kind, subject, fmt::format("{}", of_a), fmt::format("{}", of_b));
    };
    number("hzm-node", "governor's HZM node", a.governor_node, b.governor_node);
    number("hzm-node", "gateway, as the governor has it", a.gateway_node_in_governor,
           b.gateway_node_in_governor);
    number("hzm-node", "gateway's HZM node", a.gateway_node, b.gateway_node);
    number("hzm-node", "governor, as the gateway has it", a.governor_node_in_gateway,
           b.governor_node_in_gateway);
    note(differences, "bit-rate", "HZM bit rate, governor", bit_rate_text(a.governor_can),
         bit_rate_text(b.governor_can));
    note(differences, "bit-rate", "HZM bit rate, gateway", bit_rate_text(a.can1), bit_rate_text(b.can1));
    number("node-id", "CANopen node id", a.node_id, b.node_id);
    for (const auto& [base, subject] : node_identifiers) {
        note(differences, "node-identifier", subject, node_identifier_text(base, a.node_id),
             node_identifier_text(base, b.node_id));
    }
    note(differences, "bit-rate", "CANopen bit rate", bit_rate_text(a.can2), bit_rate_text(b.can2));
    note(differences, "heartbeat", "heartbeat sent", time_text(a.heartbeat_producer),
         time_text(b.heartbeat_producer));
    note(differences, "heartbeat", "heartbeat expected", monitoring_text(a), monitoring_text(b));
}

void compare_inputs(const Configuration& a, const Configuration& b, Differences& differences) {
    compare_input_maps("switch", switches_of(a), switches_of(b), differences);
    compare_input_maps("sensor", sensors_of(a), sensors_of(b), differences);
}

}  // namespace cgw::compare
