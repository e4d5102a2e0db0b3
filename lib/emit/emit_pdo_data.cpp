// The PDO table for programs: JSON, documented in docs/command-line.md, and CSV.

#include <fmt/format.h>
#include <algorithm>

#include "base/columns.hpp"
#include "base/json.hpp"
#include "emit/pdo_rows.hpp"

namespace cgw::emit {
namespace {

using config::WordKind;

constexpr int format_version = 1;

std::string_view to_text(config::Direction direction) {
    return direction == config::Direction::transmit ? "transmit" : "receive";
}

std::string_view to_text(config::CobIdSource source) {
    return source == config::CobIdSource::predefined ? "predefined" : "parameter";
}

// Receive words say what they carry:
//   2003h:1  "switches":[{"bit":1,"parameter":827,"low_active":false}]
//   2003h:2  "sensors":[{"bit":1,"parameter":900}]        bit k is the error flag of channel k
//   2004h:k  "sensors":[{"channel":1,"parameter":900}]    several only where sensors share a channel
// Ascending by bit or channel; bits count from 1, the lowest. A dummy carries neither key.
void carried_json(base::JsonWriter& json, const WordRow& word) {
    if (word.carried.empty()) {
        return;
    }
    json.key(word.kind == WordKind::switches ? "switches" : "sensors").begin_array();
    for (const Carried& carried : word.carried) {
        json.begin_object();
        json.key(word.kind == WordKind::sensor ? "channel" : "bit").integer(carried.position);
        json.key("parameter").integer(carried.row->number);
        if (word.kind == WordKind::switches) {
            json.key("low_active").boolean(carried.low_active);
        }
        json.end_object();
    }
    json.end_array();
}

void word_json(base::JsonWriter& json, const WordRow& word) {
    json.begin_object();
    json.key("index").integer(word.index);
    json.key("sub_index").integer(word.sub_index);
    json.key("bits").integer(config::word_bits);
    json.key("parameter");
    word.parameter ? json.integer(*word.parameter) : json.null();
    json.key("name").string(word.name);
    carried_json(json, word);
    json.end_object();
}

void pdo_json(base::JsonWriter& json, const PdoRow& row) {
    const config::Pdo& pdo = *row.pdo;
    json.begin_object();
    json.key("name").string(row.name);
    json.key("direction").string(to_text(pdo.direction));
    json.key("number").integer(pdo.number);
    json.key("active").boolean(pdo.active);
    json.key("cob_id").integer(pdo.cob_id);
    json.key("cob_id_source").string(to_text(pdo.cob_id_source));
    json.key("length").integer(pdo.length());
    json.key("transmission_type").integer(config::transmission_type);
    json.key("time_ms").integer(pdo.time.asked_ms);
    json.key("effective_time_us").integer(pdo.time.effective_us);
    json.key("mapping").begin_array();
    for (const WordRow& word : row.words) {
        word_json(json, word);
    }
    json.end_array();
    json.end_object();
}

std::string carried_text(const WordRow& word) {
    std::string text;
    for (const Carried& carried : word.carried) {
        text += text.empty() ? "" : "; ";
        text += describe(word.kind, carried);
    }
    return text;
}

struct CsvLine {
    const PdoTable& table;
    const PdoRow& row;
    const WordRow& word;
    const config::Pdo& pdo() const { return *row.pdo; }
};

std::string decimal(unsigned number) {
    return fmt::format("{}", number);
}

constexpr base::Column<CsvLine> csv_columns[] = {
    {"pdo", [](const CsvLine& line) { return line.row.name; }},
    {"direction", [](const CsvLine& line) { return std::string(to_text(line.pdo().direction)); }},
    {"cob_id", [](const CsvLine& line) { return fmt::format("0x{:03X}", line.pdo().cob_id); }},
    {"cob_id_source", [](const CsvLine& line) { return std::string(to_text(line.pdo().cob_id_source)); }},
    {"length", [](const CsvLine& line) { return decimal(line.pdo().length()); }},
    {"transmission_type", [](const CsvLine&) { return decimal(config::transmission_type); }},
    {"time_ms", [](const CsvLine& line) { return decimal(line.pdo().time.asked_ms); }},
    {"effective_time_us", [](const CsvLine& line) { return decimal(line.pdo().time.effective_us); }},
    {"word", [](const CsvLine& line) { return decimal(line.word.position); }},
    {"index", [](const CsvLine& line) { return fmt::format("0x{:04X}", line.word.index); }},
    {"sub_index", [](const CsvLine& line) { return decimal(line.word.sub_index); }},
    {"bits", [](const CsvLine&) { return decimal(config::word_bits); }},
    {"parameter",
     [](const CsvLine& line) { return line.word.parameter ? decimal(*line.word.parameter) : std::string(); }},
    {"name", [](const CsvLine& line) { return line.word.name; }},
    {"carries", [](const CsvLine& line) { return carried_text(line.word); }},
    {"node_id", [](const CsvLine& line) { return decimal(line.table.node_id); }},
    {"configuration_id", [](const CsvLine& line) { return line.table.configuration_id; }},
    {"title", [](const CsvLine& line) { return line.table.title; }},
};

}  // namespace

std::string render_json(const PdoTable& table) {
    base::JsonWriter json;
    json.begin_object();
    json.key("format_version").integer(format_version);
    json.key("node_id").integer(table.node_id);
    json.key("configuration_id").string(table.configuration_id);
    json.key("pdos").begin_array();
    for (const PdoRow& row : table.rows) {
        pdo_json(json, row);
    }
    json.end_array().end_object();
    return json.take();
}

// One line per mapped word, lines end with LF; inactive PDOs have none.
std::string render_csv(const PdoTable& table) {
    constexpr std::span<const base::Column<CsvLine>> columns = csv_columns;
    std::string text = base::csv_heading(columns);
    for (const PdoRow& row : table.rows) {
        for (const WordRow& word : row.words) {
            text += base::csv_line(columns, {table, row, word});
        }
    }
    return text;
}

}  // namespace cgw::emit
