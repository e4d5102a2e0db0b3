#include <fmt/format.h>

#include "cli/cgw/description_input.hpp"
#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/shared_options.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"
#include "dictionary/difference.hpp"
#include "driver/device_description.hpp"

namespace cgw::cli {
namespace {

std::vector<Word> format_words() {
    std::vector<Word> words;
    for (const dictionary::DifferenceFormat& format : dictionary::difference_formats()) {
        words.push_back({format.name, format.summary});
    }
    return words;
}

constexpr Option eds_diff_options[] = {
    {.names = "A",
     .summary = "EDS, DCF, XDD, XDC, parameter file or image; - is standard input",
     .required = true,
     .completes = Completes::files},
    {.names = "B", .summary = "the same, to compare with", .required = true, .completes = Completes::files},
    node_id_option,
    {.names = "--format",
     .value = "FORMAT",
     .summary = "form of the report",
     .default_value = "text",
     .words = format_words},
    color_option,
};

constexpr std::string_view eds_diff_details =
    "Compares what the files say of the device: who it is, its objects, their types,\n"
    "access, mapping and values. The order of lines, how numbers are written,\n"
    "comments, dates and versions of the files do not count. What kind a file is, is\n"
    "told from its content. $NODEID is resolved with --node-id, else with the node\n"
    "number that one of the files states (DCF, parameter file, image); without any,\n"
    "formulas are compared as they stand. Exit code 0 when nothing differs, 1 when\n"
    "something does or a file has errors, 3 when one cannot be read.\n";

dictionary::Side side_of(const driver::DeviceDescription& description) {
    return {.dictionary = description.dictionary,
            .commissioning = description.commissioning ? &*description.commissioning : nullptr,
            .node_id = description.node_id,
            .bare = description.kind == driver::DescriptionKind::image};
}

// A number that would change nothing, or contradicts a file, is a slip.
void refuse_node_id(const std::optional<std::uint8_t>& node_id, const driver::DeviceDescription& a,
                    const driver::DeviceDescription& b) {
    if (!node_id) {
        return;
    }
    if (a.node_id && b.node_id) {
        throw UsageError("--node-id is for files that state no node number; both state theirs");
    }
    for (const driver::DeviceDescription* const side : {&a, &b}) {
        if (side->node_id && *side->node_id != *node_id) {
            throw UsageError(
                fmt::format("{} is about node {}; leave --node-id out", side->path, *side->node_id));
        }
    }
}

int eds_diff(const Arguments& arguments) {
    if (arguments.value("A") == "-" && arguments.value("B") == "-") {
        throw UsageError("standard input (-) can be read only once");
    }
    const dictionary::DifferenceOptions options{node_id_of(arguments)};
    int exit_code = exit_fine;
    const driver::DeviceDescription a = load_description(arguments, arguments.value("A"), exit_code);
    const driver::DeviceDescription b = load_description(arguments, arguments.value("B"), exit_code);
    if (!a.valid() || !b.valid()) {
        return exit_code;
    }
    refuse_node_id(options.node_id, a, b);
    const dictionary::Differences found = differences(side_of(a), side_of(b), options);
    for (const dictionary::DifferenceFormat& format : dictionary::difference_formats()) {
        if (format.name == arguments.value("--format") &&
            !print(format.render(found, {a.path, to_text(a.kind)}, {b.path, to_text(b.kind)}))) {
            return exit_environment;
        }
    }
    return worse(exit_code, found.same() ? exit_fine : exit_findings);
}

}  // namespace

const Verb eds_diff_verb = {"eds diff", "compare two descriptions of a device", eds_diff_options, eds_diff,
                            eds_diff_details};

}  // namespace cgw::cli
