#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "base/files.hpp"
#include "base/utf8.hpp"
#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/output_file.hpp"
#include "cli/cgw/shared_options.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"
#include "driver/check_sheet.hpp"

namespace cgw::cli {
namespace {

constexpr Option eds_fix_options[] = {
    {.names = "FILE",
     .summary = "EDS or DCF of any device; - is standard input",
     .required = true,
     .completes = Completes::files},
    {.names = "-o,--output",
     .value = "PATH",
     .summary = "the repaired file; - is standard output",
     .completes = Completes::files},
    {.names = "--in-place", .summary = "change the file itself"},
    {.names = "--check", .summary = "write nothing; exit 1 when there is something to repair"},
    force_option,
    color_option,
};

constexpr std::string_view eds_fix_details =
    "Repairs what can be meant in one way only and does not change the device that\n"
    "the file describes: counts, numbers of lists, spelling, comments, blanks, dates,\n"
    "formulas with $NODEID. Each repair is told on standard error. All other bytes\n"
    "stay as they are. Nothing is repaired where it is not certain what the file\n"
    "says: a section or key that stands there twice, a header without its ].\n";

enum class Mode { write, check };

struct Request {
    Mode mode = Mode::write;
    std::string output;  // of Mode::write
};

Request request_of(const Arguments& arguments) {
    const std::string file = arguments.value("FILE");
    const int given = static_cast<int>(arguments.given("--output")) +
                      static_cast<int>(arguments.given("--in-place")) +
                      static_cast<int>(arguments.given("--check"));
    if (given != 1) {
        throw UsageError("-o PATH, --in-place or --check says what to do, one of them");
    }
    if (arguments.given("--check")) {
        return {Mode::check, ""};
    }
    if (arguments.given("--in-place")) {
        if (file == "-") {
            throw UsageError("--in-place: standard input cannot be changed; -o PATH says where to write");
        }
        return {Mode::write, file};
    }
    std::string output = arguments.value("--output");
    if (output != "-" && file != "-" && base::same_file(output, file)) {
        throw UsageError(fmt::format("-o {}: this is the file itself; --in-place changes it", output));
    }
    refuse_existing_output(arguments, output);
    return {Mode::write, std::move(output)};
}

// FileName is to be the name under which the file is found afterwards.
std::string file_name_of(const Request& request, const std::string& path) {
    const std::string& name = request.mode == Mode::check || request.output == "-" ? path : request.output;
    return name == "-" ? "" : std::filesystem::path(name).filename().string();
}

// `done`: "repaired", "to repair".
void report_repairs(const std::string& path, const eds_check::Fixed& fixed, std::string_view done,
                    bool color) {
    std::string text;
    for (const eds_check::Repaired& repair : fixed.repairs) {
        const diagnostic::Position& at = repair.where.range.start;
        text +=
            fmt::format("{}:{}:{}: {}{}:{} {} [{} {}]\n", path, at.line, at.column, color ? "\x1b[1;32m" : "",
                        done, color ? "\x1b[0m" : "", repair.what, repair.rule->code, repair.rule->name);
    }
    const std::size_t count = fixed.repairs.size();
    text += count == 0 ? fmt::format("{}: nothing to repair\n", path)
                       : fmt::format("{}: {} repair{}\n", path, count, count == 1 ? "" : "s");
    std::fputs(text.c_str(), stderr);
}

int refuse(const std::string& path, const eds_check::Fixed& fixed, const std::string& text, bool color) {
    diagnostic::RenderInput input;
    input.files.push_back({.path = path, .findings = fixed.doubts.all()});
    input.sources[path] = text;
    input.color = color;
    input.verdicts = false;
    report_findings(input);
    print_error(fmt::format("{}: nothing is repaired, for it is not certain what the file says", path));
    return exit_findings;
}

int run_eds_fix(const Arguments& arguments) {
    const std::string path = arguments.value("FILE");
    const Request request = request_of(arguments);
    const bool color = use_color(arguments, stderr);
    base::Result<std::string> text = base::read_file(path, eds::largest_text);
    if (!text) {
        print_error(text.error().message);
        return text.error().too_large ? exit_findings : exit_environment;  // as the verbs that check it
    }
    const eds_check::Fixed fixed = eds_check::fix(*text, path, {.file_name = file_name_of(request, path)});
    if (!fixed.doubts.all().empty()) {
        return refuse(path, fixed, *text, color);
    }
    const std::string shown = base::printable(path);
    if (request.mode == Mode::check) {
        report_repairs(shown, fixed, "to repair", color);
        return fixed.repairs.empty() ? exit_fine : exit_findings;
    }
    const int exit_code = write_text(request.output, fixed.text);
    if (exit_code == exit_fine) {
        report_repairs(shown, fixed, "repaired", color);
    }
    return exit_code;
}

}  // namespace

const Verb eds_fix_verb = {"eds fix", "repair a data sheet where only one thing can be meant",
                           eds_fix_options, run_eds_fix, eds_fix_details};

}  // namespace cgw::cli
