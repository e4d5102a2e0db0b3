#include "catalogue/catalogue.hpp"
#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/output_file.hpp"
#include "cli/cgw/shared_options.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"
#include "driver/outputs.hpp"
#include "schema/parameter_file.hpp"

namespace cgw::cli {
namespace {

constexpr Option schema_options[] = {
    text_output_option,
    check_option,
};

int run_schema(const Arguments& arguments) {
    const std::string output = arguments.value("--output");
    if (output == "-" && arguments.given("--check")) {
        throw UsageError("--check needs an output file: -o PATH");
    }
    const parameter::Catalogue catalogue(catalogue::shipped_rows());
    const std::string text = schema::parameter_file_schema(catalogue);
    if (!arguments.given("--check")) {
        return write_text(output, text);
    }
    if (driver::up_to_date(output, base::to_bytes(text))) {
        return exit_fine;
    }
    print_error(output + " is missing or stale; run cgw schema -o " + output);
    return exit_findings;
}

}  // namespace

const Verb schema_verb = {"schema", "print the JSON Schema of parameter files, for editors", schema_options,
                          run_schema,
                          "Name the schema in the first line of a parameter file, and an editor that\n"
                          "checks TOML completes keys, shows what each parameter means, and marks\n"
                          "mistakes while you type:\n"
                          "  #:schema parameter-file.schema.json\n"
                          "docs/editor.md shows how to set up editors. The schema never refuses what cgw\n"
                          "accepts; cgw check finds more."};

}  // namespace cgw::cli
