#include <fmt/format.h>

#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/frames_input.hpp"
#include "cli/cgw/shared_options.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"
#include "signals/encode.hpp"

namespace cgw::cli {
namespace {

std::vector<Word> encode_format_words() {
    return {{"text", "the frame, and what each byte means"},
            {"cansend", "the frame alone, for cansend"},
            {"json", "one JSON document"}};
}

constexpr Option encode_options[] = {
    parameter_file_option,
    {.names = "PDO", .summary = "TPDO4, RPDO2, 0x301: an active PDO of FILE", .required = true},
    {.names = "VALUE", .summary = "NAME=VALUE; else functions off, the rest 0", .repeats = true},
    {.names = "--format",
     .value = "FORMAT",
     .summary = "form of the output",
     .default_value = "text",
     .words = encode_format_words},
    color_option,
};

constexpr std::string_view encode_details =
    "NAME is the name of a signal, or number or name of the parameter behind it; cgw\n"
    "pdo shows them. VALUE is\n\n"
    "  50%, \"1500 1/min\", 50      in the unit of the signal, refused beyond its range\n"
    "  \"0x1F40 raw\", \"8000 raw\"   the word as it is on the bus\n"
    "  on, off, 0, 1              one bit\n\n"
    "  cansend can0 $(cgw encode FILE RPDO2 Setp1Ext=50% --format cansend)\n\n"
    "Exit code 0; 1 when FILE has errors or a value is wrong, and then no frame is\n"
    "printed; 3 when FILE cannot be read.\n";

int run_encode(const Arguments& arguments) {
    int exit_code = exit_fine;
    const std::optional<FramesInput> input = read_frames(arguments, "FILE", exit_code);
    if (!input) {
        return exit_code;
    }
    diagnostic::Findings findings;
    const signals::Frame* const frame =
        signals::demand_frame(input->frames, arguments.value("PDO"), findings);
    signals::Encoded encoded;
    if (frame != nullptr) {
        encoded = signals::encode(*frame, arguments.values("VALUE"), findings);
    }
    if (frame == nullptr || findings.has_errors()) {
        report_arguments(findings, arguments);
        return exit_findings;
    }
    const std::string format = arguments.value("--format");
    const std::string text = format == "json"      ? signals::render_encoded_json(encoded)
                             : format == "cansend" ? signals::cansend_text(*frame, encoded.data) + "\n"
                                                   : signals::render_encoded_text(encoded);
    return print(text) ? exit_fine : exit_environment;
}

}  // namespace

const Verb encode_verb = {"encode", "make a frame of values in engineering units", encode_options, run_encode,
                          encode_details};

}  // namespace cgw::cli
