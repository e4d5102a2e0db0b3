#include <vector>

#include "config/configuration.hpp"
#include "config/numbers.hpp"
#include "config/parts.hpp"
#include "config/reading.hpp"

namespace cgw::config {

namespace {

constexpr std::int32_t highest_parameter_number = 65535;

// What is typed into the four words of one TPDO.
struct TypedWord {
    std::uint16_t setting = 0;  // 16400..16451
    std::uint8_t position = 0;  // 1..4
    std::uint16_t number = 0;   // the parameter to be sent, 0: none
    const parameter::Row* row = nullptr;

    [[nodiscard]] bool sent() const { return transmittable(row); }
};

// D20: which words of 2000h the binary TPDOs carry.
struct BinaryPdo {
    int number;
    std::uint8_t first_sub;
    std::uint8_t last_sub;
    WordKind kind;
    bool Configuration::*active;
};

constexpr BinaryPdo binary_pdos[] = {
    {1, 1, 4, WordKind::errors, &Configuration::send_errors},
    {2, 5, 6, WordKind::errors, &Configuration::send_errors},
    {3, object::engine_state_sub, object::engine_state_sub, WordKind::engine_state,
     &Configuration::send_status},
};

Pdo& tpdo(Configuration& configuration, int number) {
    return configuration.pdos[static_cast<std::size_t>(number - 1)];
}

void set_identifier(const parameter::Settings& settings, Configuration& configuration, Pdo& pdo) {
    if (pdo.number <= tpdo_identifier_bases.size()) {
        pdo.cob_id = predefined_identifier(tpdo_identifier_bases[pdo.number - 1U], configuration.node_id);
        return;
    }
    pdo.cob_id_source = CobIdSource::parameter;
    pdo.cob_id = setting<std::uint16_t>(settings.gateway, gateway::tpdo_identifier_of(pdo.number),
                                        facts::cob::highest);
}

void resolve_binary(const BinaryPdo& binary, Configuration& configuration) {
    Pdo& pdo = tpdo(configuration, binary.number);
    pdo.active = configuration.*binary.active;
    for (std::uint8_t sub = binary.first_sub; pdo.active && sub <= binary.last_sub; ++sub) {
        pdo.mapping.push_back({.kind = binary.kind, .index = object::errors, .sub_index = sub});
    }
}

std::vector<TypedWord> typed_words(const parameter::Settings& settings, const parameter::Catalogue& catalogue,
                                   int tpdo_number) {
    std::vector<TypedWord> words;
    for (std::uint8_t word = 1; word <= words_per_pdo; ++word) {
        const std::uint16_t number = governor::tpdo_assignment_of(tpdo_number, word);
        const auto typed = setting<std::uint16_t>(settings.governor, number, highest_parameter_number);
        words.push_back({.setting = number,
                         .position = word,
                         .number = typed,
                         .row = typed == 0 ? nullptr : catalogue.find(parameter::Device::governor, typed)});
    }
    return words;
}

// A 0 is a decision only where a later word is sent; after the last one it is just the end.
void note_closing_up(const std::vector<TypedWord>& words, const Pdo& pdo, Configuration& configuration) {
    std::uint8_t last_sent = 0;
    for (const TypedWord& word : words) {
        last_sent = word.sent() ? word.position : last_sent;
    }
    std::uint8_t position = 0;
    for (const TypedWord& word : words) {
        const bool dropped = !word.sent() && (word.number != 0 || word.position < last_sent);
        position = static_cast<std::uint8_t>(position + (word.sent() ? 1 : 0));
        const bool moved = word.sent() && position != word.position;
        if (dropped || moved) {
            configuration.decisions.push_back({.kind = moved ? DecisionKind::moved : DecisionKind::dropped,
                                               .device = parameter::Device::governor,
                                               .parameter = word.setting,
                                               .pdo = pdo.number,
                                               .asked_word = word.position,
                                               .actual_word = moved ? position : std::uint8_t{0}});
        }
    }
}

// D24: one running number for each of 2001h and 2002h over the active TPDOs.
struct OutputCounters {
    std::uint8_t unsigned_outputs = 0;
    std::uint8_t signed_outputs = 0;
};

void map_analogue_word(const parameter::Row& row, Pdo& pdo, OutputCounters& counters,
                       Configuration& configuration) {
    const std::uint16_t index = row.is_signed ? object::signed_outputs : object::unsigned_outputs;
    std::uint8_t& counter = row.is_signed ? counters.signed_outputs : counters.unsigned_outputs;
    ++counter;
    pdo.mapping.push_back(
        {.kind = WordKind::measurement, .index = index, .sub_index = counter, .parameter = &row});
    configuration.analogue_outputs.push_back({.parameter = &row,
                                              .index = index,
                                              .sub_index = counter,
                                              .tpdo = pdo.number,
                                              .word = static_cast<std::uint8_t>(pdo.mapping.size())});
}

void resolve_analogue(const parameter::Settings& settings, const parameter::Catalogue& catalogue, Pdo& pdo,
                      OutputCounters& counters, Configuration& configuration) {
    pdo.time = resolve_time(settings, parameter::Device::governor, governor::tpdo_cycle_of(pdo.number),
                            configuration.main_cycle_us, pdo.number, configuration);
    if (pdo.time.asked_ms == 0) {
        return;
    }
    const std::vector<TypedWord> words = typed_words(settings, catalogue, pdo.number);
    for (const TypedWord& word : words) {
        if (word.sent()) {
            map_analogue_word(*word.row, pdo, counters, configuration);
        }
    }
    pdo.active = !pdo.mapping.empty();
    if (pdo.active) {
        note_closing_up(words, pdo, configuration);
    }
}

}  // namespace

const parameter::Row& scaling_row(const parameter::Row& row, const parameter::Catalogue& catalogue) {
    const parameter::Row* const measurement =
        facts::is_sensor(row.number) && !row.scaling
            ? catalogue.find(parameter::Device::governor, facts::measurement_of(row.number))
            : nullptr;
    return measurement != nullptr ? *measurement : row;
}

bool transmittable(const parameter::Row* row) {
    return row != nullptr && (row->width == 8 || row->width == 16);
}

void resolve_transmit_pdos(const parameter::Settings& settings, const parameter::Catalogue& catalogue,
                           Configuration& configuration) {
    configuration.send_errors = switched_on(settings.governor, governor::send_errors);
    configuration.send_status = switched_on(settings.governor, governor::send_status);
    for (int number = 1; number <= tpdo_count; ++number) {
        Pdo& pdo = tpdo(configuration, number);
        pdo.direction = Direction::transmit;
        pdo.number = static_cast<std::uint8_t>(number);
        set_identifier(settings, configuration, pdo);
    }
    for (const BinaryPdo& binary : binary_pdos) {
        resolve_binary(binary, configuration);
    }
    OutputCounters counters;
    for (int number = first_analogue_tpdo; number <= tpdo_count; ++number) {
        resolve_analogue(settings, catalogue, tpdo(configuration, number), counters, configuration);
    }
}

}  // namespace cgw::config
