// Printed parameter tables of both devices, from their paths to a parameter file's text.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "compare/compare.hpp"
#include "diagnostic/renderers.hpp"
#include "driver/check_file.hpp"
#include "input/parameter_table.hpp"

namespace cgw::driver {

struct TablePaths {
    std::string governor;  // both may be the same file; "-" is standard input, for one of them
    std::string gateway;
};

struct ReadTables {
    input::PrintedTable governor;
    input::PrintedTable gateway;
    std::vector<diagnostic::FileReport> reports;  // of the tables that have findings
    std::map<std::string, std::string> sources;
    bool unreadable = false;  // one could not be read at all: exit code 3
    bool has_errors = false;

    bool valid() const { return !unreadable && !has_errors; }
};

ReadTables read_tables(const TablePaths& paths, const parameter::Catalogue& catalogue);

// The plant of a parameter file with the tables' values in it. What the tables do not print stays as in the
// file; `absent` is what of that is not 0.
struct TableSide {
    parameter::Settings settings;
    config::Configuration configuration;
    std::vector<compare::ParameterDifference> absent;
};

// The file must outlive the result.
TableSide side_of_tables(const CheckedFile& file, const ReadTables& tables);

// The numbers that concern CANopen and that the table of `device` does not print, so that the file leaves
// them 0: "4416, 16400..16451"; "" when there are none. Parameters that cannot be 0 are not among them: cgw
// check misses those.
std::string absent_numbers(const ReadTables& tables, parameter::Device device,
                           const parameter::Catalogue& catalogue);

// Adds a note (E0509) to the report of each table that leaves out such numbers.
void note_absent_rows(ReadTables& tables, const TablePaths& paths, const parameter::Catalogue& catalogue);

// A parameter file with the values of both tables, and with the title (unless `title` is another) and the
// main cycle that sheets of cgw carry; where two sheets differ in these, the governor's counts.
std::string text_of_tables(const ReadTables& tables, const TablePaths& paths, const std::string& title,
                           const parameter::Catalogue& catalogue);

}  // namespace cgw::driver
