// Images with a right CRC-32 and one wrong field in a section.
#include <gtest/gtest.h>

#include "support/image_bytes.hpp"
#include "support/sample_plant.hpp"

namespace cgw::test {
namespace {

using image::SectionId;
using image::Status;
namespace directory = image::directory;

const base::Bytes& good() {
    static const base::Bytes bytes = SamplePlant().image();
    return bytes;
}

// One wrong field: `record` of `section` at `offset`.
struct WrongField {
    const char* what;
    SectionId section;
    std::size_t record;
    std::size_t offset;
    std::size_t width;
    std::uint64_t value;
    Status status;
};

std::size_t record_size(SectionId id) {
    return wire::load_u16(&good()[entry_of(id) + directory::record_size]);
}

void expect_refused(const WrongField& field) {
    const std::size_t at =
        offset_of(good(), field.section) + field.record * record_size(field.section) + field.offset;
    EXPECT_EQ(open(changed(good(), at, field.width, field.value)), field.status) << field.what;
}

namespace bus = image::bus;
namespace pdo = image::pdo;
constexpr Status section = Status::bad_section;

const WrongField device_fields[] = {
    {"gateway node of CAN1 is not the governor's 403", SectionId::buses, 0, bus::own_node, 1, 8, section},
    {"CAN1 node 0", SectionId::buses, 0, bus::own_node, 1, 0, section},
    {"CAN1 node 32", SectionId::buses, 0, bus::own_node, 1, 32, section},
    {"governor node is not the governor's 401", SectionId::buses, 0, bus::peer_node, 1, 4, section},
    {"manual timing 2", SectionId::buses, 0, bus::manual_timing, 1, 2, section},
    {"reserved byte of a bus", SectionId::buses, 1, bus::reserved, 1, 1, section},
    {"300 kbit/s", SectionId::buses, 0, bus::bit_rate_kbit, 2, 300, section},
    {"no bit rate", SectionId::buses, 0, bus::bit_rate_kbit, 2, 0, section},
    {"bit rate differs from the governor's", SectionId::buses, 0, bus::bit_rate_kbit, 2, 500, section},
    {"CAN2 at 100 kbit/s", SectionId::buses, 1, bus::bit_rate_kbit, 2, 100, section},
    {"prescaler 64", SectionId::buses, 1, bus::registers, 1, 64, section},
    {"synchronising jump width 4", SectionId::buses, 1, bus::registers + 1, 1, 4, section},
    {"sampling mode 2", SectionId::buses, 1, bus::registers + 2, 1, 2, section},
    {"phase segment 1 of 8", SectionId::buses, 1, bus::registers + 3, 1, 8, section},
    {"phase segment 2 of 8", SectionId::buses, 1, bus::registers + 4, 1, 8, section},
    {"propagation segment 8", SectionId::buses, 1, bus::registers + 5, 1, 8, section},
    {"start-up delay over 100 s", SectionId::buses, 0, bus::start_up_delay_ms, 4, 100'001, section},
    {"start-up delay on CAN2", SectionId::buses, 1, bus::start_up_delay_ms, 4, 1, section},
    {"node id 0", SectionId::buses, 1, bus::own_node, 1, 0, section},
    {"node id 128", SectionId::buses, 1, bus::own_node, 1, 128, section},
    {"node id that the predefined identifiers do not have", SectionId::buses, 1, bus::own_node, 1, 6,
     section},
    {"partner is the node itself", SectionId::buses, 1, bus::peer_node, 1, 5, section},
    {"partner differs from the heartbeat's", SectionId::buses, 1, bus::peer_node, 1, 126, section},
    {"governor node 0", SectionId::governor, 0, image::governor::own_node, 1, 0, section},
    {"send errors without TPDO1", SectionId::governor, 0, image::governor::send_errors, 1, 0, section},
    {"send status without TPDO3", SectionId::governor, 0, image::governor::send_status, 1, 1, section},
    {"governor's reserved byte", SectionId::governor, 0, image::governor::reserved, 1, 1, section},
    {"governor's reserved bytes", SectionId::governor, 0, image::governor::reserved_2 + 2, 1, 1, section},
    {"main cycle 0", SectionId::governor, 0, image::governor::main_cycle_us, 4, 0, section},
    {"main cycle that the times do not have", SectionId::governor, 0, image::governor::main_cycle_us, 4,
     16000, section},
    {"main cycle that overflows", SectionId::governor, 0, image::governor::main_cycle_us, 4, 0xFFFFFFFF,
     section},
    {"heartbeat of no whole cycles", SectionId::heartbeat, 0, image::heartbeat::producer_us, 4, 16001,
     section},
    {"heartbeat of 4096 cycles", SectionId::heartbeat, 0, image::heartbeat::producer_us, 4, 65'536'000,
     section},
    {"monitoring of no whole cycles", SectionId::heartbeat, 0, image::heartbeat::consumer_us, 4, 1, section},
    {"monitoring of another node", SectionId::heartbeat, 0, image::heartbeat::consumer_node, 1, 4, section},
    {"heartbeat's reserved byte", SectionId::heartbeat, 0, image::heartbeat::reserved, 1, 1, section},
};

TEST(ImageDevices, are_refused_with_a_value_no_configuration_can_have) {
    for (const WrongField& field : device_fields) {
        expect_refused(field);
    }
}

const WrongField pdo_fields[] = {
    {"direction", SectionId::pdos, 0, pdo::direction, 1, 1, section},
    {"number", SectionId::pdos, 1, pdo::number, 1, 1, section},
    {"active without words", SectionId::pdos, 6, pdo::active, 1, 1, section},
    {"words although inactive", SectionId::pdos, 3, pdo::active, 1, 0, section},
    {"active 2", SectionId::pdos, 3, pdo::active, 1, 2, section},
    {"predefined identifier from a parameter", SectionId::pdos, 0, pdo::cob_id_source, 1, 1, section},
    {"TPDO5 predefined", SectionId::pdos, 4, pdo::cob_id_source, 1, 0, section},
    {"predefined identifier of another node", SectionId::pdos, 0, pdo::cob_id, 2, 0x186, section},
    {"29-bit identifier", SectionId::pdos, 4, pdo::cob_id, 2, 0x800, section},
    {"identifier of an active TPDO not set", SectionId::pdos, 4, pdo::cob_id, 2, 0, section},
    {"identifier SYNC", SectionId::pdos, 4, pdo::cob_id, 2, 0x080, section},
    {"identifier TIME", SectionId::pdos, 4, pdo::cob_id, 2, 0x100, section},
    {"identifier of our SDO answer", SectionId::pdos, 4, pdo::cob_id, 2, 0x585, section},
    {"identifier of our SDO request", SectionId::pdos, 4, pdo::cob_id, 2, 0x605, section},
    {"identifier of our heartbeat", SectionId::pdos, 4, pdo::cob_id, 2, 0x705, section},
    {"identifier of the partner's heartbeat", SectionId::pdos, 4, pdo::cob_id, 2, 0x77F, section},
    {"identifier of another TPDO", SectionId::pdos, 4, pdo::cob_id, 2, 0x185, section},
    {"identifier of an RPDO", SectionId::pdos, 4, pdo::cob_id, 2, 0x205, section},
    {"five words", SectionId::pdos, 3, pdo::word_count, 1, 5, section},
    {"transmission type 255", SectionId::pdos, 3, pdo::transmission_type, 1, 255, section},
    {"effective time", SectionId::pdos, 3, pdo::effective_us, 4, 15626, section},
    {"effective time of TPDO1", SectionId::pdos, 0, pdo::effective_us, 4, 15625, section},
    {"asked time", SectionId::pdos, 3, pdo::asked_ms, 2, 32, section},
    {"cycles", SectionId::pdos, 3, pdo::cycles, 2, 2, section},
    {"more than 255 cycles", SectionId::pdos, 5, pdo::cycles, 2, 256, section},
    {"word without a signal", SectionId::pdos, 3, pdo::parameters, 2, 2001, section},
    {"measurement without parameter", SectionId::pdos, 3, pdo::parameters, 2, 0, section},
    {"parameter behind an error word", SectionId::pdos, 0, pdo::parameters, 2, 2000, section},
    {"fewer words than mapped", SectionId::pdos, 3, pdo::word_count, 1, 3, Status::bad_mapping},
    {"more words than mapped", SectionId::pdos, 4, pdo::word_count, 1, 2, Status::bad_mapping},
    {"object missing", SectionId::pdos, 3, pdo::mapping, 4, 0x20060110, Status::bad_mapping},
    {"sub-index missing", SectionId::pdos, 3, pdo::mapping, 4, 0x20010910, Status::bad_mapping},
    {"8 bits", SectionId::pdos, 3, pdo::mapping, 4, 0x20010108, Status::bad_mapping},
    {"16 bits of a 32-bit object", SectionId::pdos, 3, pdo::mapping, 4, 0x18000110, Status::bad_mapping},
    {"object that is not mappable", SectionId::pdos, 3, pdo::mapping, 4, 0x20050010, Status::bad_mapping},
    {"dummy in a TPDO", SectionId::pdos, 3, pdo::mapping, 4, 0x00060010, Status::bad_mapping},
    {"input in a TPDO", SectionId::pdos, 3, pdo::mapping, 4, 0x20030110, Status::bad_mapping},
    {"output in an RPDO", SectionId::pdos, 16, pdo::mapping, 4, 0x20010110, Status::bad_mapping},
    {"dummy with a sub-index", SectionId::pdos, 16, pdo::mapping + 4, 4, 0x00060110, Status::bad_mapping},
    {"dummy with a parameter", SectionId::pdos, 16, pdo::parameters + 2, 2, 900, Status::bad_mapping},
    {"dummy of another type", SectionId::pdos, 16, pdo::mapping + 4, 4, 0x00050010, Status::bad_mapping},
    {"parameter behind an unused word", SectionId::pdos, 4, pdo::parameters + 2, 2, 2000,
     Status::bad_mapping},
    {"no word for the switches", SectionId::pdos, 16, pdo::mapping, 4, 0x00060010, section},
    {"no word for a sensor", SectionId::pdos, 17, pdo::mapping, 4, 0x20040210, section},
};

TEST(ImagePdos, are_refused_when_a_field_does_not_fit) {
    for (const WrongField& field : pdo_fields) {
        expect_refused(field);
    }
}

const WrongField object_fields[] = {
    {"index below 1000h", SectionId::objects, 0, 0, 2, 0x0FFF, Status::bad_object_table},
    {"index out of order", SectionId::objects, 0, 0, 2, 0x1002, Status::bad_object_table},
    {"object twice", SectionId::objects, 1, 0, 2, 0x1000, Status::bad_object_table},
    {"sub-index 255", SectionId::objects, 0, 2, 1, 255, Status::bad_object_table},
    {"data type 0", SectionId::objects, 0, 3, 1, 0, Status::bad_object_table},
    {"data type REAL32", SectionId::objects, 0, 3, 1, 8, Status::bad_object_table},
    {"data type of another length", SectionId::objects, 0, 3, 1, 6, Status::bad_object_table},
    {"access 6", SectionId::objects, 0, 4, 1, 6, Status::bad_object_table},
    {"access 6 of a mappable object", SectionId::objects, 0, 4, 1, 0x16, Status::bad_object_table},
    {"unknown flag", SectionId::objects, 0, 4, 1, 0x40, Status::bad_object_table},
    {"value outside the block", SectionId::objects, 0, 6, 2, 0xFFFC, Status::bad_object_table},
    {"value over another one", SectionId::objects, 0, 6, 2, 4, Status::bad_object_table},
    {"handler", SectionId::objects, 0, 5, 1, 1, Status::bad_object_table},
};

TEST(ImageObjects, are_refused_when_the_table_is_not_consistent) {
    for (const WrongField& field : object_fields) {
        expect_refused(field);
    }
}

const WrongField input_fields[] = {
    {"switch 810 (engine stop)", SectionId::switches, 0, 0, 2, 810, section},
    {"switch twice", SectionId::switches, 0, 0, 2, 835, section},
    {"bit 0", SectionId::switches, 0, image::switch_function::bit, 1, 0, section},
    {"bit 17", SectionId::switches, 0, image::switch_function::bit, 1, 17, section},
    {"low-active 2", SectionId::switches, 0, image::switch_function::low_active, 1, 2, section},
    {"sensor 930", SectionId::sensors, 1, 0, 2, 930, section},
    {"sensors out of order", SectionId::sensors, 0, 0, 2, 907, section},
    {"sensor without signal", SectionId::sensors, 0, 0, 2, 901, section},
    {"channel 0", SectionId::sensors, 0, image::sensor::channel, 1, 0, section},
    {"channel 13", SectionId::sensors, 0, image::sensor::channel, 1, 13, section},
    {"channel of an inactive RPDO", SectionId::sensors, 0, image::sensor::channel, 1, 12, section},
    {"sensor's reserved byte", SectionId::sensors, 0, image::sensor::reserved, 1, 1, section},
    {"signal 0", SectionId::signals, 0, 0, 2, 0, section},
    {"signals out of order", SectionId::signals, 0, 0, 2, 906, section},
    {"width 12", SectionId::signals, 0, image::signal::width, 1, 12, section},
    {"sign 2", SectionId::signals, 0, image::signal::is_signed, 1, 2, section},
    {"limits of an unsigned signal read with sign", SectionId::signals, 0, image::signal::is_signed, 1, 1,
     section},
    {"maximum beyond the width", SectionId::signals, 0, image::signal::width, 1, 8, section},
    {"minimum is the maximum", SectionId::signals, 0, image::signal::internal_minimum, 2, 65535, section},
};

TEST(ImageInputs, are_refused_when_they_cannot_be_carried) {
    for (const WrongField& field : input_fields) {
        expect_refused(field);
    }
}

constexpr std::uint64_t infinity = 0x7FF0000000000000;
constexpr std::uint64_t not_a_number = 0x7FF8000000000000;

// Labels of the sample, in order: 0 title, 811, 900, 906, 2000 (scaled), 2201, 2300, 2905.
const WrongField label_fields[] = {
    {"labels out of order", SectionId::labels, 1, 0, 2, 900, Status::bad_label},
    {"name beyond the strings", SectionId::labels, 1, image::label::name_offset, 4, 0xFFFF,
     Status::bad_label},
    {"name offset that overflows", SectionId::labels, 1, image::label::name_offset, 4, 0xFFFFFFFF,
     Status::bad_label},
    {"name longer than the strings", SectionId::labels, 7, image::label::name_length, 1, 255,
     Status::bad_label},
    {"unit beyond the strings", SectionId::labels, 1, image::label::unit_offset, 4, 0x10000,
     Status::bad_label},
    {"title cut inside a character", SectionId::labels, 0, image::label::name_length, 1, 22,
     Status::bad_label},
    {"title begins inside a character", SectionId::labels, 0, image::label::name_offset, 4, 22,
     Status::bad_label},
    {"scaling 2", SectionId::labels, 4, image::label::has_scaling, 1, 2, Status::bad_label},
    {"limits without scaling", SectionId::labels, 4, image::label::has_scaling, 1, 0, Status::bad_label},
    {"scaling of something without a signal", SectionId::labels, 1, image::label::has_scaling, 1, 1,
     Status::bad_label},
    {"infinite minimum", SectionId::labels, 4, image::label::external_minimum, 8, infinity,
     Status::bad_label},
    {"maximum not a number", SectionId::labels, 4, image::label::external_maximum, 8, not_a_number,
     Status::bad_label},
    {"no range at all", SectionId::labels, 4, image::label::external_maximum, 8, 0, Status::bad_label},
    {"label's reserved byte", SectionId::labels, 4, image::label::reserved + 2, 1, 1, Status::bad_label},
    {"line feed in the title", SectionId::strings, 0, 1, 1, '\n', Status::bad_label},
    {"delete character", SectionId::strings, 0, 1, 1, 0x7F, Status::bad_label},
    {"continuation byte alone", SectionId::strings, 0, 1, 1, 0x80, Status::bad_label},
    {"overlong form", SectionId::strings, 0, 0, 2, 0x80C0, Status::bad_label},
    {"surrogate", SectionId::strings, 0, 0, 3, 0x80A0ED, Status::bad_label},
    {"C1 control character", SectionId::strings, 0, 0, 2, 0x85C2, Status::bad_label},
    {"beyond U+10FFFF", SectionId::strings, 0, 0, 4, 0x808090F4, Status::bad_label},
    {"byte FFh", SectionId::strings, 0, 0, 1, 0xFF, Status::bad_label},
};

TEST(ImageLabels, are_refused_when_they_are_not_safe_to_show) {
    for (const WrongField& field : label_fields) {
        expect_refused(field);
    }
}

TEST(ImageLabels, may_hold_any_printable_character) {
    const std::size_t strings = offset_of(good(), SectionId::strings);
    EXPECT_EQ(open(changed(good(), strings, 3, 0xAC82E2)), Status::ok);    // euro sign
    EXPECT_EQ(open(changed(good(), strings, 4, 0x9A9A9FF0)), Status::ok);  // U+1F69A
}

}  // namespace
}  // namespace cgw::test
