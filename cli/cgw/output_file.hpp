// A text product of a verb: to standard output, or whole into a file that is none of the inputs.
#pragma once

#include <string>
#include <vector>

#include "cli/cgw/command.hpp"

namespace cgw::cli {

inline constexpr Option text_output_option = {.names = "-o,--output",
                                              .value = "PATH",
                                              .summary = "output file; - is standard output",
                                              .default_value = "-",
                                              .completes = Completes::files};

// Why `output` may not be written, as a usage error: it is one of `inputs`.
void refuse_input_as_output(const std::string& output, const std::vector<std::string>& inputs);

inline constexpr Option force_option = {.names = "--force", .summary = "overwrite a file that exists"};

// A usage error when `output` is a file that exists and --force is not given.
void refuse_existing_output(const Arguments& arguments, const std::string& output);

// Exit code: exit_fine or exit_environment, after saying why on stderr.
int write_text(const std::string& output, const std::string& text);

// First line of a parameter file written there: `#:schema` with the path to parameter-file.schema.json, where
// one lies in the file's directory or above, itself or in schemas/; else a hint how to get one.
std::string schema_line(const std::string& output);

// A title for a parameter file: 1 to 200 bytes of UTF-8 without control characters; "" when not given.
std::string title_of(const Arguments& arguments);

inline constexpr Option title_option = {
    .names = "--title", .value = "TITLE", .summary = "title of the written file"};

}  // namespace cgw::cli
