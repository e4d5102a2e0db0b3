#include "simulation/plc.hpp"

#include <algorithm>

#include "canopen/nmt.hpp"
#include "simulation/readings.hpp"
#include "wire/little_endian.hpp"

namespace cgw::simulation {
namespace {

constexpr Time longest_period = 50'000;  // us, of what is sent without being asked for
constexpr std::uint16_t load_enable_switch = 835;
constexpr std::size_t flags_word = 2;  // RPDO1 word 3 (D25)
constexpr double healthy_load = 60;    // %

// Twice in the time within which the gateway expects it.
Time period_for(Time monitoring) {
    return monitoring == 0 ? longest_period : std::min(longest_period, monitoring / 2);
}

image::Pdo rpdo_of(const image::Image& image, std::uint8_t rpdo) {
    return image.pdo(facts::tpdo_count + rpdo - 1U);
}

void set_bit(std::uint16_t& word, unsigned bit, bool on) {
    const unsigned mask = 1U << (bit - 1U);
    word = static_cast<std::uint16_t>(on ? word | mask : word & ~mask);
}

}  // namespace

Plc::Plc(Bus& bus, MasterNode& node, const image::Image& image) : node_(&node), image_(&image) {
    bus.attach_clock(*this);
}

void Plc::set_healthy_outputs() {
    outputs_ = {};
    for (std::size_t i = 0; i < image_->switch_count(); ++i) {
        const std::uint16_t number = image_->switch_function(i).number;
        set_switch(number, number == load_enable_switch);
    }
    EngineState rated;
    rated.load = healthy_load;
    rated.power = healthy_load;
    for (std::size_t i = 0; i < image_->sensor_count(); ++i) {
        const std::uint16_t number = image_->sensor(i).number;
        set_sensor(number, sensor_word(*image_, number, rated, 0));
    }
}

void Plc::send_outputs() {
    for (std::uint8_t rpdo = 1; rpdo <= facts::rpdo_count; ++rpdo) {
        produce(rpdo);
    }
}

void Plc::produce(std::uint8_t rpdo) {
    const image::Pdo pdo = rpdo_of(*image_, rpdo);
    if (!pdo.active || silent(rpdo)) {
        return;
    }
    frame::Frame frame;
    frame.id = pdo.cob_id;
    frame.length = static_cast<std::uint8_t>(facts::word_bytes * pdo.word_count);
    for (std::size_t word = 0; word < pdo.word_count; ++word) {
        wire::store_u16(&frame.data[facts::word_bytes * word], outputs_[rpdo - 1U][word]);
    }
    node_->produce(frame, period_for(pdo.effective_us));
}

// In the name of the partner whose heartbeat the gateway watches.
void Plc::send_heartbeat() {
    const image::Heartbeat heartbeat = image_->heartbeat();
    if (heartbeat.consumer_us != 0) {
        node_->produce(canopen::heartbeat_frame(heartbeat.consumer_node, canopen::NmtState::operational),
                       period_for(heartbeat.consumer_us));
    }
}

void Plc::silence_rpdo(std::uint8_t rpdo, bool silent) {
    silent_[rpdo - 1U] = silent;
    if (silent) {
        node_->stop_producing(rpdo_of(*image_, rpdo).cob_id);
    } else {
        produce(rpdo);
    }
}

void Plc::silence_heartbeat(bool silent) {
    if (silent) {
        node_->stop_producing(canopen::cob::heartbeat + std::uint32_t{image_->heartbeat().consumer_node});
    } else {
        send_heartbeat();
    }
}

bool Plc::set_sensor(std::uint16_t number, std::uint16_t word) {
    const auto sensor = find_sensor(*image_, number);
    if (sensor) {
        outputs_[facts::rpdo_of_channel(sensor->channel) - 1U][facts::word_of_channel(sensor->channel) - 1U] =
            word;
    }
    return sensor.has_value();
}

bool Plc::flag_sensor(std::uint16_t number, bool faulty) {
    const auto sensor = find_sensor(*image_, number);
    if (sensor) {
        set_bit(outputs_[0][flags_word], sensor->channel, faulty);
    }
    return sensor.has_value();
}

bool Plc::set_switch(std::uint16_t number, bool on) {
    const auto function = find_switch(*image_, number);
    if (function) {
        set_bit(outputs_[0][0], function->bit, on != function->low_active);
    }
    return function.has_value();
}

Time Plc::poll(Time now) {
    if (boot_ups_seen_ != node_->boot_ups().size()) {
        boot_ups_seen_ = node_->boot_ups().size();
        const std::uint8_t gateway = image_->can2().own_node;
        if (starts_ && node_->boot_ups().back().node_id == gateway) {
            start_due_ = now + start_delay;
        }
    }
    if (now >= start_due_ && node_->master().command(canopen::NmtCommand::start, image_->can2().own_node)) {
        start_due_ = canopen::never;
    }
    return now < start_due_ ? start_due_ : canopen::never;
}

std::optional<image::Sensor> find_sensor(const image::Image& image, std::uint16_t number) {
    for (std::size_t i = 0; i < image.sensor_count(); ++i) {
        if (image.sensor(i).number == number) {
            return image.sensor(i);
        }
    }
    return std::nullopt;
}

std::optional<image::SwitchFunction> find_switch(const image::Image& image, std::uint16_t number) {
    for (std::size_t i = 0; i < image.switch_count(); ++i) {
        if (image.switch_function(i).number == number) {
            return image.switch_function(i);
        }
    }
    return std::nullopt;
}

std::optional<WordPlace> find_word(const image::Image& image, std::uint16_t parameter) {
    for (std::size_t position = 0; position < facts::tpdo_count; ++position) {
        const image::Pdo pdo = image.pdo(position);
        for (std::size_t word = 0; pdo.active && word < pdo.word_count; ++word) {
            if (parameter != 0 && pdo.mapping[word].parameter == parameter) {
                return WordPlace{pdo, word};
            }
        }
    }
    return std::nullopt;
}

std::map<std::uint16_t, std::uint16_t> received_words(const MasterNode& node, const image::Image& image) {
    std::map<std::uint16_t, std::uint16_t> words;
    for (std::size_t position = 0; position < facts::tpdo_count; ++position) {
        const image::Pdo pdo = image.pdo(position);
        const auto received = pdo.active ? node.received(pdo.cob_id) : std::nullopt;
        for (std::size_t word = 0; received && word < pdo.word_count; ++word) {
            if (pdo.mapping[word].parameter != 0) {
                words[pdo.mapping[word].parameter] =
                    wire::load_u16(&received->last.data[facts::word_bytes * word]);
            }
        }
    }
    return words;
}

void subscribe_transmit_pdos(MasterNode& node, const image::Image& image) {
    for (std::size_t position = 0; position < facts::tpdo_count; ++position) {
        const image::Pdo pdo = image.pdo(position);
        if (pdo.active) {
            node.master().subscribe(pdo.cob_id);
        }
    }
}

}  // namespace cgw::simulation
