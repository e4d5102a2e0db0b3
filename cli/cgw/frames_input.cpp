#include "cli/cgw/frames_input.hpp"

#include <map>

#include "cli/cgw/terminal.hpp"

namespace cgw::cli {

std::optional<FramesInput> read_frames(const Arguments& arguments, std::string_view key, int& exit_code) {
    FramesInput input{driver::check_file(arguments.value(key)), {}};
    if (!input.file.valid()) {
        report_findings(input.file, use_color(arguments, stderr));
        exit_code = exit_code_of(input.file);
        return std::nullopt;
    }
    input.frames = signals::frames_of(input.file.settings, *input.file.catalogue, input.file.configuration);
    return input;
}

void report_arguments(const diagnostic::Findings& findings, const Arguments& arguments) {
    std::vector<diagnostic::FileReport> reports;
    for (const diagnostic::Diagnostic& finding : findings.all()) {
        reports.push_back({finding.where.path, {finding}});
    }
    report_findings({.files = std::move(reports),
                     .sources = {},
                     .color = use_color(arguments, stderr),
                     .verdicts = false});
}

}  // namespace cgw::cli
