#include <fmt/format.h>

#include <utility>

#include "cli/cgw/check_report.hpp"
#include "cli/cgw/description_input.hpp"
#include "cli/cgw/shared_options.hpp"
#include "cli/cgw/verbs.hpp"
#include "driver/check_sheet.hpp"

namespace cgw::cli {
namespace {

constexpr Option eds_check_options[] = {
    {.names = "FILE",
     .summary = "EDS and DCF of any device; - is standard input",
     .required = true,
     .repeats = true,
     .completes = Completes::files},
    node_id_option,
    {.names = "--strict", .summary = "what strict importers refuse is an error"},
    finding_format_option,
    werror_option,
    warning_option,
    color_option,
};

constexpr std::string_view eds_check_details =
    "Checks electronic data sheets and configuration files of any CANopen device by\n"
    "CiA 306 and CiA 301. Identifiers that follow the node number are checked for\n"
    "--node-id, else for the node of a configuration file, else for every node. The\n"
    "file name is compared with FileName, but for standard input.\n";

std::string hint_of(const driver::DataSheet& file) {
    const std::size_t count = driver::count_repairs(file);
    return count == 0 ? ""
                      : fmt::format("cgw eds fix can make {} safe repair{}", count, count == 1 ? "" : "s");
}

int run_eds_check(const Arguments& arguments) {
    const std::vector<std::string>& paths = checked_files(arguments);
    const eds_check::Options options{.node_id = node_id_of(arguments), .strict = arguments.given("--strict")};
    CheckReport report(arguments);
    for (const std::string& path : paths) {
        driver::DataSheet file = driver::check_data_sheet(path, options);
        std::string hint = arguments.value("--format") == "human" ? hint_of(file) : "";
        report.apply_options(file.findings);
        report.add({.path = path, .findings = file.findings.all(), .hint = std::move(hint)}, file.unreadable,
                   std::move(file.sources));
    }
    return report.print();
}

}  // namespace

const Verb eds_check_verb = {"eds check", "check data sheets and configuration files of any device",
                             eds_check_options, run_eds_check, eds_check_details};

}  // namespace cgw::cli
