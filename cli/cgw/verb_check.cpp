#include <utility>

#include "cli/cgw/check_report.hpp"
#include "cli/cgw/shared_options.hpp"
#include "cli/cgw/verbs.hpp"
#include "driver/check_file.hpp"

namespace cgw::cli {
namespace {

constexpr Option check_options[] = {
    {.names = "FILE",
     .summary = "parameter files and catalogue files; - is standard input",
     .required = true,
     .repeats = true,
     .completes = Completes::files},
    finding_format_option,
    werror_option,
    warning_option,
    color_option,
};

int run_check(const Arguments& arguments) {
    const std::vector<std::string>& paths = checked_files(arguments);
    CheckReport report(arguments);
    for (const std::string& path : paths) {
        driver::CheckedFile file = driver::check_file_or_catalogue(path);
        report.apply_options(file.findings);
        if (!file.valid()) {
            file.not_verified.clear();
        }
        report.add({path, file.findings.all(), std::move(file.not_verified), file.is_catalogue},
                   file.unreadable, std::move(file.sources));
    }
    return report.print();
}

}  // namespace

const Verb check_verb = {"check", "check parameter files and report every finding", check_options, run_check};

}  // namespace cgw::cli
