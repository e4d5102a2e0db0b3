#include "inspect/fields.hpp"

#include <iterator>

#include "facts/gateway.hpp"
#include "facts/identifiers.hpp"
#include "inspect/record_fields.hpp"

namespace cgw::inspect {
namespace {

using image::SectionId;
using enum Type;
using enum Shown;

constexpr std::string_view version_parts[] = {"major", "minor", "patch"};

constexpr Field header_fields[] = {
    {.name = "magic",
     .offset = image::header::magic,
     .type = text,
     .meaning = "the letters `CGWI`",
     .count = sizeof image::magic},
    {.name = "format_major",
     .offset = image::header::format_major,
     .type = u16,
     .meaning = "another one is refused",
     .range = Range{image::format_major, image::format_major}},
    {.name = "format_minor",
     .offset = image::header::format_minor,
     .type = u16,
     .meaning = "a higher one only adds"},
    {.name = "header_size",
     .offset = image::header::header_size,
     .type = u16,
     .meaning = "where the directory begins",
     .note = "64 in minor 0, a multiple of 4"},
    {.name = "section_count",
     .offset = image::header::section_count,
     .type = u16,
     .meaning = "entries of the directory"},
    {.name = "total_size",
     .offset = image::header::total_size,
     .type = u32,
     .meaning = "bytes of the whole image",
     .note = "CRC-32 included"},
    {.name = "configuration_id",
     .offset = image::header::configuration_id,
     .type = bytes,
     .meaning = "SHA-256 of the canonical model",
     .count = image::header::configuration_id_size},
    {.name = "tool_version",
     .offset = image::header::tool_version,
     .type = u16,
     .meaning = "the cgw that wrote the image",
     .count = 3,
     .elements = version_parts},
    {.name = "reserved",
     .offset = image::header::reserved,
     .type = bytes,
     .meaning = "0",
     .count = image::header::size - image::header::reserved,
     .shown = reserved},
};

constexpr Field directory_fields[] = {
    {.name = "id",
     .offset = image::directory::id,
     .type = u16,
     .meaning = "the section's number",
     .note = "from the table below; ascending"},
    {.name = "record_size",
     .offset = image::directory::record_size,
     .type = u16,
     .meaning = "bytes of one record",
     .note = "from one to the next"},
    {.name = "offset",
     .offset = image::directory::offset,
     .type = u32,
     .meaning = "where the section begins",
     .note = "from the image's first byte"},
    {.name = "size",
     .offset = image::directory::size,
     .type = u32,
     .meaning = "bytes of the section",
     .note = "a multiple of record_size"},
};

constexpr Field trailer_fields[] = {
    {.name = "crc32", .type = u32, .meaning = "CRC-32 of all bytes before", .shown = hexadecimal},
};

constexpr Record records[] = {
    {.name = "header", .size = image::header::size, .fields = header_fields, .count = 1},
    {.name = "directory", .size = image::directory::entry_size, .fields = directory_fields},
    {"identity", SectionId::identity, image::identity::size, identity_fields, 1, "1", true, "object 1018h"},
    {"buses", SectionId::buses, image::bus::size, bus_fields, 2, "2", true,
     "CAN1 (HEINZMANN), CAN2 (CANopen)"},
    {"governor", SectionId::governor, image::governor::size, governor_fields, 1, "1", true,
     "the governor's half of the configuration"},
    {"heartbeat", SectionId::heartbeat, image::heartbeat::size, heartbeat_fields, 1, "1", true,
     "own and monitored heartbeat"},
    {"pdos", SectionId::pdos, image::pdo::size, pdo_fields, image::pdo::count, "20", true,
     "TPDO1..16, RPDO1..4"},
    {"objects", SectionId::objects, image::object_record::size, object_fields, 0, "1 or more", true,
     "the object dictionary"},
    {"object_values", SectionId::object_values, 1, {}, 0, "any", true, "its values at start"},
    {"switches", SectionId::switches, image::switch_function::size, switch_fields, 0, "any", true,
     "switch functions that RPDO1 carries"},
    {"sensors", SectionId::sensors, image::sensor::size, sensor_fields, 0, "any", true,
     "sensors that RPDO2..4 carry"},
    {"signals", SectionId::signals, image::signal::size, signal_fields, 0, "any", true,
     "width, sign and internal range of what the words carry"},
    {"labels", SectionId::labels, image::label::size, label_fields, 0, "any", false,
     "names, units, engineering ranges; may be left out"},
    {"strings",
     SectionId::strings,
     1,
     {},
     0,
     "any",
     false,
     "the labels' texts; there when the labels are",
     text},
    {"model",
     SectionId::model,
     1,
     {},
     0,
     "any",
     false,
     "the canonical model, a text; may be left out, also alone",
     text},
    {.name = "trailer", .size = image::crc_size, .fields = trailer_fields, .count = 1},
};
constexpr std::size_t first_section = 2;
static_assert(std::size(records) == first_section + image::section_ids - 1 + 1);

}  // namespace

std::span<const Record> all_records() {
    return records;
}

const Record& header() {
    return records[0];
}

const Record& directory() {
    return records[1];
}

const Record& trailer() {
    return records[std::size(records) - 1];
}

const Record* find_record(std::uint16_t section_id) {
    const bool known = section_id != 0 && section_id < image::section_ids;
    return known ? &records[first_section + section_id - 1U] : nullptr;
}

}  // namespace cgw::inspect
