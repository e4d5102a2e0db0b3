#include "simulation/inputs.hpp"

#include "facts/gateway.hpp"

namespace cgw::simulation {
namespace {

constexpr std::size_t flags_word = 2;  // RPDO1 word 3 (D25)

}  // namespace

void CanopenInputs::follow(const device::GatewayStatus& gateway) {
    const bool entered = gateway.operational_entries != gateway_.operational_entries;
    if (gateway.state != gateway_.state || entered) {
        received_.fill(false);
        words_ = {};
    }
    gateway_ = gateway;
}

bool CanopenInputs::late(std::size_t rpdo) const {
    return ((unsigned{gateway_.late_rpdos} >> (rpdo - 1)) & 1U) != 0;
}

bool CanopenInputs::absent(std::size_t rpdo) const {
    return !received_[rpdo - 1] && image_->pdo(facts::tpdo_count + rpdo - 1).effective_us == 0;
}

void CanopenInputs::receive(std::uint8_t rpdo, const device::PdoWords& words) {
    received_[rpdo - 1U] = true;
    words_[rpdo - 1U] = words;
}

std::optional<bool> CanopenInputs::switch_function(std::uint16_t number) const {
    for (std::size_t i = 0; i < image_->switch_count(); ++i) {
        const image::SwitchFunction function = image_->switch_function(i);
        if (function.number == number) {
            const bool bit = ((unsigned{words_[0][0]} >> (function.bit - 1U)) & 1U) != 0;
            // Without a telegram there is no bit yet, monitored or not.
            const bool known = operational() && received_[0] && !late(1) && !gateway_.heartbeat_lost;
            return known && bit != function.low_active;
        }
    }
    return std::nullopt;
}

CanopenInputs::SensorValue CanopenInputs::sensor(std::uint16_t number) const {
    for (std::size_t i = 0; i < image_->sensor_count(); ++i) {
        const image::Sensor sensor = image_->sensor(i);
        if (sensor.number == number) {
            return value_of(sensor);
        }
    }
    return {};
}

CanopenInputs::SensorValue CanopenInputs::value_of(const image::Sensor& sensor) const {
    const std::size_t rpdo = facts::rpdo_of_channel(sensor.channel);
    const bool flagged = ((unsigned{words_[0][flags_word]} >> (sensor.channel - 1U)) & 1U) != 0;
    SensorValue value;
    value.carried = true;
    value.faulty =
        !operational() || late(rpdo) || absent(rpdo) || flagged || late(1) || gateway_.heartbeat_lost;
    value.received = received_[rpdo - 1];
    value.word = words_[rpdo - 1][facts::word_of_channel(sensor.channel) - 1U];
    return value;
}

}  // namespace cgw::simulation
