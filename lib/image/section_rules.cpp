// The format as tables: what each section is, and the range of every field in it.
#include "facts/gateway.hpp"
#include "facts/identifiers.hpp"
#include "image/verify.hpp"
#include "wire/little_endian.hpp"

namespace cgw::image {
namespace {

//   id, record size, records, required, ascending, bytes, status
constexpr SectionRule rules[] = {
    {SectionId::identity, identity::size, 1, true, false, false, Status::bad_section},
    {SectionId::buses, bus::size, 2, true, false, false, Status::bad_section},
    {SectionId::governor, governor::size, 1, true, false, false, Status::bad_section},
    {SectionId::heartbeat, heartbeat::size, 1, true, false, false, Status::bad_section},
    {SectionId::pdos, pdo::size, pdo::count, true, false, false, Status::bad_section},
    {SectionId::objects, object::object_record_size, 0, true, false, false, Status::bad_object_table},
    {SectionId::object_values, 1, 0, true, false, true, Status::bad_object_table},
    {SectionId::switches, switch_function::size, 0, true, true, false, Status::bad_section},
    {SectionId::sensors, sensor::size, 0, true, true, false, Status::bad_section},
    {SectionId::signals, signal::size, 0, true, true, false, Status::bad_section},
    {SectionId::labels, label::size, 0, false, true, false, Status::bad_label},
    {SectionId::strings, 1, 0, false, false, true, Status::bad_label},
    {SectionId::model, 1, 0, false, false, true, Status::bad_section},
};
static_assert(std::size(rules) + 1 == section_ids);

// Eight bytes each in firmware, where there are many of them.
struct FieldRule {
    SectionId section : 4;
    std::uint16_t offset : 9;
    std::uint16_t width : 3;  // bytes: 1, 2 or 4
    std::uint16_t minimum;
    std::uint32_t maximum;  // 0: reserved, or fixed at 0 in this minor
};
static_assert(sizeof(FieldRule) == 8);

constexpr std::uint32_t maximum_start_up_delay_ms = 100'000;  // 400: 0..100 s
constexpr std::uint32_t maximum_hzm_node = facts::maximum_hzm_node;
constexpr std::uint32_t maximum_node = facts::maximum_node_id;
constexpr std::uint32_t any_u32 = 0xFFFF'FFFF;

// Register ranges are those of 410..415 / 420..425 (manual 11.2; the governor's likewise, D17).
constexpr FieldRule fields[] = {
    {SectionId::buses, bus::own_node, 1, 1, maximum_node},
    {SectionId::buses, bus::peer_node, 1, 0, maximum_node},
    {SectionId::buses, bus::manual_timing, 1, 0, 1},
    {SectionId::buses, bus::reserved, 1, 0, 0},
    {SectionId::buses, bus::bit_rate_kbit, 2, 0, 1000},
    {SectionId::buses, bus::registers, 1, 0, 63},
    {SectionId::buses, bus::registers + 1, 1, 0, 3},
    {SectionId::buses, bus::registers + 2, 1, 0, 1},
    {SectionId::buses, bus::registers + 3, 1, 0, 7},
    {SectionId::buses, bus::registers + 4, 1, 0, 7},
    {SectionId::buses, bus::registers + 5, 1, 0, 7},
    {SectionId::buses, bus::start_up_delay_ms, 4, 0, maximum_start_up_delay_ms},

    {SectionId::governor, governor::own_node, 1, 1, maximum_hzm_node},
    {SectionId::governor, governor::gateway_node, 1, 1, maximum_hzm_node},
    {SectionId::governor, governor::manual_timing, 1, 0, 1},
    {SectionId::governor, governor::send_errors, 1, 0, 1},
    {SectionId::governor, governor::bit_rate_kbit, 2, 0, 1000},
    {SectionId::governor, governor::registers, 1, 0, 63},
    {SectionId::governor, governor::registers + 1, 1, 0, 3},
    {SectionId::governor, governor::registers + 2, 1, 0, 1},
    {SectionId::governor, governor::registers + 3, 1, 0, 7},
    {SectionId::governor, governor::registers + 4, 1, 0, 7},
    {SectionId::governor, governor::reserved, 1, 0, 0},
    {SectionId::governor, governor::start_up_delay_ms, 4, 0, maximum_start_up_delay_ms},
    {SectionId::governor, governor::main_cycle_us, 4, 1, any_u32},
    {SectionId::governor, governor::send_status, 1, 0, 1},
    {SectionId::governor, governor::reserved_2, 1, 0, 0},
    {SectionId::governor, governor::reserved_2 + 1, 2, 0, 0},

    {SectionId::heartbeat, heartbeat::consumer_node, 1, 0, maximum_node},
    {SectionId::heartbeat, heartbeat::reserved, 1, 0, 0},
    {SectionId::heartbeat, heartbeat::reserved + 1, 2, 0, 0},

    {SectionId::pdos, pdo::active, 1, 0, 1},
    {SectionId::pdos, pdo::cob_id, 2, 0, facts::cob::highest},
    {SectionId::pdos, pdo::word_count, 1, 0, 4},
    {SectionId::pdos, pdo::transmission_type, 1, facts::transmission_type, facts::transmission_type},
    {SectionId::pdos, pdo::cycles, 2, 0, 255},

    {SectionId::objects, object_record::index, 2, 0x1000, 0xFFFF},
    {SectionId::objects, object_record::sub_index, 1, 0, 254},
    {SectionId::objects, object_record::type, 1, 0x01, 0x07},
    {SectionId::objects, object_record::handler, 1, 0, 0},  // none is defined yet

    {SectionId::switches, switch_function::number, 2, 811, 849},
    {SectionId::switches, switch_function::bit, 1, 1, 16},
    {SectionId::switches, switch_function::low_active, 1, 0, 1},

    {SectionId::sensors, sensor::number, 2, 900, 929},
    {SectionId::sensors, sensor::channel, 1, 1, 12},
    {SectionId::sensors, sensor::reserved, 1, 0, 0},

    {SectionId::signals, signal::number, 2, 1, 29'999},
    {SectionId::signals, signal::width, 1, 8, 16},
    {SectionId::signals, signal::is_signed, 1, 0, 1},

    {SectionId::labels, label::number, 2, 0, 29'999},
    {SectionId::labels, label::has_scaling, 1, 0, 1},
    {SectionId::labels, label::reserved, 1, 0, 0},
    {SectionId::labels, label::reserved + 1, 2, 0, 0},
};

std::uint32_t load(const std::uint8_t* from, std::uint8_t width) {
    if (width == 1) {
        return *from;
    }
    return width == 2 ? wire::load_u16(from) : wire::load_u32(from);
}

bool field_holds(const Records& records, const FieldRule& field) {
    for (std::size_t i = 0; i < records.count(); ++i) {
        const std::uint32_t value = load(records.at(i) + field.offset, field.width);
        if (value < field.minimum || value > field.maximum) {
            return false;
        }
    }
    return true;
}

bool numbers_ascend(const Records& records) {
    for (std::size_t i = 1; i < records.count(); ++i) {
        if (wire::load_u16(records.at(i - 1)) >= wire::load_u16(records.at(i))) {
            return false;
        }
    }
    return true;
}

}  // namespace

std::span<const SectionRule> section_rules() {
    return rules;
}

Status check_fields(const Image& image, const SectionRule& rule) {
    const Records& records = image.records(rule.id);
    const bool known = is_known_minor(image);
    for (const FieldRule& field : fields) {
        const bool later_use_allowed = field.maximum == 0 && !known;
        if (field.section == rule.id && !later_use_allowed && !field_holds(records, field)) {
            return rule.status;
        }
    }
    return rule.ascending && !numbers_ascend(records) ? rule.status : Status::ok;
}

}  // namespace cgw::image
