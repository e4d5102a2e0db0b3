#include <fmt/format.h>

#include <limits>
#include <thread>
#include <utility>

#include "base/numbers.hpp"
#include "base/path_pattern.hpp"
#include "cli/cgw/check_report.hpp"
#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/shared_options.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"
#include "driver/check_files.hpp"

namespace cgw::cli {
namespace {

constexpr Option check_options[] = {
    {.names = "FILE",
     .summary = "parameter files and catalogue files, patterns like 'plants/**/*.toml'; - is standard input",
     .required = true,
     .repeats = true,
     .completes = Completes::files},
    {.names = "-j,--jobs", .value = "N", .summary = "check N files at the same time (default: one per core)"},
    finding_format_option,
    werror_option,
    warning_option,
    color_option,
};

constexpr std::string_view check_details =
    "In a pattern * stands for any text in a name, ? for one character, [a-c] for\n"
    "one of these, ** for any number of directories. Quote it, or the shell expands\n"
    "it first. Files of a pattern are checked in the order of their names; whatever\n"
    "N is, the output is the same.\n";

constexpr unsigned most_jobs = 256;

unsigned jobs_of(const Arguments& arguments) {
    if (!arguments.given("--jobs")) {
        return std::max(1U, std::thread::hardware_concurrency());
    }
    const std::string text = arguments.value("--jobs");
    const std::optional<std::int64_t> jobs = base::parse_integer(text);
    if (!jobs || *jobs < 1 || *jobs > most_jobs) {
        throw UsageError(fmt::format("-j: '{}' is not a number from 1 to {}", text, most_jobs));
    }
    return static_cast<unsigned>(*jobs);
}

// Patterns become the files that match; nothing to do for a pattern that nothing matches is a failure.
base::Result<std::vector<std::string>> expanded(const std::vector<std::string>& arguments) {
    std::vector<std::string> paths;
    for (const std::string& argument : arguments) {
        if (!base::is_path_pattern(argument)) {
            paths.push_back(argument);
            continue;
        }
        base::Result<std::vector<std::string>> found = base::files_of_pattern(argument);
        if (!found) {
            return found;
        }
        if (found->empty()) {
            return base::failure(fmt::format("no file matches {}", argument));
        }
        paths.insert(paths.end(), found->begin(), found->end());
    }
    return paths;
}

int run_check(const Arguments& arguments) {
    const unsigned jobs = jobs_of(arguments);
    CheckReport report(arguments);
    const base::Result<std::vector<std::string>> paths = expanded(checked_files(arguments));
    if (!paths) {
        print_error(paths.error().message);
        return exit_environment;
    }
    driver::check_files(*paths, jobs, [&report](driver::CheckedFile&& file) {
        report.apply_options(file.findings);
        if (!file.valid()) {
            file.not_verified.clear();
        }
        report.add({file.path, file.findings.all(), std::move(file.not_verified), file.is_catalogue},
                   file.unreadable, std::move(file.sources));
    });
    return report.print();
}

}  // namespace

const Verb check_verb = {"check", "check parameter files and report every finding", check_options, run_check,
                         check_details};

}  // namespace cgw::cli
