#include <fmt/format.h>

#include <algorithm>

#include "base/json.hpp"
#include "base/utf8.hpp"
#include "compare/compare.hpp"
#include "parameter/value_text.hpp"

namespace cgw::compare {
namespace {

constexpr int format_version = 1;
constexpr std::size_t line_width = 80;
constexpr std::size_t subject_width = 36;

// One line where it fits, else what was and what is below the subject.
std::string line(std::string_view subject, std::string_view a, std::string_view b) {
    const std::string shown = base::printable(subject);
    const std::string before = base::printable(a);
    const std::string after = base::printable(b);
    std::string text = fmt::format("  {:<{}} {} -> {}", shown, subject_width, before, after);
    if (text.size() > line_width || shown.size() > subject_width) {
        text = fmt::format("  {}\n      {}\n   -> {}", shown, before, after);
    }
    return text + "\n";
}

std::string parameter_subject(const parameter::Row& row) {
    return fmt::format("{:<8} {:>5} {}", parameter::to_text(row.device), row.number, row.name);
}

void parameters_section(std::string& text, std::string_view heading,
                        const std::vector<ParameterDifference>& differences, bool has_b) {
    if (differences.empty()) {
        return;
    }
    text += fmt::format("\n{}\n", heading);
    for (const ParameterDifference& difference : differences) {
        const parameter::Row& row = *difference.row;
        text += line(parameter_subject(row), value_text(row, difference.a),
                     has_b ? quantity_text(row, difference.b) : "?");
    }
}

// SDO readers look at single objects: a few are shown, whoever needs all takes the JSON.
constexpr std::size_t objects_shown = 4;

void consequences_section(std::string& text, const std::vector<Difference>& consequences) {
    std::size_t objects = 0;
    text += consequences.empty() ? "" : "\nWhat follows\n";
    for (const Difference& difference : consequences) {
        objects += difference.kind == "object" ? 1U : 0U;
        if (difference.kind != "object" || objects <= objects_shown) {
            text += line(difference.subject, difference.a, difference.b);
        } else if (&difference == &consequences.back() || (&difference)[1].kind != "object") {
            text += fmt::format("  and {} more sub-indexes of 2001h and 2002h\n", objects - objects_shown);
        }
    }
}

// "governor 410..414, 1800", in lines that fit.
std::string ranges_text(parameter::Device device, const std::vector<NumberRange>& ranges) {
    std::string text;
    std::string current = fmt::format("  {:<8}", parameter::to_text(device));
    bool any = false;
    for (const NumberRange& range : ranges) {
        if (range.device != device) {
            continue;
        }
        const std::string numbers = range.first == range.last
                                        ? fmt::format("{}", range.first)
                                        : fmt::format("{}..{}", range.first, range.last);
        current += any ? "," : "";
        any = true;
        if (current.size() + 2 + numbers.size() > line_width) {
            text += current + "\n";
            current = std::string(10, ' ');
        }
        current += " " + numbers;
    }
    return any ? text + current + "\n" : "";
}

void not_printed_section(std::string& text, const std::vector<NumberRange>& ranges) {
    std::size_t count = 0;
    for (const NumberRange& range : ranges) {
        count += range.count;
    }
    if (count != 0) {
        text +=
            fmt::format("\nNot in the tables, taken as in A: {} parameter{}\n", count, count == 1 ? "" : "s");
        text += ranges_text(parameter::Device::governor, ranges);
        text += ranges_text(parameter::Device::gateway, ranges);
    }
}

void ranges_json(base::JsonWriter& json, const std::vector<NumberRange>& ranges) {
    json.key("not_printed").begin_array();
    for (const NumberRange& range : ranges) {
        json.begin_object();
        json.key("device").string(parameter::to_text(range.device));
        json.key("first").integer(range.first);
        json.key("last").integer(range.last);
        json.key("count").integer(static_cast<std::int64_t>(range.count));
        json.end_object();
    }
    json.end_array();
}

void differences_section(std::string& text, std::string_view heading,
                         const std::vector<Difference>& differences) {
    if (differences.empty()) {
        return;
    }
    text += fmt::format("\n{}\n", heading);
    for (const Difference& difference : differences) {
        text += line(difference.subject, difference.a, difference.b);
    }
}

// What is the same; "" where parameters differ and all are known.
std::string verdict(const Comparison& comparison) {
    const bool all = comparison.not_printed.empty() && comparison.not_in_table.empty();
    const bool works_alike = comparison.consequences.empty() &&
                             std::none_of(comparison.otherwise.begin(), comparison.otherwise.end(),
                                          [](const Difference& one) { return one.kind == "image-section"; });
    if (comparison.same()) {
        return all ? "Nothing differs.\n" : "All parameters that the tables print are the same.\n";
    }
    if (!comparison.all_parameters_known) {
        return fmt::format("{}Without the model of both configurations not all parameters are known.\n",
                           !comparison.parameters.empty() ? ""
                           : works_alike                  ? "What a gateway needs is the same.\n"
                                                          : "No parameter is known to differ.\n");
    }
    return comparison.parameters.empty()
               ? fmt::format("All parameters{} are the same.\n", all ? "" : " that the tables print")
               : "";
}

std::string side_text(char letter, const SideName& side) {
    const std::string id =
        side.configuration_id.empty() ? "" : fmt::format("\n   configuration {}", side.configuration_id);
    return fmt::format("{}: {}{}\n", letter, base::printable(fmt::format("{}", fmt::join(side.paths, ", "))),
                       id);
}

void side_json(base::JsonWriter& json, std::string_view key, const SideName& side) {
    json.key(key).begin_object();
    json.key("paths").begin_array();
    for (const std::string& path : side.paths) {
        json.string(path);
    }
    json.end_array();
    json.key("configuration_id");
    side.configuration_id.empty() ? json.null() : json.string(side.configuration_id);
    json.end_object();
}

void parameters_json(base::JsonWriter& json, std::string_view key,
                     const std::vector<ParameterDifference>& differences, bool has_b) {
    json.key(key).begin_array();
    for (const ParameterDifference& difference : differences) {
        json.begin_object();
        json.key("device").string(parameter::to_text(difference.row->device));
        json.key("number").integer(difference.row->number);
        json.key("name").string(difference.row->name);
        json.key("a").real(difference.a);
        json.key("b");
        has_b ? json.real(difference.b) : json.null();
        json.end_object();
    }
    json.end_array();
}

void differences_json(base::JsonWriter& json, std::string_view key,
                      const std::vector<Difference>& differences) {
    json.key(key).begin_array();
    for (const Difference& difference : differences) {
        json.begin_object();
        json.key("kind").string(difference.kind);
        json.key("subject").string(difference.subject);
        json.key("a").string(difference.a);
        json.key("b").string(difference.b);
        json.end_object();
    }
    json.end_array();
}

}  // namespace

std::string render_text(const Comparison& comparison, const SideName& a, const SideName& b) {
    std::string text = side_text('A', a) + side_text('B', b);
    if (const std::string same = verdict(comparison); !same.empty()) {
        text += "\n" + same;
    }
    parameters_section(text, "Parameters", comparison.parameters, true);
    parameters_section(text, "Set in A, not in the tables", comparison.not_in_table, false);
    consequences_section(text, comparison.consequences);
    differences_section(text, "Otherwise", comparison.otherwise);
    not_printed_section(text, comparison.not_printed);
    return text;
}

std::string render_json(const Comparison& comparison, const SideName& a, const SideName& b) {
    base::JsonWriter json;
    json.begin_object();
    json.key("format_version").integer(format_version);
    json.key("same").boolean(comparison.same());
    json.key("all_parameters_known")
        .boolean(comparison.all_parameters_known && comparison.not_printed.empty());
    side_json(json, "a", a);
    side_json(json, "b", b);
    parameters_json(json, "parameters", comparison.parameters, true);
    parameters_json(json, "not_in_table", comparison.not_in_table, false);
    ranges_json(json, comparison.not_printed);
    differences_json(json, "consequences", comparison.consequences);
    differences_json(json, "otherwise", comparison.otherwise);
    json.end_object();
    return json.take();
}

}  // namespace cgw::compare
