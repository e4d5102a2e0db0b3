#include <fmt/format.h>

#include "authoring/clone.hpp"
#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/output_file.hpp"
#include "cli/cgw/shared_options.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"
#include "driver/check_file.hpp"
#include "explain/query.hpp"
#include "facts/identifiers.hpp"

namespace cgw::cli {
namespace {

constexpr Option clone_options[] = {
    parameter_file_option,
    {.names = "--node-id", .value = "N", .summary = "CANopen node id of the copy, 1..127", .required = true},
    title_option,
    {.names = "--keep-identifiers",
     .summary = "keep the identifiers of TPDO5..16: the copy is for another CANopen network"},
    {.names = "--identifiers-from",
     .value = "ID",
     .summary = "give active TPDOs whose identifier is not base + node id new ones from here, 0x680..0x6DF"},
    text_output_option,
    force_option,
    color_option,
};

constexpr std::string_view clone_details =
    "Copies a parameter file for a sister gateway: 427, the title, and identifiers of\n"
    "TPDO5 to 16 that are base + node id. Comments, order and spelling stay. Refused\n"
    "when both gateways would send under one identifier, and when the copy is not\n"
    "valid. Bit rates, the partner and [network] stay as they are: look them through.\n";

std::uint32_t number_of(const Arguments& arguments, std::string_view option) {
    const std::string text = arguments.value(option);
    const auto number = explain::parse_number(text);
    if (!number) {
        throw UsageError(fmt::format("{} {}: a number is written 17, 0x11 or 11h", option, text));
    }
    return *number;
}

std::uint8_t node_id_of(const Arguments& arguments) {
    const std::uint32_t number = number_of(arguments, "--node-id");
    if (number < 1 || number > facts::maximum_node_id) {
        throw UsageError(fmt::format("--node-id {}: a node id is a number from 1 to {}",
                                     arguments.value("--node-id"), facts::maximum_node_id));
    }
    return static_cast<std::uint8_t>(number);
}

std::uint16_t first_identifier_of(const Arguments& arguments) {
    const std::uint32_t number = number_of(arguments, "--identifiers-from");
    if (!facts::is_free_identifier(number)) {
        throw UsageError(fmt::format("--identifiers-from {}: CiA 301 leaves 0x{:X} to 0x{:X} free",
                                     arguments.value("--identifiers-from"), facts::first_free_identifier,
                                     facts::last_free_identifier));
    }
    if (arguments.given("--keep-identifiers")) {
        throw UsageError(
            "--identifiers-from gives new identifiers, --keep-identifiers keeps them: one of both");
    }
    return static_cast<std::uint16_t>(number);
}

authoring::CloneRequest request_of(const Arguments& arguments) {
    authoring::CloneRequest request;
    request.node_id = node_id_of(arguments);
    request.keep_identifiers = arguments.given("--keep-identifiers");
    if (arguments.given("--title")) {
        request.title = title_of(arguments);
    }
    if (arguments.given("--identifiers-from")) {
        request.identifiers_from = first_identifier_of(arguments);
    }
    return request;
}

int run_clone(const Arguments& arguments) {
    const authoring::CloneRequest request = request_of(arguments);
    const std::string path = arguments.value("FILE");
    const std::string output = arguments.value("--output");
    const bool color = use_color(arguments, stderr);
    driver::CheckedFile original = driver::check_file(path);
    refuse_input_as_output(output, original.dependencies);
    refuse_existing_output(arguments, output);
    if (!original.valid()) {
        report_findings(original, color);
        return exit_code_of(original);
    }
    if (request.node_id == original.configuration.node_id && !request.keep_identifiers) {
        throw UsageError(
            fmt::format("--node-id {}: that is the original's; only a copy for another network "
                        "(--keep-identifiers) may have it",
                        request.node_id));
    }
    diagnostic::Findings findings;
    const std::optional<std::string> text = authoring::clone_text(original.sources[path], original.settings,
                                                                  original.configuration, request, findings);
    if (!text) {
        report_findings({{{path, findings.all(), {}}}, original.sources, color, {}});
        return exit_findings;
    }
    const driver::CheckedFile copy = driver::check_text(output == "-" ? path : output, *text);
    if (!copy.valid()) {
        report_findings(copy, color);
        print_error("the copy would not be valid and is not written");
        return exit_code_of(copy);
    }
    if (!request.title && !original.settings.title.empty()) {
        print_error("note: original and copy have the same title; --title gives the copy its own");
    }
    return write_text(output, *text);
}

}  // namespace

const Verb clone_verb = {"clone", "copy a parameter file for a gateway with another node id", clone_options,
                         run_clone, clone_details};

}  // namespace cgw::cli
