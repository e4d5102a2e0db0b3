#include "image/image.hpp"

#include <bit>

#include "image/bytes.hpp"
#include "wire/little_endian.hpp"

namespace cgw::image {
namespace {

struct StatusText {
    Status status;
    std::string_view text;
};

constexpr StatusText status_texts[] = {
    {Status::ok, "valid"},
    {Status::too_small, "too few bytes for an image"},
    {Status::too_large, "too many bytes for an image"},
    {Status::bad_magic, "it does not begin with \"CGWI\""},
    {Status::unsupported_major, "written in another major format version"},
    {Status::bad_header_size, "the header has a wrong size or uses reserved bytes"},
    {Status::size_mismatch, "the stated size is not the number of bytes"},
    {Status::bad_crc, "the CRC-32 does not match"},
    {Status::bad_directory, "the section directory is not consistent"},
    {Status::section_missing, "a required section is missing"},
    {Status::bad_section, "a record holds a value that no configuration can have"},
    {Status::bad_object_table, "the object table is not consistent"},
    {Status::bad_mapping, "a PDO mapping does not fit the object table"},
    {Status::bad_label, "a label is not consistent"},
};

template <typename Found>
bool find_by_number(const Records& records, std::uint16_t number, const Found& found) {
    std::size_t low = 0;
    std::size_t high = records.count();
    while (low < high) {
        const std::size_t middle = low + (high - low) / 2;
        const std::uint16_t here = wire::load_u16(records.at(middle));
        if (here == number) {
            found(middle);
            return true;
        }
        if (here < number) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return false;
}

void copy_registers(std::span<std::uint8_t> to, const std::uint8_t* from) {
    for (std::size_t i = 0; i < to.size(); ++i) {
        to[i] = from[i];
    }
}

Bus decode_bus(const std::uint8_t* record) {
    Bus result;
    result.own_node = record[bus::own_node];
    result.peer_node = record[bus::peer_node];
    result.manual_timing = record[bus::manual_timing] != 0;
    result.bit_rate_kbit = wire::load_u16(record + bus::bit_rate_kbit);
    copy_registers(result.registers, record + bus::registers);
    result.start_up_delay_ms = wire::load_u32(record + bus::start_up_delay_ms);
    return result;
}

}  // namespace

std::string_view to_text(Status status) {
    for (const StatusText& row : status_texts) {
        if (row.status == status) {
            return row.text;
        }
    }
    return "unknown";
}

std::uint16_t Image::format_major() const {
    return wire::load_u16(bytes_.data() + header::format_major);
}

std::uint16_t Image::format_minor() const {
    return wire::load_u16(bytes_.data() + header::format_minor);
}

std::array<std::uint16_t, 3> Image::tool_version() const {
    const std::uint8_t* from = bytes_.data() + header::tool_version;
    return {wire::load_u16(from), wire::load_u16(from + 2), wire::load_u16(from + 4)};
}

std::span<const std::uint8_t> Image::configuration_id() const {
    return bytes_.subspan(header::configuration_id, header::configuration_id_size);
}

std::uint32_t Image::crc() const {
    return wire::load_u32(bytes_.data() + bytes_.size() - crc_size);
}

Identity Image::identity() const {
    const std::uint8_t* record = records(SectionId::identity).at(0);
    return {wire::load_u32(record + identity::vendor), wire::load_u32(record + identity::product),
            wire::load_u32(record + identity::revision), wire::load_u32(record + identity::serial)};
}

Bus Image::can1() const {
    return decode_bus(records(SectionId::buses).at(0));
}

Bus Image::can2() const {
    return decode_bus(records(SectionId::buses).at(1));
}

Governor Image::governor() const {
    const std::uint8_t* record = records(SectionId::governor).at(0);
    Governor result;
    result.own_node = record[governor::own_node];
    result.gateway_node = record[governor::gateway_node];
    result.manual_timing = record[governor::manual_timing] != 0;
    result.send_errors = record[governor::send_errors] != 0;
    result.send_status = record[governor::send_status] != 0;
    result.bit_rate_kbit = wire::load_u16(record + governor::bit_rate_kbit);
    copy_registers(result.registers, record + governor::registers);
    result.start_up_delay_ms = wire::load_u32(record + governor::start_up_delay_ms);
    result.main_cycle_us = wire::load_u32(record + governor::main_cycle_us);
    return result;
}

Heartbeat Image::heartbeat() const {
    const std::uint8_t* record = records(SectionId::heartbeat).at(0);
    return {wire::load_u32(record + heartbeat::producer_us), wire::load_u32(record + heartbeat::consumer_us),
            record[heartbeat::consumer_node]};
}

Pdo Image::pdo(std::size_t position) const {
    const std::uint8_t* record = records(SectionId::pdos).at(position);
    Pdo result;
    result.receive = record[pdo::direction] != 0;
    result.number = record[pdo::number];
    result.active = record[pdo::active] != 0;
    result.cob_id_from_parameter = record[pdo::cob_id_source] != 0;
    result.cob_id = wire::load_u16(record + pdo::cob_id);
    result.word_count = record[pdo::word_count];
    result.transmission_type = record[pdo::transmission_type];
    result.effective_us = wire::load_u32(record + pdo::effective_us);
    result.asked_ms = wire::load_u16(record + pdo::asked_ms);
    result.cycles = wire::load_u16(record + pdo::cycles);
    for (std::size_t word = 0; word < result.mapping.size(); ++word) {
        const std::uint32_t entry = wire::load_u32(record + pdo::mapping + 4 * word);
        MappedObject& object = result.mapping[word];
        object.index = static_cast<std::uint16_t>(entry >> 16);
        object.sub_index = static_cast<std::uint8_t>(entry >> 8);
        object.bits = static_cast<std::uint8_t>(entry);
        object.parameter = wire::load_u16(record + pdo::parameters + 2 * word);
    }
    return result;
}

std::size_t Image::switch_count() const {
    return records(SectionId::switches).count();
}

SwitchFunction Image::switch_function(std::size_t position) const {
    const std::uint8_t* record = records(SectionId::switches).at(position);
    return {wire::load_u16(record + switch_function::number), record[switch_function::bit],
            record[switch_function::low_active] != 0};
}

std::size_t Image::sensor_count() const {
    return records(SectionId::sensors).count();
}

Sensor Image::sensor(std::size_t position) const {
    const std::uint8_t* record = records(SectionId::sensors).at(position);
    return {wire::load_u16(record + sensor::number), record[sensor::channel]};
}

std::size_t Image::signal_count() const {
    return records(SectionId::signals).count();
}

Signal Image::signal(std::size_t position) const {
    const std::uint8_t* record = records(SectionId::signals).at(position);
    const bool is_signed = record[signal::is_signed] != 0;
    const auto limit = [record, is_signed](std::size_t at) -> std::int32_t {
        const std::uint16_t word = wire::load_u16(record + at);
        return is_signed ? static_cast<std::int16_t>(word) : std::int32_t{word};
    };
    return {wire::load_u16(record + signal::number), record[signal::width], is_signed,
            limit(signal::internal_minimum), limit(signal::internal_maximum)};
}

bool Image::find_signal(std::uint16_t number, Signal& signal) const {
    return find_by_number(records(SectionId::signals), number,
                          [&](std::size_t position) { signal = this->signal(position); });
}

object::ObjectTable Image::objects() const {
    const Records& table = records(SectionId::objects);
    return object::ObjectTable({table.data, table.size}, table.record_size);
}

std::span<const std::uint8_t> Image::initial_values() const {
    const Records& values = records(SectionId::object_values);
    return {values.data, values.size};
}

std::string_view Image::model() const {
    const Records& text = records(SectionId::model);
    return {reinterpret_cast<const char*>(text.data), text.size};
}

std::size_t Image::label_count() const {
    return records(SectionId::labels).count();
}

Label Image::label(std::size_t position) const {
    const std::uint8_t* record = records(SectionId::labels).at(position);
    const auto* text = reinterpret_cast<const char*>(records(SectionId::strings).data);
    Label result;
    result.number = wire::load_u16(record + label::number);
    result.name = {text + wire::load_u32(record + label::name_offset), record[label::name_length]};
    result.unit = {text + wire::load_u32(record + label::unit_offset), record[label::unit_length]};
    result.has_scaling = record[label::has_scaling] != 0;
    result.external_minimum = std::bit_cast<double>(load_u64(record + label::external_minimum));
    result.external_maximum = std::bit_cast<double>(load_u64(record + label::external_maximum));
    return result;
}

bool Image::find_label(std::uint16_t number, Label& label) const {
    return find_by_number(records(SectionId::labels), number,
                          [&](std::size_t position) { label = this->label(position); });
}

}  // namespace cgw::image
