// How `diff` and `image diff` print a comparison.
#pragma once

#include "cli/cgw/command.hpp"
#include "compare/compare.hpp"

namespace cgw::cli {

std::vector<Word> comparison_format_words();

inline constexpr Option comparison_format_option = {.names = "--format",
                                                    .value = "FORMAT",
                                                    .summary = "form of the report",
                                                    .default_value = "text",
                                                    .words = comparison_format_words};

// In the format of --format; returns exit_fine when nothing differs, exit_findings when something does, or
// exit_environment.
int print_comparison(const Arguments& arguments, const compare::Comparison& comparison,
                     const compare::SideName& a, const compare::SideName& b);

}  // namespace cgw::cli
