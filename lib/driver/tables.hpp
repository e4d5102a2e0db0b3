// Printed parameter tables of both devices, from their paths to a parameter file's text.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "diagnostic/renderers.hpp"
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

// A parameter file with the values of both tables.
std::string text_of_tables(const ReadTables& tables, const TablePaths& paths, const std::string& title,
                           const parameter::Catalogue& catalogue);

}  // namespace cgw::driver
