// Manual pages from the table of verbs.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "cli/cgw/command.hpp"
#include "cli/cgw/help.hpp"

namespace cgw::cli {

// The text in troff's man macros. `version` stands in the footer; there is no date, so that the same
// sources give the same page.
std::string program_man_page(std::string_view version);
std::string verb_man_page(const Verb& verb, std::string_view version);

// Of a program without verbs: `command` is named as the program, `related` is another program's page.
std::string command_man_page(const Verb& command, std::span<const ExitCodeText> exit_codes,
                             std::string_view related, std::string_view version);

// "cgw-image-verify", the name of a verb's page in section 1.
std::string man_page_name(const Verb& verb);

}  // namespace cgw::cli
