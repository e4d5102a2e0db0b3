// The PDO table for reading: plain text for 80 columns, and Markdown.

#include <fmt/format.h>

#include "base/canopen_text.hpp"
#include "base/text_cells.hpp"
#include "config/numbers.hpp"
#include "emit/pdo_rows.hpp"

namespace cgw::emit {
namespace {

// "16 -> 15.625", "1000" where nothing is rounded, and words where there is no time.
std::string cycle_text(const config::Pdo& pdo) {
    if (pdo.time.asked_ms != 0) {
        const std::string asked = fmt::format("{}", pdo.time.asked_ms);
        const std::string effective = base::milliseconds(pdo.time.effective_us);
        return asked == effective ? asked : fmt::format("{} -> {}", asked, effective);
    }
    if (!pdo.active) {
        return "-";
    }
    return pdo.direction == config::Direction::receive ? "not monitored" : "on change";
}

std::string identifier_text(const config::Pdo& pdo) {
    return pdo.cob_id == 0 ? "-" : base::identifier_text(pdo.cob_id);
}

std::string object_text(const WordRow& word) {
    return word.kind == config::WordKind::dummy ? base::object_text(word.index)
                                                : base::object_text(word.index, word.sub_index);
}

// A data word names its first sensor itself; the others of a shared channel follow below.
std::span<const Carried> listed_below(const WordRow& word) {
    const std::span<const Carried> carried = word.carried;
    return word.kind == config::WordKind::sensor && !carried.empty() ? carried.subspan(1) : carried;
}

std::string heading(const PdoTable& table) {
    return table.title.empty() ? "PDO table" : fmt::format("PDO table: {}", base::one_line(table.title));
}

constexpr std::string_view legend =
    "Times in ms: as set -> as the device runs them; for RPDOs the monitoring time";

void text_row(std::string& text, const PdoRow& row) {
    const config::Pdo& pdo = *row.pdo;
    const std::string bytes = pdo.active ? fmt::format("{}", pdo.length()) : "-";
    std::string head =
        fmt::format("{:<7}{:>6}  {:>5}  {:<18}", row.name, identifier_text(pdo), bytes, cycle_text(pdo));
    if (!pdo.active) {
        text += head + "inactive\n";
        return;
    }
    for (const WordRow& word : row.words) {
        text +=
            fmt::format("{}{} {:<9}{}\n", head, word.position, object_text(word), base::one_line(word.label));
        head.assign(head.size(), ' ');
        for (const Carried& carried : listed_below(word)) {
            text += fmt::format("{}  {}\n", head, base::one_line(describe(word.kind, carried)));
        }
    }
}

void markdown_row(std::string& text, const PdoRow& row) {
    const config::Pdo& pdo = *row.pdo;
    const std::string head = fmt::format("| {} | {} |", row.name, identifier_text(pdo));
    if (!pdo.active) {
        text += fmt::format("{} - | {} | | | inactive |\n", head, cycle_text(pdo));
        return;
    }
    std::string cells = fmt::format("{} {} | {} |", head, pdo.length(), cycle_text(pdo));
    for (const WordRow& word : row.words) {
        std::string contents = base::markdown_cell(word.label);
        for (const Carried& carried : listed_below(word)) {
            contents += "<br>" + base::markdown_cell(describe(word.kind, carried));
        }
        text += fmt::format("{} {} | {} | {} |\n", cells, word.position, object_text(word), contents);
        cells = "| | | | |";
    }
}

}  // namespace

std::string render_text(const PdoTable& table) {
    std::string text = fmt::format("{}\nConfiguration {}, node {}\n\n", heading(table),
                                   table.configuration_id, table.node_id);
    text += fmt::format("{:<7}{:>6}  {:>5}  {:<18}{:<11}{}\n", "PDO", "COB-ID", "Bytes", "Time", "Word",
                        "Contents");
    for (const PdoRow& row : table.rows) {
        text_row(text, row);
    }
    return fmt::format("{}\n{}\n", text, legend);
}

std::string render_markdown(const PdoTable& table) {
    std::string text =
        fmt::format("# {}\n\nConfiguration `{}`, node {}\n\n", base::markdown_cell(heading(table)),
                    table.configuration_id, table.node_id);
    text += "| PDO | COB-ID | Bytes | Time | Word | Object | Contents |\n";
    text += "|---|---:|---:|---|---:|---|---|\n";
    for (const PdoRow& row : table.rows) {
        markdown_row(text, row);
    }
    return fmt::format("{}\n{}\n", text, base::markdown_cell(legend));
}

}  // namespace cgw::emit
