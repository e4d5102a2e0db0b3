#include <fmt/format.h>

#include <filesystem>

#include "cli/cgw/description_input.hpp"
#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/output_file.hpp"
#include "cli/cgw/shared_options.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"
#include "convert/formats.hpp"
#include "diagnostic/rules/eds.hpp"
#include "diagnostic/rules/xdd.hpp"
#include "eds/value_places.hpp"

namespace cgw::cli {
namespace {

using driver::DescriptionKind;

std::vector<Word> format_words() {
    std::vector<Word> words;
    for (const convert::Format& format : convert::formats()) {
        words.push_back({format.name, format.summary});
    }
    return words;
}

constexpr Option convert_options[] = {
    {.names = "FILE",
     .summary = "EDS, DCF, XDD or XDC; - is standard input",
     .required = true,
     .completes = Completes::files},
    {.names = "--to",
     .value = "FORMAT",
     .summary = "what to make of it; follows from the ending of -o",
     .words = format_words},
    text_output_option,
    force_option,
    node_id_option,
    color_option,
};

constexpr std::string_view convert_details =
    "What kind FILE is, is told from its content. A file with errors is refused.\n"
    "An EDS or XDD becomes the DCF, XDC or concise DCF of one node with --node-id:\n"
    "formulas with $NODEID are resolved, and objects that no PDO carries get their\n"
    "defaults as values. What the new format cannot hold is told on standard error,\n"
    "with how often it was there; docs/conversions.md lists it. So is what is not\n"
    "carried over: keys of vendors, comments, elements of an XDD that are of no\n"
    "object, and sections that say nothing of objects, which only EDS and DCF keep.\n"
    "EDS, XDD, JSON and tables refuse --node-id.\n"
    "A concise DCF has those objects that can be written and whose value is not\n"
    "their default, PDOs in the order in which a device lets itself be changed.\n";

const convert::Format& format_of(const Arguments& arguments) {
    const std::string output = arguments.value("--output");
    if (arguments.given("--to")) {
        return *convert::find_format(arguments.value("--to"));
    }
    const convert::Format* const format = convert::format_of_file(output);
    if (format == nullptr) {
        throw UsageError(output == "-"
                             ? "--to is missing: nothing says what to make of the file"
                             : fmt::format("--to is missing: the ending of {} names no format", output));
    }
    return *format;
}

void refuse_kind(const driver::DeviceDescription& description) {
    if (description.kind == DescriptionKind::parameter_file) {
        throw UsageError(fmt::format("{} is a parameter file; cgw emit makes EDS, DCF, XDD and XDC of it",
                                     description.path));
    }
    if (description.kind == DescriptionKind::image) {
        throw UsageError(
            fmt::format("{} is a configuration image, which has no names of objects; cgw image "
                        "decompile makes a parameter file of it",
                        description.path));
    }
}

void tell_unread(const std::vector<convert::Unread>& unread) {
    constexpr std::size_t most_told = 20;
    const std::size_t told = std::min(unread.size(), most_told);
    for (std::size_t i = 0; i < told; ++i) {
        const convert::Unread& each = unread[i];
        const bool is_one_section = each.count == 1 && each.what.starts_with('[');
        fmt::print(stderr, "not carried over: {}{}\n", each.what,
                   is_one_section ? "" : fmt::format(" ({})", each.count));
    }
    if (told < unread.size()) {
        std::size_t more = 0;
        for (std::size_t i = told; i < unread.size(); ++i) {
            more += unread[i].count;
        }
        fmt::print(stderr, "not carried over: {} others of {} more kinds\n", more, unread.size() - told);
    }
}

void tell_losses(const convert::Product& product, const convert::Format& format) {
    for (const convert::Loss& loss : product.losses) {
        fmt::print(stderr, "{} does not hold: {} ({})\n", format.name, loss.row->text, loss.count);
    }
    if (product.resolved > 0) {
        fmt::print(stderr, "resolved for node {}: $NODEID in default values ({})\n", product.node_id,
                   product.resolved);
    }
}

// The file is at fault, or the node number.
int report_overflow(const Arguments& arguments, const driver::DeviceDescription& description,
                    const convert::Refusal& refusal) {
    const bool is_sheet = driver::is_eds(description.kind);
    const diagnostic::Range place = is_sheet ? eds::ValuePlaces(description.sources.at(description.path))
                                                   .of_object(*refusal.index, refusal.sub_index)
                                             : diagnostic::Range{};
    diagnostic::RenderInput input;
    input.files.push_back(
        {description.path,
         {{.rule = is_sheet ? &diagnostic::rules::eds_number_range : &diagnostic::rules::xdd_number_range,
           .message = refusal.why,
           .where = {description.path, place}}}});
    input.sources = description.sources;
    input.color = use_color(arguments, stderr);
    report_findings(input);
    return exit_findings;
}

int run_convert(const Arguments& arguments) {
    const std::string path = arguments.value("FILE");
    const std::string output = arguments.value("--output");
    const convert::Format& format = format_of(arguments);
    const std::optional<std::uint8_t> node_id = node_id_of(arguments);
    refuse_input_as_output(output, {path});
    refuse_existing_output(arguments, output);
    int exit_code = exit_fine;
    driver::DeviceDescription description = load_description(arguments, path, exit_code);
    if (!description.valid()) {
        print_error(description.unreadable ? fmt::format("{} cannot be read; nothing is written", path)
                                           : fmt::format("{} has errors; nothing is written", path));
        return exit_code;
    }
    refuse_kind(description);
    const std::string file_name = output == "-" ? "" : std::filesystem::path(output).filename().string();
    const auto product =
        convert::convert({description.dictionary, description.commissioning, description.sections},
                         {.format = format, .node_id = node_id, .file_name = file_name});
    if (!product && product.error().index) {
        return report_overflow(arguments, description, product.error());
    }
    if (!product) {
        throw UsageError(fmt::format("{}: {}", path, product.error().why));
    }
    if (const int written = write_text(output, {product->bytes.begin(), product->bytes.end()});
        written != exit_fine) {
        return written;
    }
    std::vector<convert::Unread> unread = product->lost_sections;
    unread.insert(unread.end(), description.unread.begin(), description.unread.end());
    tell_unread(unread);
    tell_losses(*product, format);
    if (product->no_entries) {
        fmt::print(stderr, "the list has no entries: no value differs from its default\n");
    }
    return exit_fine;
}

}  // namespace

const Verb convert_verb = {"convert", "make another form of an EDS, DCF, XDD or XDC", convert_options,
                           run_convert, convert_details};

}  // namespace cgw::cli
