#include <fmt/format.h>

#include "catalogue/catalogue.hpp"
#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/output_file.hpp"
#include "cli/cgw/shared_options.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"
#include "driver/check_file.hpp"
#include "driver/tables.hpp"

namespace cgw::cli {
namespace {

constexpr Option import_table_options[] = {
    {.names = "--governor",
     .value = "PATH",
     .summary = "table of the governor; - is standard input",
     .required = true,
     .completes = Completes::files},
    {.names = "--gateway",
     .value = "PATH",
     .summary = "table of the gateway; may be the same file if it has a column Device",
     .required = true,
     .completes = Completes::files},
    text_output_option,
    title_option,
    force_option,
    color_option,
};

constexpr std::string_view import_table_details =
    "Reads parameter tables as the manuals and DcDesk 2000 print them: Number,\n"
    "Parameter, Value, Unit, separated by tabs, semicolons, bars or blanks, or by\n"
    "commas below a header that is. Nothing is written unless both tables can be\n"
    "read without doubt. The written file is then checked: a plant that is wrong as\n"
    "found is written, with its findings on standard error and exit code 1.\n";

int run_import_table(const Arguments& arguments) {
    const driver::TablePaths paths{arguments.value("--governor"), arguments.value("--gateway")};
    const std::string output = arguments.value("--output");
    const std::string title = title_of(arguments);
    if (paths.governor == "-" && paths.gateway == "-") {
        throw UsageError("standard input (-) can be read only once");
    }
    refuse_input_as_output(output, {paths.governor, paths.gateway});
    refuse_existing_output(arguments, output);
    const parameter::Catalogue catalogue(catalogue::shipped_rows());
    driver::ReadTables tables = driver::read_tables(paths, catalogue);
    if (tables.valid()) {
        driver::note_absent_rows(tables, paths, catalogue);
    }
    const bool color = use_color(arguments, stderr);
    report_findings({tables.reports, tables.sources, color, {}});
    if (!tables.valid()) {
        return tables.unreadable ? exit_environment : exit_findings;
    }
    const std::string text = schema_line(output) + driver::text_of_tables(tables, paths, title, catalogue);
    if (const int written = write_text(output, text); written != exit_fine) {
        return written;
    }
    const driver::CheckedFile file = driver::check_text(output == "-" ? "<stdout>" : output, text);
    report_findings(file, color);
    if (!file.valid()) {
        print_error(fmt::format("{} says what the tables say, and is not valid as it stands", file.path));
    }
    return exit_code_of(file);
}

}  // namespace

const Verb import_table_verb = {"import table", "write a parameter file from printed parameter tables",
                                import_table_options, run_import_table, import_table_details};

}  // namespace cgw::cli
