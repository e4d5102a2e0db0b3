#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/network_inputs.hpp"
#include "cli/cgw/network_report.hpp"
#include "cli/cgw/network_suggest.hpp"
#include "cli/cgw/output_file.hpp"
#include "cli/cgw/shared_options.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"
#include "diagnostic/rules/network.hpp"

namespace cgw::cli {
namespace {

std::vector<Word> network_format_words() {
    return {{"text", "for people"},
            {"json", "one JSON document"},
            {"md", "one Markdown document"},
            {"csv", "the messages as comma-separated values"}};
}

constexpr Option network_options_rows[] = {
    {.names = "FILE",
     .summary = "parameter files of the plants on one bus; - is standard input",
     .required = true,
     .repeats = true,
     .completes = Completes::files},
    {.names = "--node",
     .value = "FILE:ID",
     .summary = "another node: EDS, DCF, XDD or XDC and its node id",
     .repeats = true,
     .completes = Completes::files},
    {.names = "--errors",
     .value = "PER_SECOND",
     .summary = "frames that disturbances destroy",
     .default_value = "0"},
    {.names = "--jitter",
     .value = "MS",
     .summary = "how late messages may be sent whose jitter nobody states",
     .default_value = "0"},
    {.names = "--sdo",
     .value = "MS",
     .summary = "time between two SDO requests to a node; 0: none",
     .default_value = "100"},
    {.names = "--bands",
     .value = "A,B,C",
     .summary = "load in % that is comfortable, ok, and fails beyond",
     .default_value = "30,50,70"},
    {.names = "--what-if",
     .value = "CHANGE",
     .summary = "how it would be with baud=KBIT or TPDO5=MS",
     .repeats = true},
    {.names = "--suggest", .summary = "print a patch to the files with which it works"},
    {.names = "--target",
     .value = "LOAD",
     .summary = "--suggest: worst-case load in % to stay below",
     .default_value = "50"},
    {.names = "--keep-rate", .summary = "--suggest: leave the bit rate as it is"},
    {.names = "--map", .summary = "text: also show the identifiers of the bus as a map"},
    {.names = "--format",
     .value = "FORMAT",
     .summary = "form of the report",
     .default_value = "text",
     .words = network_format_words},
    text_output_option,
    color_option,
};

constexpr std::string_view network_details =
    "Says whether it works: the load of the CANopen bus, on average and in the worst\n"
    "case, and how long each message may take at worst (after Davis, Burns, Bril and\n"
    "Lukkien 2007). All plants given are on one bus. Messages of other nodes come\n"
    "from --node and from [[network.message]] of the files; what nobody states is\n"
    "assumed and marked (D75).\n"
    "--errors counts 31 bit times and the longest frame once more for each error.\n"
    "--suggest moves identifiers that two have to free ones (680h to 6DFh first),\n"
    "then raises the bit rate of all plants, then doubles the cycles of the TPDOs\n"
    "that take most. Apply with patch -p0, after reading it: other nodes must follow.\n"
    "patch takes paths in the directory where it runs, and so does --suggest.\n"
    "Exit code 1 when a message has no bound or misses its deadline, when the load is\n"
    "beyond the last band, or when two send one identifier.\n";

std::vector<diagnostic::FileReport> by_file(diagnostic::Findings& findings) {
    findings.sort();
    std::map<std::string, std::vector<diagnostic::Diagnostic>> by_path;
    for (const diagnostic::Diagnostic& finding : findings.all()) {
        by_path[finding.where.path].push_back(finding);
    }
    std::vector<diagnostic::FileReport> files;
    files.reserve(by_path.size());
    for (auto& [path, own] : by_path) {
        files.push_back({path, std::move(own)});
    }
    return files;
}

void report(const Arguments& arguments, const BusMembers& members,
            const std::vector<diagnostic::FileReport>& findings) {
    diagnostic::RenderInput input;
    input.files = findings;
    for (const driver::CheckedFile& file : members.plants) {
        input.sources.insert(file.sources.begin(), file.sources.end());
    }
    input.sources.insert(members.sources.begin(), members.sources.end());
    input.color = use_color(arguments, stderr);
    if (!findings.empty()) {
        report_findings(input);
    }
}

network::Judged judge(const BusMembers& members, const NetworkOptions& options) {
    network::Judged judged = network::judge_bus(members_of(members), members.nodes,
                                                all_messages(members, options), options.bus, options.bands);
    for (const diagnostic::Related& left_out : members.left_out) {
        judged.findings.report({.rule = &diagnostic::rules::message_not_counted,
                                .message = left_out.message,
                                .where = left_out.where});
    }
    return judged;
}

std::string rendered(const Arguments& arguments, const NetworkReport& bus) {
    const std::string format = arguments.value("--format");
    if (format == "json") {
        return network_json(bus);
    }
    if (format == "text") {
        return network_text(bus, arguments.given("--map"));
    }
    if (format == "md") {
        return network_markdown(bus);
    }
    return explain::find_table_format(format)->render(network_table(bus));
}

// patch changes files below the directory in which it runs, and no others.
void refuse_paths_outside(const std::vector<std::string>& paths) {
    for (const std::string& text : paths) {
        const std::filesystem::path path(text);
        if (path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end()) {
            throw UsageError(
                fmt::format("--suggest: patch refuses to change '{}': run cgw in the directory of "
                            "the files, with paths that lie in it",
                            text));
        }
    }
}

void refuse_contradictions(const Arguments& arguments) {
    const bool suggests = arguments.given("--suggest");
    for (const std::string_view key : {"--what-if", "--format", "--map"}) {
        if (suggests && arguments.given(key)) {
            throw UsageError(fmt::format("--suggest and {} exclude each other", key));
        }
    }
    for (const std::string_view key : {"--target", "--keep-rate"}) {
        if (!suggests && arguments.given(key)) {
            throw UsageError(fmt::format("{} goes with --suggest only", key));
        }
    }
    std::vector<std::string> inputs = arguments.values("FILE");
    if (suggests && std::find(inputs.begin(), inputs.end(), "-") != inputs.end()) {
        throw UsageError("--suggest: a patch needs files with names, not standard input");
    }
    if (suggests) {
        refuse_paths_outside(inputs);
    }
    for (const NodeOption& node : node_options(arguments)) {
        inputs.push_back(node.path);
    }
    refuse_input_as_output(arguments.value("--output"), inputs);
}

int run_suggest(const Arguments& arguments, const NetworkOptions& options, BusMembers& members) {
    const auto ask = [&](const BusMembers& now) {
        const network::Judged judged = judge(now, options);
        const bool works = judged.analysis && !judged.findings.has_errors();
        return BusState{works, judged.analysis ? judged.analysis->load.worst : 1};
    };
    const Suggestion suggestion = suggest(members, options, arguments.given("--keep-rate"), ask);
    if (!suggestion.reached) {
        network::Judged judged = judge(members, options);
        report(arguments, members, by_file(judged.findings));
        print_error(fmt::format("nothing that --suggest may change makes the bus work with a load below {} %",
                                arguments.value("--target")));
        return exit_findings;
    }
    if (suggestion.patch.empty()) {
        print_error("nothing to suggest: it works, and the load is below the target");
    }
    std::string text;
    for (const std::string& change : suggestion.changes) {
        text += fmt::format("# {}\n", change);
    }
    return write_text(arguments.value("--output"), text + suggestion.patch);
}

int run_network(const Arguments& arguments) {
    refuse_contradictions(arguments);
    const NetworkOptions options = network_options(arguments);
    BusMembers members = read_members(arguments);
    if (members.exit_code != exit_fine) {
        return members.exit_code;
    }
    if (arguments.given("--suggest")) {
        return run_suggest(arguments, options, members);
    }
    NetworkReport bus;
    bus.members = members_of(members);
    bus.bands = options.bands;
    if (!options.changes.empty()) {
        network::Judged before = judge(members, options);
        bus.before = std::move(before.analysis);
        bus.fails_before = before.findings.has_errors();
        apply_changes(members, options.changes);
        for (const Change& change : options.changes) {
            bus.changes.push_back(change.text);
        }
    }
    network::Judged judged = judge(members, options);
    bus.findings = by_file(judged.findings);
    report(arguments, members, bus.findings);
    if (!judged.analysis) {
        return exit_findings;
    }
    bus.analysis = std::move(*judged.analysis);
    bus.map = network::identifier_map(judged.messages);
    for (const diagnostic::Related& left_out : members.left_out) {
        bus.left_out.push_back(left_out.message);
    }
    bus.fails = judged.findings.has_errors();
    const int written = write_text(arguments.value("--output"), rendered(arguments, bus));
    return worse(written, bus.fails ? exit_findings : exit_fine);
}

}  // namespace

const Verb network_verb = {"network", "load and response times of the CANopen bus", network_options_rows,
                           run_network, network_details};

}  // namespace cgw::cli
