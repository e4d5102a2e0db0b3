// Inside the emit room: the PDO table before it takes a form. Every format renders these rows.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "config/configuration.hpp"
#include "emit/emitter.hpp"
#include "parameter/row.hpp"

namespace cgw::emit {

// A switch function or sensor behind a receive word.
struct Carried {
    const parameter::Row* row = nullptr;  // 8nn or 9nn
    std::uint8_t position = 0;            // bit 1..16 (1 is the lowest), or channel 1..12
    bool low_active = false;              // switch functions
};

struct WordRow {
    std::uint8_t position = 0;  // 1..4
    config::WordKind kind = config::WordKind::dummy;
    std::uint16_t index = 0;
    std::uint8_t sub_index = 0;
    std::optional<std::uint16_t> parameter;  // measurement or sensor
    std::string name;                        // of the parameter, else of the object; "dummy"
    std::string label;                       // number and name: "2000 Speed"
    std::vector<Carried> carried;            // ascending position; receive words that are no dummies
};

struct PdoRow {
    std::string name;  // "TPDO4"
    const config::Pdo* pdo = nullptr;
    std::vector<WordRow> words;  // empty when inactive
};

struct PdoTable {
    std::string title;
    std::string configuration_id;
    std::uint8_t node_id = 0;
    std::vector<PdoRow> rows;  // TPDO1..16, RPDO1..4
};

// Refers to the plant, which must outlive it.
PdoTable pdo_table(const Plant& plant);

// "bit 5 low-active: 835 FunctLoadEnable"; a sensor of a data word is just "900 AssignIn_Setp1Ext".
std::string describe(config::WordKind kind, const Carried& carried);

std::string render_text(const PdoTable& table);
std::string render_markdown(const PdoTable& table);
std::string render_csv(const PdoTable& table);
std::string render_json(const PdoTable& table);

}  // namespace cgw::emit
