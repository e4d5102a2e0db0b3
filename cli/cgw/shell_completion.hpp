// Completion scripts from the table of verbs: verbs, options, values of options, files.
#pragma once

#include <string>

namespace cgw::cli {

std::string bash_completion();
std::string zsh_completion();
std::string fish_completion();

}  // namespace cgw::cli
