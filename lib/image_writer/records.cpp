// The sections that follow from the configuration alone.
#include <map>

#include "facts/communication.hpp"
#include "image_writer/sections.hpp"

namespace cgw::image_writer {
namespace {

using config::BusTiming;
using config::Direction;

constexpr std::uint16_t identity_index = facts::object::identity;
constexpr std::uint8_t sensor_width = 16;  // 2004h is UNSIGNED16 (manual 5.1.5)

void put_registers(Record& record, std::size_t offset, const BusTiming& timing) {
    record.u8(offset, timing.prescaler);
    record.u8(offset + 1, timing.sync_jump_width);
    record.u8(offset + 2, timing.sampling_mode);
    record.u8(offset + 3, timing.phase_segment_1);
    record.u8(offset + 4, timing.phase_segment_2);
}

Record bus_record(std::uint8_t own_node, std::uint8_t peer_node, const BusTiming& timing,
                  std::uint32_t start_up_delay_ms) {
    namespace at = image::bus;
    Record record(at::size);
    record.u8(at::own_node, own_node);
    record.u8(at::peer_node, peer_node);
    record.flag(at::manual_timing, timing.manual);
    record.u16(at::bit_rate_kbit, timing.bit_rate_kbit);
    put_registers(record, at::registers, timing);
    record.u8(at::registers + 5, timing.prop_segment);
    record.u32(at::start_up_delay_ms, start_up_delay_ms);
    return record;
}

Record pdo_record(const config::Pdo& pdo) {
    namespace at = image::pdo;
    Record record(at::size);
    record.flag(at::direction, pdo.direction == Direction::receive);
    record.u8(at::number, pdo.number);
    record.flag(at::active, pdo.active);
    record.flag(at::cob_id_source, pdo.cob_id_source == config::CobIdSource::parameter);
    record.u16(at::cob_id, pdo.cob_id);
    record.u8(at::word_count, static_cast<std::uint8_t>(pdo.mapping.size()));
    record.u8(at::transmission_type, config::transmission_type);
    record.u32(at::effective_us, pdo.time.effective_us);
    record.u16(at::asked_ms, static_cast<std::uint16_t>(pdo.time.asked_ms));
    record.u16(at::cycles, static_cast<std::uint16_t>(pdo.time.cycles));
    for (std::size_t word = 0; word < pdo.mapping.size(); ++word) {
        const config::MappedWord& mapped = pdo.mapping[word];
        record.u32(at::mapping + 4 * word, (static_cast<std::uint32_t>(mapped.index) << 16) |
                                               (static_cast<std::uint32_t>(mapped.sub_index) << 8) |
                                               config::word_bits);
        if (mapped.parameter != nullptr) {
            record.u16(at::parameters + 2 * word, mapped.parameter->number);
        }
    }
    return record;
}

// The word as it travels: its own limits where the catalogue knows them, else all that the width can hold.
Record signal_record(const parameter::Row& row) {
    namespace at = image::signal;
    const bool sensor = row.role == parameter::Role::sensor_assignment;
    const std::uint8_t width = sensor ? sensor_width : row.width;
    const bool is_signed = !sensor && row.is_signed;
    const std::int32_t span = std::int32_t{1} << width;
    const std::int32_t lowest = is_signed ? -span / 2 : 0;
    Record record(at::size);
    record.u16(at::number, row.number);
    record.u8(at::width, width);
    record.flag(at::is_signed, is_signed);
    const std::int32_t minimum = row.scaling ? row.scaling->internal_minimum : lowest;
    const std::int32_t maximum = row.scaling ? row.scaling->internal_maximum : lowest + span - 1;
    record.u16(at::internal_minimum, static_cast<std::uint16_t>(minimum));
    record.u16(at::internal_maximum, static_cast<std::uint16_t>(maximum));
    return record;
}

}  // namespace

Section identity_section(const Source& source) {
    Section section{image::SectionId::identity, image::identity::size, {}};
    Record record(image::identity::size);
    for (std::uint8_t sub = 1; sub <= 4; ++sub) {
        if (const dictionary::Variable* variable = source.dictionary.find(identity_index, sub)) {
            const std::uint64_t value = variable->default_value.resolve(source.configuration.node_id);
            record.u32(4U * (sub - 1U), static_cast<std::uint32_t>(value));
        }
    }
    append(section, record);
    return section;
}

Section buses_section(const Source& source) {
    const config::Configuration& configuration = source.configuration;
    Section section{image::SectionId::buses, image::bus::size, {}};
    append(section, bus_record(configuration.gateway_node, configuration.governor_node_in_gateway,
                               configuration.can1, configuration.gateway_start_up_delay_ms));
    append(section, bus_record(configuration.node_id, configuration.partner_node_id, configuration.can2, 0));
    return section;
}

Section governor_section(const Source& source) {
    namespace at = image::governor;
    const config::Configuration& configuration = source.configuration;
    Section section{image::SectionId::governor, at::size, {}};
    Record record(at::size);
    record.u8(at::own_node, configuration.governor_node);
    record.u8(at::gateway_node, configuration.gateway_node_in_governor);
    record.flag(at::manual_timing, configuration.governor_can.manual);
    record.flag(at::send_errors, configuration.send_errors);
    record.u16(at::bit_rate_kbit, configuration.governor_can.bit_rate_kbit);
    put_registers(record, at::registers, configuration.governor_can);
    record.u32(at::start_up_delay_ms, configuration.governor_start_up_delay_ms);
    record.u32(at::main_cycle_us, configuration.main_cycle_us);
    record.flag(at::send_status, configuration.send_status);
    append(section, record);
    return section;
}

Section heartbeat_section(const Source& source) {
    namespace at = image::heartbeat;
    Section section{image::SectionId::heartbeat, at::size, {}};
    Record record(at::size);
    record.u32(at::producer_us, source.configuration.heartbeat_producer.effective_us);
    record.u32(at::consumer_us, source.configuration.heartbeat_consumer.effective_us);
    record.u8(at::consumer_node, source.configuration.partner_node_id);
    append(section, record);
    return section;
}

Section pdos_section(const Source& source) {
    Section section{image::SectionId::pdos, image::pdo::size, {}};
    for (const config::Pdo& pdo : source.configuration.pdos) {
        append(section, pdo_record(pdo));
    }
    return section;
}

Section switches_section(const Source& source) {
    namespace at = image::switch_function;
    Section section{image::SectionId::switches, at::size, {}};
    for (const config::SwitchFunction& function : source.configuration.switches) {
        Record record(at::size);
        record.u16(at::number, function.row->number);
        record.u8(at::bit, function.bit);
        record.flag(at::low_active, function.low_active);
        append(section, record);
    }
    return section;
}

Section sensors_section(const Source& source) {
    namespace at = image::sensor;
    Section section{image::SectionId::sensors, at::size, {}};
    for (const config::Sensor& sensor : source.configuration.sensors) {
        Record record(at::size);
        record.u16(at::number, sensor.row->number);
        record.u8(at::channel, sensor.channel);
        append(section, record);
    }
    return section;
}

std::vector<const parameter::Row*> carried_parameters(const config::Configuration& configuration) {
    std::map<std::uint16_t, const parameter::Row*> rows;
    for (const config::Pdo& pdo : configuration.pdos) {
        for (const config::MappedWord& word : pdo.mapping) {
            if (word.parameter != nullptr) {
                rows.emplace(word.parameter->number, word.parameter);
            }
        }
    }
    for (const config::Sensor& sensor : configuration.sensors) {
        rows.emplace(sensor.row->number, sensor.row);
    }
    std::vector<const parameter::Row*> result;
    result.reserve(rows.size());
    for (const auto& [number, row] : rows) {
        result.push_back(row);
    }
    return result;
}

Section signals_section(const Source& source) {
    Section section{image::SectionId::signals, image::signal::size, {}};
    for (const parameter::Row* row : carried_parameters(source.configuration)) {
        append(section, signal_record(*row));
    }
    return section;
}

}  // namespace cgw::image_writer
