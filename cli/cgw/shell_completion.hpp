// Completion scripts from the table of verbs: verbs, options, values of options, files.
#pragma once

#include <string>

#include "cli/cgw/command.hpp"

namespace cgw::cli {

std::string bash_completion();
std::string zsh_completion();
std::string fish_completion();

// The same for a program without verbs, which `command` is named as; its table has no arguments without
// dashes.
std::string bash_completion(const Verb& command);
std::string zsh_completion(const Verb& command);
std::string fish_completion(const Verb& command);

}  // namespace cgw::cli
