#include "cli/cgw/terminal.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

#include "base/utf8.hpp"
#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/shared_options.hpp"

namespace cgw::cli {

bool print(std::string_view text) {
    const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
    if (written && std::fflush(stdout) == 0) {
        return true;
    }
    print_error(fmt::format("cannot write standard output: {}", std::strerror(errno)));
    return false;
}

void print_error(std::string_view line) {
    std::fputs(fmt::format("cgw: {}\n", base::printable(line)).c_str(), stderr);
}

bool is_terminal(std::FILE* stream) {
    return ::isatty(::fileno(stream)) != 0;
}

bool is_dumb_terminal() {
    const char* terminal = std::getenv("TERM");
    return terminal != nullptr && std::string_view(terminal) == "dumb";
}

std::vector<Word> color_words() {
    return {{"auto", "on a terminal"}, {"always", ""}, {"never", ""}};
}

bool use_color(const Arguments& arguments, std::FILE* stream) {
    const std::string when = arguments.value("--color");
    if (when != "auto") {
        return when == "always";
    }
    const char* no_color = std::getenv("NO_COLOR");
    return (no_color == nullptr || *no_color == '\0') && !is_dumb_terminal() && is_terminal(stream);
}

void report_findings(const driver::CheckedFile& file, bool color) {
    if (file.findings.all().empty()) {
        return;
    }
    diagnostic::RenderInput input;
    input.files.push_back({file.path, file.findings.all()});
    input.sources = file.sources;
    input.color = color;
    report_findings(input);
}

void report_findings(const diagnostic::RenderInput& input) {
    std::fputs(diagnostic::render_human(input).c_str(), stderr);
}

int exit_code_of(const driver::CheckedFile& file) {
    if (file.unreadable) {
        return exit_environment;
    }
    return file.findings.has_errors() ? exit_findings : exit_fine;
}

}  // namespace cgw::cli
