// What the verbs that check files have in common: options, and one report over all files.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "cli/cgw/command.hpp"
#include "diagnostic/renderers.hpp"

namespace cgw::cli {

std::vector<Word> finding_format_words();
std::vector<Word> finding_rule_words();

inline constexpr Option finding_format_option = {.names = "--format",
                                                 .value = "FORMAT",
                                                 .summary = "how findings are printed",
                                                 .default_value = "human",
                                                 .words = finding_format_words};
inline constexpr Option werror_option = {.names = "--werror", .summary = "treat warnings as errors"};
inline constexpr Option warning_option = {
    .names = "-W",
    .value = "NAME",
    .summary = "show (NAME) or hide (no-NAME) a warning or note, by name or code",
    .repeats = true,
    .words = finding_rule_words,
    .only_words = false};

// FILE, in the form of these verbs; a usage error when standard input is among them twice.
const std::vector<std::string>& checked_files(const Arguments& arguments);

// The report of a verb with the options above and color_option.
class CheckReport {
  public:
    explicit CheckReport(const Arguments& arguments);  // throws UsageError for what -W says

    // What the user does not want to see goes away, warnings are promoted when that was said.
    void apply_options(diagnostic::Findings& findings) const;

    // `unreadable`: exit code 3.
    void add(diagnostic::FileReport file, bool unreadable, std::map<std::string, std::string>&& sources);

    int print();  // exit code over all files

  private:
    const Arguments& arguments_;
    std::vector<const diagnostic::Rule*> hidden_;
    diagnostic::RenderInput input_;
    int exit_code_;
};

}  // namespace cgw::cli
