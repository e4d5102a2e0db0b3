// The PDO table for programs: JSON, documented in docs/command-line.md, and CSV.

#include <fmt/format.h>
#include <algorithm>

#include "base/json.hpp"
#include "emit/pdo_rows.hpp"
#include "emit/text_cells.hpp"

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

void csv_line(std::string& text, const PdoTable& table, const PdoRow& row, const WordRow& word) {
    const config::Pdo& pdo = *row.pdo;
    text += fmt::format("{},{},0x{:03X},{},{},{},{},{},", row.name, to_text(pdo.direction), pdo.cob_id,
                        to_text(pdo.cob_id_source), pdo.length(), config::transmission_type,
                        pdo.time.asked_ms, pdo.time.effective_us);
    text += fmt::format("{},0x{:04X},{},{},{},{},{},", word.position, word.index, word.sub_index,
                        config::word_bits, word.parameter ? fmt::format("{}", *word.parameter) : "",
                        csv_field(word.name), csv_field(carried_text(word)));
    text += fmt::format("{},{},{}\n", table.node_id, table.configuration_id, csv_field(table.title));
}

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
    std::string text =
        "pdo,direction,cob_id,cob_id_source,length,transmission_type,time_ms,effective_time_us,word,index,"
        "sub_index,"
        "bits,parameter,name,carries,node_id,configuration_id,title\n";
    for (const PdoRow& row : table.rows) {
        for (const WordRow& word : row.words) {
            csv_line(text, table, row, word);
        }
    }
    return text;
}

}  // namespace cgw::emit
