// The texts of --help, at most 80 columns.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "cli/cgw/command.hpp"

namespace cgw::cli {

// Of the program (""), a group of verbs ("image") or a verb ("image verify").
std::string help_text(std::string_view name);

// "cgw emit NAME FILE [-o PATH] [--check]", in one line. `blank` stands between an option and its value.
std::string synopsis(const Verb& verb, char blank = ' ');
// The same behind "cgw emit", or behind the name of a program without verbs.
std::string synopsis(std::string_view call, const Verb& verb, char blank = ' ');

// "-o PATH, --output PATH"; "FILE…" for a positional that repeats.
std::string option_heading(const Option& option);

// Summary with the default and the values, as help and man page print it.
std::string option_text(const Option& option);

struct ExitCodeText {
    int code;
    std::string_view meaning;
};
std::span<const ExitCodeText> exit_code_texts();

}  // namespace cgw::cli
