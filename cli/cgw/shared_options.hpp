// Options that several verbs have, each written once.
#pragma once

#include "cli/cgw/command.hpp"

namespace cgw::cli {

std::vector<Word> color_words();

inline constexpr Option parameter_file_option = {.names = "FILE",
                                                 .summary = "parameter file; - is standard input",
                                                 .required = true,
                                                 .completes = Completes::files};

inline constexpr Option color_option = {.names = "--color",
                                        .value = "WHEN",
                                        .summary = "colour findings",
                                        .default_value = "auto",
                                        .words = color_words};

inline constexpr Option check_option = {
    .names = "--check", .summary = "write nothing; exit 1 when an output is missing or stale"};

inline constexpr Option list_outputs_option = {
    .names = "--list-outputs", .summary = "print the paths that would be written, and nothing else"};

inline constexpr Option depfile_option = {.names = "--depfile",
                                          .value = "PATH",
                                          .summary = "also write a dependency file for make and ninja",
                                          .completes = Completes::files};

// Standard output is no place for what `key` writes.
inline void refuse_dash(const Arguments& arguments, std::string_view key) {
    if (arguments.value(key) == "-") {
        throw UsageError(std::string(key) + " -: this needs a path; standard output is not possible here");
    }
}

}  // namespace cgw::cli
