#include <fmt/format.h>
#include <array>

#include "config/numbers.hpp"
#include "facts/communication.hpp"
#include "profile/gateway_objects.hpp"

namespace cgw::profile {
namespace {

using dictionary::Object;
using dictionary::Value;
using dictionary::Variable;
using object::DataType;

// Most words a PDO can carry: the HighLimit of its mapping's sub 0 in the manual's EDS (D20, D43).
constexpr std::array<std::uint8_t, 16> transmit_words{4, 2, 1, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4};
constexpr std::array<std::uint8_t, 4> receive_words{3, 4, 4, 4};

struct DirectionRow {
    std::string_view prefix;
    std::uint16_t communication_index;  // of PDO 1
    std::uint16_t mapping_index;
    std::span<const std::uint8_t> words;
    std::span<const std::uint16_t> identifier_bases;
};

constexpr DirectionRow receive_row{"RPDO", facts::object::rpdo_communication, facts::object::rpdo_mapping,
                                   receive_words, config::rpdo_identifier_bases};
constexpr DirectionRow transmit_row{"TPDO", facts::object::tpdo_communication, facts::object::tpdo_mapping,
                                    transmit_words, config::tpdo_identifier_bases};

using facts::object::cob_id_sub;
using facts::object::event_timer_sub;

constexpr std::array communication_variables{
    VariableRow{0, number_of_entries, DataType::unsigned8, event_timer_sub},
    VariableRow{cob_id_sub, "COB-ID", DataType::unsigned32},
    VariableRow{2, "Transmission Type", DataType::unsigned8, config::transmission_type},
    VariableRow{3, "Inhibit Time", DataType::unsigned16},
    VariableRow{4, "Compatibility Entry", DataType::unsigned8},
    VariableRow{event_timer_sub, "Event Timer", DataType::unsigned16},
};

// D30: predefined identifiers follow the node number, those of TPDO5..16 are absolute.
Value cob_id(const DirectionRow& row, const config::Pdo& pdo) {
    const bool relative = pdo.cob_id_source == config::CobIdSource::predefined;
    const std::uint32_t identifier = relative ? row.identifier_bases[pdo.number - 1U] : pdo.cob_id;
    return {identifier | (pdo.active ? 0U : facts::pdo_not_valid), relative};
}

// D31: floored; 0 for what is inactive, not monitored or sent on change.
Value event_timer(const config::Pdo& pdo) {
    return {pdo.active ? pdo.time.effective_ms() : 0, false};
}

Object communication_object(const DirectionRow& row, const config::Pdo& pdo) {
    const std::string name = fmt::format("{}{} Communication Parameter", row.prefix, pdo.number);
    Object object = object_of({static_cast<std::uint16_t>(row.communication_index + pdo.number - 1), name,
                               object::ObjectCode::record, communication_variables});
    object.variables[cob_id_sub].default_value = cob_id(row, pdo);
    object.variables[event_timer_sub].default_value = event_timer(pdo);
    return object;
}

std::uint32_t mapping_entry(const config::MappedWord& word) {
    return std::uint32_t{word.index} << 16U | std::uint32_t{word.sub_index} << 8U | config::word_bits;
}

// D43: all subs exist whether used or not; sub 0 counts the used ones.
Object mapping_object(const DirectionRow& row, const config::Pdo& pdo) {
    Object object;
    object.index = static_cast<std::uint16_t>(row.mapping_index + pdo.number - 1);
    object.name = fmt::format("{}{} Mapping Parameter", row.prefix, pdo.number);
    object.code = object::ObjectCode::record;
    const std::uint8_t words = row.words[pdo.number - 1U];
    object.variables.push_back(entry_count(number_of_entries, pdo.mapping.size(), {0, words}));
    for (std::uint8_t sub = 1; sub <= words; ++sub) {
        Variable& entry = object.variables.emplace_back();
        entry.sub_index = sub;
        entry.name = fmt::format("Mapped Object {}", sub);
        entry.type = DataType::unsigned32;
        entry.default_value.number = sub <= pdo.mapping.size() ? mapping_entry(pdo.mapping[sub - 1U]) : 0;
    }
    return object;
}

}  // namespace

std::vector<Object> pdo_objects(const config::Configuration& configuration, config::Direction direction) {
    const DirectionRow& row = direction == config::Direction::receive ? receive_row : transmit_row;
    std::vector<Object> objects;
    for (const config::Pdo& pdo : configuration.pdos) {
        if (pdo.direction == direction) {
            objects.push_back(communication_object(row, pdo));
        }
    }
    for (const config::Pdo& pdo : configuration.pdos) {
        if (pdo.direction == direction) {
            objects.push_back(mapping_object(row, pdo));
        }
    }
    return objects;
}

}  // namespace cgw::profile
