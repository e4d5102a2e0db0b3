// Parameters from what a gateway needs to run: less than the parameter file said.
#include <fmt/format.h>

#include "authoring/image_draft.hpp"
#include "config/monitoring_time.hpp"
#include "config/numbers.hpp"

namespace cgw::authoring {
namespace {

using parameter::CanonicalRow;
using parameter::Device;
namespace governor = config::governor;
namespace gateway = config::gateway;

constexpr double milliseconds_per_second = 1000;

template <std::size_t count>
void set_timing(ImageDraft& to, Device device, std::uint16_t prescaler,
                const std::array<std::uint8_t, count>& registers) {
    for (std::size_t i = 0; i < count; ++i) {
        to.set(device, static_cast<std::uint16_t>(prescaler + i), registers[i]);
    }
}

void set_governor(const image::Governor& from, ImageDraft& to) {
    constexpr Device device = Device::governor;
    to.set(device, governor::own_node, from.own_node);
    to.set(device, governor::gateway_node, from.gateway_node);
    to.set(device, governor::manual_timing, from.manual_timing ? 1 : 0);
    to.set(device, governor::bit_rate, from.bit_rate_kbit);
    set_timing(to, device, governor::prescaler, from.registers);
    to.set(device, governor::start_up_delay, from.start_up_delay_ms / milliseconds_per_second);
    to.set(device, governor::gateway_communication, 1);
    to.set(device, governor::send_errors, from.send_errors ? 1 : 0);
    to.set(device, governor::send_status, from.send_status ? 1 : 0);
    if (from.main_cycle_us != facts::usual_governor_main_cycle_us) {
        to.draft.main_cycle_us = from.main_cycle_us;
    }
}

// The shortest time that becomes the same number of cycles.
std::uint32_t heartbeat_ms(std::uint32_t effective_us) {
    constexpr std::uint32_t cycle = config::gateway_main_cycle_us;
    return static_cast<std::uint32_t>(config::milliseconds_for(effective_us / cycle, cycle));
}

void set_gateway(const image::Image& from, ImageDraft& to) {
    constexpr Device device = Device::gateway;
    const image::Bus can1 = from.can1();
    const image::Bus can2 = from.can2();
    to.set(device, gateway::own_node, can1.own_node);
    to.set(device, gateway::governor_node, can1.peer_node);
    to.set(device, gateway::hzm_manual_timing, can1.manual_timing ? 1 : 0);
    to.set(device, gateway::hzm_bit_rate, can1.bit_rate_kbit);
    set_timing(to, device, gateway::hzm_prescaler, can1.registers);
    to.set(device, gateway::start_up_delay, can1.start_up_delay_ms / milliseconds_per_second);
    to.set(device, gateway::governor_communication, 1);
    to.set(device, gateway::canopen_manual_timing, can2.manual_timing ? 1 : 0);
    to.set(device, gateway::canopen_bit_rate, can2.bit_rate_kbit);
    set_timing(to, device, gateway::canopen_prescaler, can2.registers);
    to.set(device, gateway::node_id, can2.own_node);
    to.set(device, gateway::partner_node_id, can2.peer_node);
    const image::Heartbeat heartbeat = from.heartbeat();
    to.set(device, gateway::heartbeat_producer, heartbeat_ms(heartbeat.producer_us));
    to.set(device, gateway::heartbeat_consumer, heartbeat_ms(heartbeat.consumer_us));
    if (heartbeat.producer_us != 0 || heartbeat.consumer_us != 0) {
        to.lost.emplace_back("heartbeat times (429, 430) as typed: the shortest that work alike stand here");
    }
}

void set_tpdo(const image::Pdo& pdo, ImageDraft& to) {
    const int number = pdo.number;
    if (pdo.cob_id_from_parameter) {
        to.set(Device::gateway, gateway::tpdo_identifier_of(number), pdo.cob_id);
    }
    if (number < config::first_analogue_tpdo) {
        return;
    }
    to.set(Device::governor, governor::tpdo_cycle_of(number), pdo.asked_ms);
    for (int word = 1; word <= pdo.word_count; ++word) {
        const std::uint16_t parameter = pdo.mapping[static_cast<std::size_t>(word - 1)].parameter;
        to.set(Device::governor, governor::tpdo_assignment_of(number, word), parameter);
    }
}

void set_pdos(const image::Image& from, ImageDraft& to) {
    for (std::size_t i = 0; i < image::pdo::count; ++i) {
        const image::Pdo pdo = from.pdo(i);
        if (pdo.receive) {
            to.set(Device::governor, governor::rpdo_monitoring_of(pdo.number), pdo.asked_ms);
        } else {
            set_tpdo(pdo, to);
        }
    }
}

void set_inputs(const image::Image& from, ImageDraft& to) {
    for (std::size_t i = 0; i < from.switch_count(); ++i) {
        const image::SwitchFunction function = from.switch_function(i);
        to.set(Device::governor, function.number, function.low_active ? -function.bit : function.bit);
        to.set(Device::governor, governor::type_of(function.number), governor::canopen_type);
    }
    for (std::size_t i = 0; i < from.sensor_count(); ++i) {
        const image::Sensor sensor = from.sensor(i);
        to.set(Device::governor, sensor.number, sensor.channel);
        to.set(Device::governor, governor::type_of(sensor.number), governor::canopen_type);
    }
}

void set_identity(const image::Identity& from, ImageDraft& to) {
    to.draft.identity = {from.revision, from.serial >> 16, from.serial & 0xFFFFU};  // D32
}

bool is_whole_range(const image::Signal& signal) {
    const std::int32_t span = std::int32_t{1} << signal.width;
    const std::int32_t lowest = signal.is_signed ? -span / 2 : 0;
    return signal.internal_minimum == lowest && signal.internal_maximum == lowest + span - 1;
}

bool find_label(const image::Image& from, const ImageDraft& to, std::uint16_t number, image::Label& label) {
    return to.reads_labels && from.find_label(number, label);
}

// A name of its own: the label's, or one that says what is known.
std::string name_for(const image::Signal& signal, const image::Image& from, const ImageDraft& to) {
    image::Label label;
    const std::string name =
        find_label(from, to, signal.number, label) ? std::string(label.name) : std::string();
    const bool is_free = !name.empty() && to.catalogue().find(Device::governor, name) == nullptr;
    return is_free ? name : fmt::format("Measurement{}", signal.number);
}

void declare_signal(const image::Signal& signal, const image::Image& from, ImageDraft& to) {
    CanonicalRow row;
    row.number = signal.number;
    row.name = name_for(signal, from, to);
    row.list = parameter::List::measurement;
    row.width = signal.width;
    row.is_signed = signal.is_signed;
    image::Label label;
    const bool labelled = find_label(from, to, signal.number, label);
    row.unit = labelled ? std::string(label.unit) : "";
    if (!is_whole_range(signal) || (labelled && label.has_scaling)) {
        row.scaling = parameter::Scaling{.internal_minimum = signal.internal_minimum,
                                         .internal_maximum = signal.internal_maximum};
    }
    if (labelled && label.has_scaling) {
        row.scaling->external_minimum = label.external_minimum;
        row.scaling->external_maximum = label.external_maximum;
    }
    to.declare(std::move(row));
}

void set_signals(const image::Image& from, ImageDraft& to) {
    for (std::size_t i = 0; i < from.signal_count(); ++i) {
        const image::Signal signal = from.signal(i);
        const parameter::Row* known = to.catalogue().find(Device::governor, signal.number);
        if (known == nullptr && !facts::is_sensor(signal.number)) {
            declare_signal(signal, from, to);
            continue;
        }
        image::Label label;
        if (known != nullptr && find_label(from, to, signal.number, label)) {
            to.set_references(*known, label);
        }
    }
}

}  // namespace

void draft_sections(const image::Image& image, ImageDraft& to) {
    image::Label title;
    if (find_label(image, to, 0, title)) {
        to.draft.title = title.name;
    } else {
        to.lost.emplace_back("title, and names, units and ranges of what was declared");
    }
    set_governor(image.governor(), to);
    set_gateway(image, to);
    set_pdos(image, to);
    set_inputs(image, to);
    set_identity(image.identity(), to);
    set_signals(image, to);
    to.lost.emplace_back("words of TPDOs that are not sent, and gaps between words that closed up");
    to.lost.emplace_back("switches and sensors that do not come over CANopen");
    to.lost.emplace_back("every parameter that the gateway does not need");
}

}  // namespace cgw::authoring
