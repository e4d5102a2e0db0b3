// Words for what was found.
#include <fmt/format.h>

#include "base/canopen_text.hpp"
#include "facts/communication.hpp"
#include "facts/gateway.hpp"
#include "live/report.hpp"

namespace cgw::live {
namespace {

namespace objects = facts::object;

std::string cob_id_meaning(std::uint32_t value) {
    return (value & facts::pdo_not_valid) != 0 ? "not active"
                                               : base::identifier_text(value & facts::cob::highest);
}

std::string mapping_meaning(std::uint32_t value) {
    const std::uint32_t index = value >> 16U;
    if (value == 0) {
        return "nothing";
    }
    return index == objects::unsigned16_dummy ? "dummy" : base::object_text(index, (value >> 8U) & 0xFFU);
}

std::string partner_meaning(std::uint32_t value) {
    return value == 0 ? "nobody" : fmt::format("node {}, {} ms", value >> 16U, value & 0xFFFFU);
}

std::string identifier_meaning(std::uint32_t value) {
    return base::identifier_text(value);
}

std::string milliseconds_meaning(std::uint32_t value) {
    return value == 0 ? "off" : fmt::format("{} ms", value);
}

struct MeaningRow {
    std::uint16_t first, last;  // index
    std::uint8_t first_sub, last_sub;
    std::string (*text)(std::uint32_t value);
};

constexpr std::uint16_t last_of(std::uint16_t first, unsigned count) {
    return static_cast<std::uint16_t>(first + count - 1);
}

constexpr MeaningRow meanings[] = {
    {objects::consumer_heartbeat, objects::consumer_heartbeat, 1, 1, partner_meaning},
    {objects::producer_heartbeat, objects::producer_heartbeat, 0, 0, milliseconds_meaning},
    {objects::sdo_server, objects::sdo_server, 1, 2, identifier_meaning},
    {objects::rpdo_communication, last_of(objects::rpdo_communication, facts::rpdo_count),
     objects::cob_id_sub, objects::cob_id_sub, cob_id_meaning},
    {objects::rpdo_communication, last_of(objects::rpdo_communication, facts::rpdo_count),
     objects::event_timer_sub, objects::event_timer_sub, milliseconds_meaning},
    {objects::rpdo_mapping, last_of(objects::rpdo_mapping, facts::rpdo_count), 1, 4, mapping_meaning},
    {objects::tpdo_communication, last_of(objects::tpdo_communication, facts::tpdo_count),
     objects::cob_id_sub, objects::cob_id_sub, cob_id_meaning},
    {objects::tpdo_communication, last_of(objects::tpdo_communication, facts::tpdo_count),
     objects::event_timer_sub, objects::event_timer_sub, milliseconds_meaning},
    {objects::tpdo_mapping, last_of(objects::tpdo_mapping, facts::tpdo_count), 1, 4, mapping_meaning},
};

constexpr std::string_view kinds[] = {"value",    "length",  "missing", "unexpected",
                                      "writable", "refused", "silent",  "garbled"};
constexpr std::string_view endings[] = {"",       "complete",   "other-device",
                                        "silent", "unsendable", "interrupted"};

std::string bytes_text(unsigned count) {
    return fmt::format("{} byte{}", count, count == 1 ? "" : "s");
}

std::string code_text(object::AbortCode code) {
    return fmt::format("0x{:08X}", static_cast<std::uint32_t>(code));
}

object::AbortCode expected_refusal(Question::Kind kind) {
    switch (kind) {
        case Question::Kind::not_writable:
            return object::AbortCode::read_only;
        case Question::Kind::no_sub_index:
            return object::AbortCode::sub_index_missing;
        case Question::Kind::no_object:
            return object::AbortCode::object_missing;
        case Question::Kind::value:
        case Question::Kind::type:
            break;
    }
    return object::AbortCode::none;
}

std::string refused_text(const Question& question, const Difference& difference) {
    const object::AbortCode expected = expected_refusal(question.kind);
    return expected == object::AbortCode::none
               ? fmt::format("reading is refused with {}", code_text(difference.abort))
               : fmt::format("{} is refused with {} instead of {}",
                             question.kind == Question::Kind::not_writable ? "writing" : "reading",
                             code_text(difference.abort), code_text(expected));
}

}  // namespace

std::string_view to_text(DifferenceKind kind) {
    return kinds[static_cast<std::size_t>(kind)];
}

std::string_view to_text(Ending ending) {
    return endings[static_cast<std::size_t>(ending)];
}

std::string meaning_of(const Question& question, std::uint32_t value) {
    for (const MeaningRow& row : meanings) {
        if (question.index >= row.first && question.index <= row.last &&
            question.sub_index >= row.first_sub && question.sub_index <= row.last_sub) {
            return row.text(value);
        }
    }
    return {};
}

std::string value_text(std::uint32_t value, std::uint8_t length) {
    return fmt::format("0x{:0{}X}", value, 2 * length);
}

std::string sentence_of(const Question& question, const Difference& difference) {
    switch (difference.kind) {
        case DifferenceKind::value:
            return {};
        case DifferenceKind::length:
            return fmt::format("the device gives {}, its type has {}", bytes_text(difference.length),
                               bytes_text(question.length));
        case DifferenceKind::missing:
            return fmt::format("the device does not have it ({})", code_text(difference.abort));
        case DifferenceKind::unexpected:
            return fmt::format("the device has it, with {}; it should not",
                               value_text(difference.value.value_or(0), difference.length));
        case DifferenceKind::writable:
            return "the device accepted a write, which it should refuse";
        case DifferenceKind::refused:
            return refused_text(question, difference);
        case DifferenceKind::silent:
            return "the device does not answer, though it answers others";
        case DifferenceKind::garbled:
            return "the answer is none to the question, or no value of 1 to 4 bytes";
    }
    return {};
}

}  // namespace cgw::live
