#include "catalogue/row_source.hpp"

#include <array>
#include <string_view>

#include <fmt/format.h>

#include "base/numbers.hpp"
#include "catalogue/source_text.hpp"

namespace cgw::catalogue {

namespace {

using parameter::Row;

std::string real_literal(double value) {
    const std::string text = base::to_text(value);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string optional_literal(std::optional<double> value) {
    return value ? real_literal(*value) : "std::nullopt";
}

std::string_view enumerator(parameter::Device device) {
    return device == parameter::Device::governor ? "Device::governor" : "Device::gateway";
}

std::string_view enumerator(parameter::List list) {
    constexpr std::array<std::string_view, 4> names = {"List::parameter", "List::measurement",
                                                       "List::function", "List::curve"};
    return names[static_cast<std::size_t>(list)];
}

std::string_view enumerator(parameter::Role role) {
    constexpr std::array<std::string_view, 5> names = {"Role::none", "Role::switch_assignment",
                                                       "Role::switch_type", "Role::sensor_assignment",
                                                       "Role::sensor_type"};
    return names[static_cast<std::size_t>(role)];
}

std::string list_name(const Row& row, std::string_view list) {
    return fmt::format("{}_{}_{}_{}", to_text(row.device), to_text(row.program), row.number, list);
}

void append_values(std::string& source, const Row& row) {
    if (row.values.empty()) {
        return;
    }
    source += fmt::format("constexpr NamedValue {}[] = {{\n", list_name(row, "values"));
    for (const parameter::NamedValue& value : row.values) {
        source += fmt::format("    {{{}, {}}},\n", value.value, string_literal(value.text));
    }
    source += "};\n";
}

void append_numbers(std::string& source, const std::string& name, std::span<const std::uint32_t> numbers) {
    if (!numbers.empty()) {
        source += fmt::format("constexpr std::uint32_t {}[] = {{{}}};\n", name, fmt::join(numbers, ", "));
    }
}

void append_lists(std::string& source, const Row& row) {
    source += text_list_source(list_name(row, "aliases"), row.aliases);
    source += text_list_source(list_name(row, "misprints"), row.misprints);
    source += bit_list_source(list_name(row, "bits"), row.bits);
    append_values(source, row);
    append_numbers(source, list_name(row, "choices"), row.choices);
    append_numbers(source, list_name(row, "pages"), row.pages);
}

std::string scaling_literal(const Row& row) {
    if (!row.scaling) {
        return "std::nullopt";
    }
    const parameter::Scaling& scaling = *row.scaling;
    return fmt::format("Scaling{{{}, {}, {}, {}, {}, {}}}", scaling.internal_minimum,
                       scaling.internal_maximum, optional_literal(scaling.external_minimum),
                       optional_literal(scaling.external_maximum), scaling.external_minimum_parameter,
                       scaling.external_maximum_parameter);
}

void append_row(std::string& source, const Row& row) {
    const auto list = [&](bool empty, std::string_view name) { return empty ? "{}" : list_name(row, name); };
    source += fmt::format("    {{.device = {}, .program = Program::{}, .number = {}, .name = {},\n",
                          enumerator(row.device), to_text(row.program), row.number, string_literal(row.name));
    source += fmt::format("     .aliases = {}, .misprints = {},\n", list(row.aliases.empty(), "aliases"),
                          list(row.misprints.empty(), "misprints"));
    source += fmt::format("     .list = {}, .role = {}, .level = {}, .minimum = {}, .maximum = {},\n",
                          enumerator(row.list), enumerator(row.role), row.level,
                          optional_literal(row.minimum), optional_literal(row.maximum));
    source += fmt::format("     .choices = {}, .unit = {}, .base = {}, .decimal = {},\n",
                          list(row.choices.empty(), "choices"), string_literal(row.unit),
                          row.base == parameter::Base::hexadecimal ? "Base::hexadecimal" : "Base::decimal",
                          row.decimal);
    source += fmt::format("     .array_first = {}, .array_size = {}, .list_end = {},\n", row.array_first,
                          row.array_size, row.list_end);
    source += fmt::format("     .width = {}, .is_signed = {}, .scaling = {},\n", row.width, row.is_signed,
                          scaling_literal(row));
    source += fmt::format("     .bits = {}, .values = {},\n", list(row.bits.empty(), "bits"),
                          list(row.values.empty(), "values"));
    source +=
        fmt::format("     .text = {}, .used = {}, .section = {}, .pages = {}}},\n", string_literal(row.text),
                    string_literal(row.used), string_literal(row.section), list(row.pages.empty(), "pages"));
}

}  // namespace

std::string row_source(std::span<const Row* const> rows) {
    std::string source =
        "// Generated by cgw_catalogue_generate from schemas/parameters; changes here are lost.\n"
        "#include \"catalogue/catalogue.hpp\"\n\n"
        "namespace cgw::catalogue {\n\nnamespace {\n\nusing namespace parameter;\n\n";
    for (const Row* row : rows) {
        append_lists(source, *row);
    }
    source += "\nconstexpr Row rows[] = {\n";
    for (const Row* row : rows) {
        append_row(source, *row);
    }
    source +=
        "};\n\n}  // namespace\n\nstd::span<const Row> shipped_rows() { return rows; }\n\n}  // namespace "
        "cgw::catalogue\n";
    return source;
}

}  // namespace cgw::catalogue
