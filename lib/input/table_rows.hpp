// A printed table's lines sorted into rows and the rest; nothing is looked up yet but names.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostic/diagnostic.hpp"
#include "input/table_cells.hpp"
#include "parameter/catalogue.hpp"

namespace cgw::input {

struct TableRow {
    Cell number;  // digits only, 1..65535
    Cell name;    // may be empty
    Cell value;   // may be empty
    Cell unit;
    bool has_columns = true;  // false: blanks separate, and the name may be more than a name
};

// What a sheet says of the plant besides its rows.
struct SheetFacts {
    std::string title;               // "": none
    std::optional<Cell> main_cycle;  // of the governor, digits as they stand there
};

struct RowsRead {
    SheetFacts facts;

    std::vector<TableRow> rows;       // of this device
    std::size_t of_other_device = 0;  // rows that a column Device gives to the other one
};

// Reports lines that are nearly rows, and dots that stand for rows.
RowsRead read_rows(std::string_view text, const std::string& path, parameter::Device device,
                   const parameter::Catalogue& catalogue, diagnostic::Findings& findings);

}  // namespace cgw::input
