#include <fmt/format.h>

#include <set>

#include "cli/cgw/comparison_format.hpp"
#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/shared_options.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"
#include "compare/compare.hpp"
#include "driver/check_file.hpp"
#include "driver/plant.hpp"
#include "driver/tables.hpp"

namespace cgw::cli {
namespace {

constexpr Option diff_options[] = {
    {.names = "A",
     .summary = "parameter file; - is standard input",
     .required = true,
     .completes = Completes::files},
    {.names = "B",
     .summary = "parameter file to compare with; not with tables",
     .completes = Completes::files},
    {.names = "--governor",
     .value = "PATH",
     .summary = "instead of B: table of the governor as found",
     .completes = Completes::files},
    {.names = "--gateway",
     .value = "PATH",
     .summary = "instead of B: table of the gateway as found",
     .completes = Completes::files},
    comparison_format_option,
    color_option,
};

constexpr std::string_view diff_details =
    "Exit code 0 when nothing differs, 1 when something does or when a file has\n"
    "errors, 3 when one cannot be read. Parameters that tables do not print are taken\n"
    "as in A; their numbers are named, and they differ where A has another value than\n"
    "0.\n";

// Exit code; findings of a file with errors go to stderr.
int report_invalid(const driver::CheckedFile& file, bool color) {
    if (file.valid()) {
        return exit_fine;
    }
    report_findings(file, color);
    return exit_code_of(file);
}

compare::SideName name_of(const driver::CheckedFile& file) {
    return {{file.path}, driver::short_configuration_id(file.settings)};
}

// A file with errors of reading does not say what it means; one whose plant would fail can be compared.
int refuse_incomplete(const driver::CheckedFile& file, int exit_code) {
    print_error(fmt::format("{} cannot be compared before its errors are mended", file.path));
    return exit_code;
}

int diff_files(const Arguments& arguments, const driver::CheckedFile& a, int exit_code, bool color) {
    const driver::CheckedFile b = driver::check_file(arguments.value("B"));
    exit_code = worse(exit_code, report_invalid(b, color));
    for (const driver::CheckedFile* file : {&a, &b}) {
        if (!file->complete) {
            return file->unreadable ? exit_code : refuse_incomplete(*file, exit_code);
        }
    }
    const compare::Comparison comparison = compare::compare({a.settings, a.configuration, *a.catalogue},
                                                            {b.settings, b.configuration, *b.catalogue});
    return worse(exit_code, print_comparison(arguments, comparison, name_of(a), name_of(b)));
}

std::vector<compare::NumberRange> not_printed(const driver::ReadTables& tables,
                                              const parameter::Catalogue& catalogue) {
    std::vector<compare::NumberRange> all;
    for (const parameter::Device device : {parameter::Device::governor, parameter::Device::gateway}) {
        std::set<std::uint16_t> printed;
        const bool governor = device == parameter::Device::governor;
        for (const auto& [number, value] : (governor ? tables.governor : tables.gateway).values) {
            printed.insert(number);
        }
        const auto ranges = compare::ranges_not_printed(catalogue, device, printed);
        all.insert(all.end(), ranges.begin(), ranges.end());
    }
    return all;
}

int diff_tables(const Arguments& arguments, const driver::CheckedFile& a, int exit_code, bool color) {
    const driver::TablePaths paths{arguments.value("--governor"), arguments.value("--gateway")};
    const driver::ReadTables tables = driver::read_tables(paths, *a.catalogue);
    if (!tables.valid()) {
        report_findings({tables.reports, tables.sources, color, {}});
        return worse(exit_code, tables.unreadable ? exit_environment : exit_findings);
    }
    if (!a.complete) {
        return a.unreadable ? exit_code : refuse_incomplete(a, exit_code);
    }
    driver::TableSide b = driver::side_of_tables(a, tables);
    compare::Comparison comparison = compare::compare({a.settings, a.configuration, *a.catalogue},
                                                      {b.settings, b.configuration, *a.catalogue});
    comparison.not_in_table = std::move(b.absent);
    comparison.not_printed = not_printed(tables, *a.catalogue);
    std::vector<std::string> names = {paths.governor};
    if (paths.gateway != paths.governor) {
        names.push_back(paths.gateway);
    }
    return worse(exit_code, print_comparison(arguments, comparison, name_of(a), {std::move(names), ""}));
}

int run_diff(const Arguments& arguments) {
    const bool with_tables = arguments.given("--governor") || arguments.given("--gateway");
    const bool both_tables = arguments.given("--governor") && arguments.given("--gateway");
    if (with_tables == arguments.given("B") || with_tables != both_tables) {
        throw UsageError("compare A with a file B, or with both tables: --governor PATH --gateway PATH");
    }
    int inputs_from_stdin = 0;
    for (const std::string_view key : {"A", "B", "--governor", "--gateway"}) {
        inputs_from_stdin += arguments.value(key) == "-" ? 1 : 0;
    }
    if (inputs_from_stdin > 1) {
        throw UsageError("standard input (-) can be read only once");
    }
    const bool color = use_color(arguments, stderr);
    const driver::CheckedFile a = driver::check_file(arguments.value("A"));
    const int exit_code = report_invalid(a, color);
    return with_tables ? diff_tables(arguments, a, exit_code, color)
                       : diff_files(arguments, a, exit_code, color);
}

}  // namespace

const Verb diff_verb = {"diff", "compare two parameter files, or a file with tables as found", diff_options,
                        run_diff, diff_details};

}  // namespace cgw::cli
