#include <fmt/format.h>

#include "base/json.hpp"
#include "base/numbers.hpp"
#include "base/utf8.hpp"
#include "compare/compare.hpp"

namespace cgw::compare {
namespace {

constexpr int format_version = 1;
constexpr std::size_t line_width = 80;
constexpr std::size_t subject_width = 36;

std::string value_text(const parameter::Row& row, double value) {
    return row.base == parameter::Base::hexadecimal && value >= 0
               ? fmt::format("{:X}h", static_cast<std::uint32_t>(value))
               : base::to_text(value);
}

std::string unit_text(const parameter::Row& row) {
    return row.unit.empty() || row.base == parameter::Base::hexadecimal ? "" : fmt::format(" {}", row.unit);
}

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
                     has_b ? value_text(row, difference.b) + unit_text(row) : "?");
    }
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
    if (comparison.same()) {
        return text + "\nNothing differs.\n";
    }
    if (comparison.parameters.empty()) {
        text += "\nAll parameters are the same.\n";
    }
    parameters_section(text, "Parameters", comparison.parameters, true);
    parameters_section(text, "Set in A, not in the tables", comparison.not_in_table, false);
    differences_section(text, "What follows", comparison.consequences);
    differences_section(text, "Otherwise", comparison.otherwise);
    return text;
}

std::string render_json(const Comparison& comparison, const SideName& a, const SideName& b) {
    base::JsonWriter json;
    json.begin_object();
    json.key("format_version").integer(format_version);
    json.key("same").boolean(comparison.same());
    side_json(json, "a", a);
    side_json(json, "b", b);
    parameters_json(json, "parameters", comparison.parameters, true);
    parameters_json(json, "not_in_table", comparison.not_in_table, false);
    differences_json(json, "consequences", comparison.consequences);
    differences_json(json, "otherwise", comparison.otherwise);
    json.end_object();
    return json.take();
}

}  // namespace cgw::compare
