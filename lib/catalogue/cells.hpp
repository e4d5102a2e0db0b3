// The cells of a catalogue row: one table row each, with how it is read, shown and merged.
#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostic/diagnostic.hpp"
#include "parameter/row.hpp"
#include "toml/document.hpp"

namespace cgw::catalogue {

// Reports findings of one file.
class Reporter {
  public:
    Reporter(std::string_view path, diagnostic::Findings& findings) : path_(path), findings_(findings) {}

    void operator()(const diagnostic::Rule& rule, const diagnostic::Range& where, std::string message,
                    std::string help = {}) const;
    diagnostic::Location at(const diagnostic::Range& where) const { return {std::string(path_), where}; }
    diagnostic::Findings& findings() const { return findings_; }

  private:
    std::string_view path_;
    diagnostic::Findings& findings_;
};

// A row as one table says it. The row's texts and lists refer to the table and to this draft.
struct Draft {
    explicit Draft(const toml::Node& said) : table(said) {}
    Draft(const Draft&) = delete;
    Draft& operator=(const Draft&) = delete;

    bool says(std::string_view cell) const { return table.find(cell) != nullptr; }
    // A cell that is there and has a finding: it counts as given, but its value takes part in nothing.
    bool refuses(std::string_view cell) const;
    // Where to point at for a cell: its value, or the table's header when it is not there.
    const diagnostic::Range& where(std::string_view cell) const;

    const toml::Node& table;
    parameter::Row row;
    std::vector<std::string_view> aliases;
    std::vector<std::string_view> misprints;
    std::vector<std::uint32_t> choices;
    std::vector<std::uint32_t> pages;
    std::vector<parameter::NamedBit> bits;
    std::vector<parameter::NamedValue> values;
    std::deque<std::string> texts;          // of the bits
    std::vector<std::string_view> refused;  // cells
    std::uint16_t count = 0;                // array elements; 0: no array
    std::uint16_t last = 0;                 // of a range of rows; 0: one row
    bool kind_known = false;                // `kind` was there and fits the number
};

struct Cell {
    std::string_view name;
    toml::Kind type;  // real: an integer as well
    bool in_declaration;
    bool of_measurement;  // makes sense for measurements only
    void (*read)(const toml::Node& value, Draft& draft, const Reporter& report);
    // How the cell of a finished row compares and merges; null for cells that shape the row as a whole.
    bool (*blank)(const parameter::Row& row);
    std::string (*shown)(const parameter::Row& row);
    void (*copy)(const parameter::Row& from, parameter::Row& to);
};

// In the order in which they are read: `number` first, since `kind` depends on it.
std::span<const Cell> all_cells();

inline constexpr std::int64_t highest_number = 29999;

}  // namespace cgw::catalogue
