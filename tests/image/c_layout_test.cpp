// The C reader's layout and codes are those of image/layout.hpp and image::Status; this file compiles or it
// does not.
#include "image/c/cgw_image.h"
#include "image/image.hpp"

namespace cgw::image {
namespace {

#define SAME(c_name, value) static_assert(static_cast<std::size_t>(c_name) == static_cast<std::size_t>(value))

SAME(CGW_IMAGE_FORMAT_MAJOR, format_major);
SAME(CGW_IMAGE_FORMAT_MINOR, format_minor);
SAME(CGW_IMAGE_MINIMUM_SIZE, minimum_size);
SAME(CGW_IMAGE_MAXIMUM_SIZE, maximum_size);
SAME(CGW_IMAGE_CRC_SIZE, crc_size);
SAME(CGW_IMAGE_HEADER_MAGIC, header::magic);
SAME(CGW_IMAGE_HEADER_FORMAT_MAJOR, header::format_major);
SAME(CGW_IMAGE_HEADER_FORMAT_MINOR, header::format_minor);
SAME(CGW_IMAGE_HEADER_HEADER_SIZE, header::header_size);
SAME(CGW_IMAGE_HEADER_SECTION_COUNT, header::section_count);
SAME(CGW_IMAGE_HEADER_TOTAL_SIZE, header::total_size);
SAME(CGW_IMAGE_HEADER_CONFIGURATION_ID, header::configuration_id);
SAME(CGW_IMAGE_HEADER_CONFIGURATION_ID_SIZE, header::configuration_id_size);
SAME(CGW_IMAGE_HEADER_TOOL_VERSION, header::tool_version);
SAME(CGW_IMAGE_HEADER_RESERVED, header::reserved);
SAME(CGW_IMAGE_HEADER_SIZE, header::size);
SAME(CGW_IMAGE_DIRECTORY_ID, directory::id);
SAME(CGW_IMAGE_DIRECTORY_RECORD_SIZE, directory::record_size);
SAME(CGW_IMAGE_DIRECTORY_OFFSET, directory::offset);
SAME(CGW_IMAGE_DIRECTORY_SIZE, directory::size);
SAME(CGW_IMAGE_DIRECTORY_ENTRY_SIZE, directory::entry_size);
SAME(CGW_IMAGE_IDENTITY_VENDOR, identity::vendor);
SAME(CGW_IMAGE_IDENTITY_PRODUCT, identity::product);
SAME(CGW_IMAGE_IDENTITY_REVISION, identity::revision);
SAME(CGW_IMAGE_IDENTITY_SERIAL, identity::serial);
SAME(CGW_IMAGE_IDENTITY_SIZE, identity::size);
SAME(CGW_IMAGE_BUS_OWN_NODE, bus::own_node);
SAME(CGW_IMAGE_BUS_PEER_NODE, bus::peer_node);
SAME(CGW_IMAGE_BUS_MANUAL_TIMING, bus::manual_timing);
SAME(CGW_IMAGE_BUS_BIT_RATE_KBIT, bus::bit_rate_kbit);
SAME(CGW_IMAGE_BUS_REGISTERS, bus::registers);
SAME(CGW_IMAGE_BUS_START_UP_DELAY_MS, bus::start_up_delay_ms);
SAME(CGW_IMAGE_BUS_SIZE, bus::size);
SAME(CGW_IMAGE_GOVERNOR_OWN_NODE, governor::own_node);
SAME(CGW_IMAGE_GOVERNOR_GATEWAY_NODE, governor::gateway_node);
SAME(CGW_IMAGE_GOVERNOR_MANUAL_TIMING, governor::manual_timing);
SAME(CGW_IMAGE_GOVERNOR_SEND_ERRORS, governor::send_errors);
SAME(CGW_IMAGE_GOVERNOR_BIT_RATE_KBIT, governor::bit_rate_kbit);
SAME(CGW_IMAGE_GOVERNOR_REGISTERS, governor::registers);
SAME(CGW_IMAGE_GOVERNOR_START_UP_DELAY_MS, governor::start_up_delay_ms);
SAME(CGW_IMAGE_GOVERNOR_MAIN_CYCLE_US, governor::main_cycle_us);
SAME(CGW_IMAGE_GOVERNOR_SEND_STATUS, governor::send_status);
SAME(CGW_IMAGE_GOVERNOR_SIZE, governor::size);
SAME(CGW_IMAGE_HEARTBEAT_PRODUCER_US, heartbeat::producer_us);
SAME(CGW_IMAGE_HEARTBEAT_CONSUMER_US, heartbeat::consumer_us);
SAME(CGW_IMAGE_HEARTBEAT_CONSUMER_NODE, heartbeat::consumer_node);
SAME(CGW_IMAGE_HEARTBEAT_SIZE, heartbeat::size);
SAME(CGW_IMAGE_PDO_DIRECTION, pdo::direction);
SAME(CGW_IMAGE_PDO_NUMBER, pdo::number);
SAME(CGW_IMAGE_PDO_ACTIVE, pdo::active);
SAME(CGW_IMAGE_PDO_COB_ID_SOURCE, pdo::cob_id_source);
SAME(CGW_IMAGE_PDO_COB_ID, pdo::cob_id);
SAME(CGW_IMAGE_PDO_WORD_COUNT, pdo::word_count);
SAME(CGW_IMAGE_PDO_TRANSMISSION_TYPE, pdo::transmission_type);
SAME(CGW_IMAGE_PDO_EFFECTIVE_US, pdo::effective_us);
SAME(CGW_IMAGE_PDO_ASKED_MS, pdo::asked_ms);
SAME(CGW_IMAGE_PDO_CYCLES, pdo::cycles);
SAME(CGW_IMAGE_PDO_MAPPING, pdo::mapping);
SAME(CGW_IMAGE_PDO_PARAMETERS, pdo::parameters);
SAME(CGW_IMAGE_PDO_SIZE, pdo::size);
SAME(CGW_IMAGE_PDO_COUNT, pdo::count);
SAME(CGW_IMAGE_OBJECT_SIZE, object::object_record_size);
SAME(CGW_IMAGE_SWITCH_NUMBER, switch_function::number);
SAME(CGW_IMAGE_SWITCH_BIT, switch_function::bit);
SAME(CGW_IMAGE_SWITCH_LOW_ACTIVE, switch_function::low_active);
SAME(CGW_IMAGE_SWITCH_SIZE, switch_function::size);
SAME(CGW_IMAGE_SENSOR_NUMBER, sensor::number);
SAME(CGW_IMAGE_SENSOR_CHANNEL, sensor::channel);
SAME(CGW_IMAGE_SENSOR_SIZE, sensor::size);
SAME(CGW_IMAGE_SIGNAL_NUMBER, signal::number);
SAME(CGW_IMAGE_SIGNAL_WIDTH, signal::width);
SAME(CGW_IMAGE_SIGNAL_IS_SIGNED, signal::is_signed);
SAME(CGW_IMAGE_SIGNAL_INTERNAL_MINIMUM, signal::internal_minimum);
SAME(CGW_IMAGE_SIGNAL_INTERNAL_MAXIMUM, signal::internal_maximum);
SAME(CGW_IMAGE_SIGNAL_SIZE, signal::size);
SAME(CGW_IMAGE_LABEL_NUMBER, label::number);
SAME(CGW_IMAGE_LABEL_NAME_LENGTH, label::name_length);
SAME(CGW_IMAGE_LABEL_UNIT_LENGTH, label::unit_length);
SAME(CGW_IMAGE_LABEL_NAME_OFFSET, label::name_offset);
SAME(CGW_IMAGE_LABEL_UNIT_OFFSET, label::unit_offset);
SAME(CGW_IMAGE_LABEL_HAS_SCALING, label::has_scaling);
SAME(CGW_IMAGE_LABEL_EXTERNAL_MINIMUM, label::external_minimum);
SAME(CGW_IMAGE_LABEL_EXTERNAL_MAXIMUM, label::external_maximum);
SAME(CGW_IMAGE_LABEL_SIZE, label::size);

SAME(CGW_IMAGE_IDENTITY, SectionId::identity);
SAME(CGW_IMAGE_BUSES, SectionId::buses);
SAME(CGW_IMAGE_GOVERNOR, SectionId::governor);
SAME(CGW_IMAGE_HEARTBEAT, SectionId::heartbeat);
SAME(CGW_IMAGE_PDOS, SectionId::pdos);
SAME(CGW_IMAGE_OBJECTS, SectionId::objects);
SAME(CGW_IMAGE_OBJECT_VALUES, SectionId::object_values);
SAME(CGW_IMAGE_SWITCHES, SectionId::switches);
SAME(CGW_IMAGE_SENSORS, SectionId::sensors);
SAME(CGW_IMAGE_SIGNALS, SectionId::signals);
SAME(CGW_IMAGE_LABELS, SectionId::labels);
SAME(CGW_IMAGE_STRINGS, SectionId::strings);
SAME(CGW_IMAGE_MODEL, SectionId::model);
SAME(CGW_IMAGE_SECTION_IDS, section_ids);

SAME(CGW_IMAGE_OK, Status::ok);
SAME(CGW_IMAGE_TOO_SMALL, Status::too_small);
SAME(CGW_IMAGE_TOO_LARGE, Status::too_large);
SAME(CGW_IMAGE_BAD_MAGIC, Status::bad_magic);
SAME(CGW_IMAGE_UNSUPPORTED_MAJOR, Status::unsupported_major);
SAME(CGW_IMAGE_BAD_HEADER_SIZE, Status::bad_header_size);
SAME(CGW_IMAGE_SIZE_MISMATCH, Status::size_mismatch);
SAME(CGW_IMAGE_BAD_CRC, Status::bad_crc);
SAME(CGW_IMAGE_BAD_DIRECTORY, Status::bad_directory);
SAME(CGW_IMAGE_SECTION_MISSING, Status::section_missing);
SAME(CGW_IMAGE_BAD_SECTION, Status::bad_section);
SAME(CGW_IMAGE_BAD_OBJECT_TABLE, Status::bad_object_table);
SAME(CGW_IMAGE_BAD_MAPPING, Status::bad_mapping);
SAME(CGW_IMAGE_BAD_LABEL, Status::bad_label);

}  // namespace
}  // namespace cgw::image
