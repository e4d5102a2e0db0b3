#include <fmt/format.h>

#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/frames_input.hpp"
#include "cli/cgw/output_file.hpp"
#include "cli/cgw/shared_options.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"
#include "driver/plant.hpp"
#include "signals/encode.hpp"
#include "signals/layout.hpp"

namespace cgw::cli {
namespace {

constexpr std::string_view table_name = "pdo-table";

std::vector<Word> pdo_format_words() {
    std::vector<Word> words;
    for (const signals::Format& format : signals::layout_formats()) {
        words.push_back({format.name, format.summary});
    }
    words.push_back({"csv", "the table only: comma-separated values"});
    return words;
}

constexpr Option pdo_options[] = {
    parameter_file_option,
    {.names = "PDO", .summary = "these alone: TPDO5, 0x301", .repeats = true},
    {.names = "--layout", .summary = "draw frames: bytes, bits, scaling, example"},
    {.names = "--format",
     .value = "FORMAT",
     .summary = "form of the output",
     .default_value = "text",
     .words = pdo_format_words},
    text_output_option,
    color_option,
};

constexpr std::string_view pdo_details =
    "Without --layout and PDO: the table that cgw emit pdo-table writes, all 20 PDOs\n"
    "with identifiers, times and contents.\n\n"
    "With --layout or PDO: each active frame drawn with its bytes and bits, and for\n"
    "each signal its object, parameter, scaling and a value on its way to the bus and\n"
    "back.\n\n"
    "Exit code 0; 1 when FILE has errors or a PDO is not active, 3 when FILE cannot\n"
    "be read.\n";

// The frames that are asked for, all of them when none is.
std::vector<signals::Frame> chosen(const std::vector<signals::Frame>& frames,
                                   const std::vector<std::string>& names, diagnostic::Findings& findings) {
    if (names.empty()) {
        return frames;
    }
    std::vector<signals::Frame> some;
    for (const std::string& name : names) {
        if (const signals::Frame* const frame = signals::demand_frame(frames, name, findings)) {
            some.push_back(*frame);
        }
    }
    return some;
}

int write_layout(const Arguments& arguments, const FramesInput& input) {
    diagnostic::Findings findings;
    const signals::Sheet sheet{.title = input.file.settings.title,
                               .configuration_id = driver::short_configuration_id(input.file.settings),
                               .node_id = input.file.configuration.node_id,
                               .frames = chosen(input.frames, arguments.values("PDO"), findings)};
    if (findings.has_errors()) {
        report_arguments(findings, arguments);
        return exit_findings;
    }
    for (const signals::Format& format : signals::layout_formats()) {
        if (format.name == arguments.value("--format")) {
            return write_text(arguments.value("--output"), format.render(sheet));
        }
    }
    throw UsageError("--format csv: a layout has no such form; it is for the table");
}

int write_table(const Arguments& arguments, const FramesInput& input) {
    const auto plant = driver::Plant::make(input.file);
    if (!plant) {
        throw UsageError(plant.error().message);
    }
    const emit::Emitter* const emitter = emit::find_emitter(table_name);
    const emit::Options options{.format = arguments.value("--format")};
    const base::Bytes bytes = emitter->emit(plant->view(), options);
    return write_text(arguments.value("--output"), {bytes.begin(), bytes.end()});
}

int run_pdo(const Arguments& arguments) {
    refuse_input_as_output(arguments.value("--output"), {arguments.value("FILE")});
    int exit_code = exit_fine;
    const std::optional<FramesInput> input = read_frames(arguments, "FILE", exit_code);
    if (!input) {
        return exit_code;
    }
    const bool layout = arguments.given("--layout") || !arguments.values("PDO").empty();
    return layout ? write_layout(arguments, *input) : write_table(arguments, *input);
}

}  // namespace

const Verb pdo_verb = {"pdo", "show the PDOs: a table, or each frame drawn and explained", pdo_options,
                       run_pdo, pdo_details};

}  // namespace cgw::cli
