#include <fmt/format.h>

#include <cstdio>

#include "authoring/from_data_sheet.hpp"
#include "base/utf8.hpp"
#include "cli/cgw/description_input.hpp"
#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/output_file.hpp"
#include "cli/cgw/shared_options.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"
#include "driver/import_data_sheet.hpp"

namespace cgw::cli {
namespace {

constexpr Option import_eds_options[] = {
    {.names = "FILE",
     .summary = "EDS, DCF, XDD or XDC of a gateway; - is standard input",
     .required = true,
     .completes = Completes::files},
    node_id_option,
    {.names = "--rest-from",
     .value = "PLANT",
     .summary = "parameter file that says what FILE cannot",
     .completes = Completes::files},
    text_output_option,
    title_option,
    force_option,
    color_option,
};

constexpr std::string_view import_eds_details =
    "Writes as much of a parameter file as the data sheet determines: identifiers,\n"
    "times, words and channels of PDOs, heartbeat, identity; of a DCF also node\n"
    "number and bit rate. What it does not say is told on standard error and in the\n"
    "first lines of the file. Then the gateway that the file configures is compared\n"
    "with the data sheet, object by object; each difference is something that no\n"
    "gateway can do, or that the data sheet does not determine. Exit code 0 when the\n"
    "file is valid, 1 when something is still missing or differs.\n"
    "With --rest-from everything that FILE cannot say comes from PLANT, a valid\n"
    "parameter file: nodes and bit rate of CAN1, switches, parameters of the\n"
    "governor. Where both say something and differ, FILE counts, and it is told.\n";

// What became of it, on stderr.
void report(const std::string& path, const driver::ImportedDataSheet& imported) {
    const std::string name = base::printable(path);
    std::string text;
    for (const std::string& each : imported.undetermined) {
        text += fmt::format("{}: does not say: {}\n", name, each);
    }
    for (const std::string& each : imported.contradictions) {
        text += base::printable(fmt::format("{}: contradicts --rest-from: {}", path, each)) + "\n";
    }
    for (const dictionary::Difference& each : imported.differences.all) {
        text += base::printable(fmt::format("{}: differs: {} {}: {} -> {}", path, subject_text(each),
                                            each.aspect_text, each.a, each.b)) +
                "\n";
    }
    std::fputs(text.c_str(), stderr);
}

int run_import_eds(const Arguments& arguments) {
    const std::string path = arguments.value("FILE");
    const std::string output = arguments.value("--output");
    const std::string rest = arguments.value("--rest-from");
    driver::ImportOptions options{title_of(arguments), node_id_of(arguments), schema_line(output)};
    refuse_input_as_output(output, rest.empty() ? std::vector{path} : std::vector{path, rest});
    refuse_existing_output(arguments, output);
    std::optional<driver::CheckedFile> plant;
    if (arguments.given("--rest-from")) {
        if (path == "-" && rest == "-") {
            throw UsageError("standard input (-) can be read only once");
        }
        options.plant = &plant.emplace(driver::check_file(rest));
        if (!plant->valid()) {
            report_findings(*plant, use_color(arguments, stderr));
            return exit_code_of(*plant);
        }
    }
    int exit_code = exit_fine;
    const driver::DeviceDescription sheet = load_description(arguments, path, exit_code);
    if (!sheet.valid()) {
        return exit_code;
    }
    if (!is_of_any_device(sheet.kind) || !authoring::describes_gateway(sheet.dictionary)) {
        print_error(fmt::format("{}: not the EDS, DCF, XDD or XDC of a CANopen Gateway (1018h)", path));
        return exit_findings;
    }
    const std::string name = output == "-" ? "<stdout>" : output;
    const driver::ImportedDataSheet imported = driver::import_data_sheet(sheet, name, options);
    if (const int written = write_text(output, imported.text); written != exit_fine) {
        return written;
    }
    report(path, imported);
    report_findings(imported.file, use_color(arguments, stderr));
    if (!imported.file.valid()) {
        print_error(fmt::format("{} says what the data sheet says; add what is missing", name));
    }
    return worse(exit_code_of(imported.file), imported.differences.same() ? exit_fine : exit_findings);
}

}  // namespace

const Verb import_eds_verb = {"import eds", "write a parameter file from the data sheet of a gateway",
                              import_eds_options, run_import_eds, import_eds_details};

}  // namespace cgw::cli
