// The frames of a parameter file, for the verbs that show, make and read frames.
#pragma once

#include <optional>
#include <vector>

#include "cli/cgw/command.hpp"
#include "driver/check_file.hpp"
#include "signals/frames.hpp"

namespace cgw::cli {

struct FramesInput {
    driver::CheckedFile file;
    std::vector<signals::Frame> frames;
};

// nullopt after reporting the findings of a file that has errors; `exit_code` then says which.
std::optional<FramesInput> read_frames(const Arguments& arguments, std::string_view key, int& exit_code);

// Findings about arguments of the command line, on stderr.
void report_arguments(const diagnostic::Findings& findings, const Arguments& arguments);

}  // namespace cgw::cli
