// Parameter tables as manuals and DcDesk 2000 print them: number, parameter, value, unit.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "diagnostic/diagnostic.hpp"
#include "parameter/catalogue.hpp"

namespace cgw::input {

struct PrintedValue {
    const parameter::Row* row = nullptr;
    double value = 0;
    std::string literal;  // the digits as TOML takes them: "1.0", "0x282"
    diagnostic::Location number{};
    diagnostic::Location where{};  // of the value
};

struct PrintedTable {
    std::map<std::uint16_t, PrintedValue> values;  // by number
    std::string title;                             // as cgw's own sheets say it; "": none
    std::optional<std::uint32_t> main_cycle_us;    // of the governor, likewise
};

// Columns are separated by tabs, semicolons, bars or blanks, by commas below a header that is; a header may
// name them in another order, and a column Device keeps the rows of two devices apart. Headers, blank lines,
// comments (#, //) and other text are passed over; what is nearly a row is not. Measurements (D16) and
// rows of parameters that do not concern CANopen are skipped with a note each, known misprints accepted with
// one (D2, D10). Every mistake is reported, at its place in the table; after an error the table is
// incomplete.
PrintedTable read_parameter_table(std::string_view text, const std::string& path, parameter::Device device,
                                  const parameter::Catalogue& catalogue, diagnostic::Findings& findings);

}  // namespace cgw::input
