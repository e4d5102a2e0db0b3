#include "compare/compare.hpp"

#include <fmt/format.h>

#include <map>
#include <set>

#include "compare/consequences.hpp"

namespace cgw::compare {
namespace {

using parameter::ParameterSet;

void compare_sets(const ParameterSet& a, const ParameterSet& b, std::vector<ParameterDifference>& result) {
    std::map<std::uint16_t, const parameter::Row*> rows;
    for (const ParameterSet* set : {&a, &b}) {
        for (const auto& [number, assignment] : set->all()) {
            rows.try_emplace(number, assignment.row);
        }
    }
    for (const auto& [number, row] : rows) {
        if (a.value(number) != b.value(number)) {
            result.push_back({row, a.value(number), b.value(number)});
        }
    }
}

// The lines of the canonical model that are no parameters: what else the configuration id depends on.
struct ModelLine {
    std::string_view kind;
    std::string subject;
    std::string text;
};

std::vector<ModelLine> model_lines(const parameter::Settings& settings) {
    std::vector<ModelLine> lines;
    const std::string text = parameter::canonical_text(settings);
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find('\n', at);
        const std::string line = text.substr(at, end - at);
        const std::size_t blank = line.find(' ');
        const std::string word = line.substr(0, blank);
        const std::string rest = line.substr(blank + 1);
        if (word == "title") {
            lines.push_back({"title", "title", rest});
        } else if (word == "identity") {
            lines.push_back({"identity", "identity (3842, 3844, 3845)", rest});
        } else if (word == "main-cycle-us") {
            lines.push_back({"main-cycle", "governor main cycle", rest + " us"});
        } else if (word == "row") {
            const std::size_t number_end = rest.find(' ', rest.find(' ') + 1);
            lines.push_back(
                {"declaration", "declared " + rest.substr(0, number_end), rest.substr(number_end + 1)});
        }
        at = end + 1;
    }
    return lines;
}

std::string text_of(const std::vector<ModelLine>& lines, const std::string& subject) {
    for (const ModelLine& line : lines) {
        if (line.subject == subject) {
            return line.text;
        }
    }
    return "nothing";
}

void compare_models(const parameter::Settings& a, const parameter::Settings& b, Differences& differences) {
    const std::vector<ModelLine> of_a = model_lines(a);
    const std::vector<ModelLine> of_b = model_lines(b);
    for (const ModelLine& line : of_a) {
        note(differences, line.kind, line.subject, line.text, text_of(of_b, line.subject));
    }
    for (const ModelLine& line : of_b) {
        if (text_of(of_a, line.subject) == "nothing") {
            note(differences, line.kind, line.subject, "nothing", line.text);
        }
    }
}

std::string nodes_text(const parameter::Settings& settings) {
    std::set<int> nodes;
    for (const parameter::NetworkNode& node : settings.network_nodes) {
        nodes.insert(node.node_id);
    }
    return nodes.empty() ? "none" : fmt::format("{}", fmt::join(nodes, ", "));
}

}  // namespace

void note(Differences& differences, std::string_view kind, std::string subject, std::string a,
          std::string b) {
    if (a != b) {
        differences.push_back({kind, std::move(subject), std::move(a), std::move(b)});
    }
}

std::vector<NumberRange> ranges_not_printed(const parameter::Catalogue& catalogue, parameter::Device device,
                                            const std::set<std::uint16_t>& printed) {
    std::vector<NumberRange> ranges;
    bool extends = false;
    for (const parameter::Row* row : catalogue.rows(device)) {
        if (!row->settable()) {
            continue;
        }
        if (printed.contains(row->number)) {
            extends = false;
        } else if (extends) {
            ranges.back().last = row->number;
            ++ranges.back().count;
        } else {
            ranges.push_back({device, row->number, row->number, 1});
            extends = true;
        }
    }
    return ranges;
}

Comparison compare(const Side& a, const Side& b) {
    Comparison result;
    compare_sets(a.settings.governor, b.settings.governor, result.parameters);
    compare_sets(a.settings.gateway, b.settings.gateway, result.parameters);
    compare_communication(a.settings, b.settings, result.consequences);
    compare_buses(a.configuration, b.configuration, result.consequences);
    compare_pdos(a.configuration, b.configuration, result.consequences);
    compare_scalings(a, b, result.consequences);
    compare_objects(a.configuration, b.configuration, result.consequences);
    compare_inputs(a.configuration, b.configuration, result.consequences);
    compare_models(a.settings, b.settings, result.otherwise);
    note(result.otherwise, "network", "listed nodes", nodes_text(a.settings), nodes_text(b.settings));
    return result;
}

}  // namespace cgw::compare
