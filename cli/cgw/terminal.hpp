// The two output streams, with their failures and colours.
#pragma once

#include <cstdio>
#include <span>
#include <string_view>

#include "cli/cgw/command.hpp"
#include "driver/check_file.hpp"

namespace cgw::cli {

// Writes and flushes; false after saying on stderr that it could not (full disk, closed pipe).
bool print(std::string_view text);

void print_error(std::string_view line);  // "cgw: line" on stderr

// What --color says: always, never; auto: a terminal, and neither NO_COLOR nor TERM=dumb in the environment.
bool use_color(const Arguments& arguments, std::FILE* stream);

bool is_terminal(std::FILE* stream);
// One that cannot move its cursor: TERM=dumb.
bool is_dumb_terminal();

// Findings of a verb whose product goes elsewhere: for people, on stderr, nothing when there are none.
// `color`: use_color(…, stderr).
void report_findings(const driver::CheckedFile& file, bool color);

// The same for several files; a file without findings is best left out.
void report_findings(const diagnostic::RenderInput& input);

// Exit code of a checked file: exit_fine, exit_findings or exit_environment.
int exit_code_of(const driver::CheckedFile& file);

}  // namespace cgw::cli
