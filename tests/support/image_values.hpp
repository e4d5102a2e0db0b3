// Every value of an image, one number after the other, in the order in which image/c_reader.c puts them.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "image/image.hpp"

namespace cgw::test {

using Numbers = std::vector<std::uint64_t>;

class Values {
  public:
    void put(auto... values) { (numbers.push_back(static_cast<std::uint64_t>(values)), ...); }
    void bytes(const auto& range) {
        for (const auto byte : range) {
            numbers.push_back(static_cast<std::uint8_t>(byte));
        }
    }
    void real(double value) { bytes(std::bit_cast<std::array<std::uint8_t, sizeof value>>(value)); }

    Numbers numbers;
};

inline void put_bus(Values& values, const image::Bus& bus) {
    values.put(bus.own_node, bus.peer_node, bus.manual_timing, bus.bit_rate_kbit);
    values.bytes(bus.registers);
    values.put(bus.start_up_delay_ms);
}

inline void put_devices(Values& values, const image::Image& image) {
    values.put(image.format_major(), image.format_minor());
    for (const std::uint16_t part : image.tool_version()) {
        values.put(part);
    }
    values.bytes(image.configuration_id());
    const image::Identity identity = image.identity();
    values.put(image.crc(), identity.vendor, identity.product, identity.revision, identity.serial);
    put_bus(values, image.can1());
    put_bus(values, image.can2());
    const image::Governor governor = image.governor();
    values.put(governor.own_node, governor.gateway_node, governor.manual_timing, governor.send_errors,
               governor.send_status, governor.bit_rate_kbit);
    values.bytes(governor.registers);
    values.put(governor.start_up_delay_ms, governor.main_cycle_us);
    const image::Heartbeat heartbeat = image.heartbeat();
    values.put(heartbeat.producer_us, heartbeat.consumer_us, heartbeat.consumer_node);
}

inline void put_pdos(Values& values, const image::Image& image) {
    for (std::size_t i = 0; i < image::pdo::count; ++i) {
        const image::Pdo pdo = image.pdo(i);
        values.put(pdo.receive, pdo.number, pdo.active, pdo.cob_id_from_parameter, pdo.cob_id,
                   pdo.transmission_type, pdo.effective_us, pdo.asked_ms, pdo.cycles, pdo.word_count);
        for (const image::MappedObject& word : pdo.mapping) {
            values.put(word.index, word.sub_index, word.bits, word.parameter);
        }
    }
}

inline void put_objects(Values& values, const image::Image& image) {
    const object::ObjectTable objects = image.objects();
    values.put(objects.size());
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const object::ObjectEntry entry = objects.entry(i);
        std::uint32_t value = 0;
        for (std::size_t byte = 0; byte < entry.length; ++byte) {
            value |= std::uint32_t{image.initial_values()[entry.offset + byte]} << (8 * byte);
        }
        values.put(entry.index, entry.sub_index, entry.type, entry.access, entry.flags, entry.length,
                   entry.offset, value);
    }
}

inline void put_inputs_and_signals(Values& values, const image::Image& image) {
    values.put(image.switch_count());
    for (std::size_t i = 0; i < image.switch_count(); ++i) {
        const image::SwitchFunction function = image.switch_function(i);
        values.put(function.number, function.bit, function.low_active);
    }
    values.put(image.sensor_count());
    for (std::size_t i = 0; i < image.sensor_count(); ++i) {
        values.put(image.sensor(i).number, image.sensor(i).channel);
    }
    values.put(image.signal_count());
    for (std::size_t i = 0; i < image.signal_count(); ++i) {
        const image::Signal signal = image.signal(i);
        values.put(signal.number, signal.width, signal.is_signed, std::int64_t{signal.internal_minimum},
                   std::int64_t{signal.internal_maximum});
    }
}

inline void put_labels(Values& values, const image::Image& image) {
    values.put(image.label_count());
    for (std::size_t i = 0; i < image.label_count(); ++i) {
        const image::Label label = image.label(i);
        values.put(label.number, label.name.size());
        values.bytes(label.name);
        values.put(label.unit.size());
        values.bytes(label.unit);
        values.put(label.has_scaling);
        values.real(label.external_minimum);
        values.real(label.external_maximum);
    }
}

inline Numbers values_of(const image::Image& image) {
    Values values;
    put_devices(values, image);
    put_pdos(values, image);
    put_objects(values, image);
    put_inputs_and_signals(values, image);
    put_labels(values, image);
    values.put(image.model().size());
    values.bytes(image.model());
    return values.numbers;
}

}  // namespace cgw::test
