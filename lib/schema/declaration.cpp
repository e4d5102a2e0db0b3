#include "schema/declaration.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "catalogue/cells.hpp"
#include "catalogue/kinds.hpp"
#include "catalogue/values.hpp"
#include "schema/parts.hpp"

namespace cgw::schema {
namespace {

using catalogue::highest_number;
using catalogue::highest_raw;
using catalogue::longest_name;
using catalogue::longest_unit;
using catalogue::lowest_raw;
using catalogue::name_marks;
using catalogue::word_widths;

// "measurement: what a TPDO can carry; switch: 811..849, 4811..4849; …"
std::string kinds_text() {
    std::string text;
    std::string_view before;
    for (const catalogue::Kind& kind : catalogue::all_kinds()) {
        if (kind.first_declared == 0) {
            continue;
        }
        const std::string_view separator = kind.name == before ? ", " : text.empty() ? "" : "; ";
        text += separator;
        text += kind.name == before ? "" : fmt::format("{}: ", kind.name);
        text += kind.list == parameter::List::measurement
                    ? "what a TPDO can carry"
                    : fmt::format("{}..{}", kind.first_declared, kind.last);
        before = kind.name;
    }
    return text;
}

std::string kind_names() {
    std::vector<std::string> names;
    for (const catalogue::Kind& kind : catalogue::all_kinds()) {
        std::string name = base::json_quote(kind.name);
        if (kind.first_declared != 0 && std::find(names.begin(), names.end(), name) == names.end()) {
            names.push_back(std::move(name));
        }
    }
    return fmt::format("{}", fmt::join(names, ","));
}

std::string_view type_name(std::string_view cell) {
    const auto cells = catalogue::all_cells();
    const auto found = std::find_if(cells.begin(), cells.end(),
                                    [cell](const catalogue::Cell& row) { return row.name == cell; });
    switch (found != cells.end() ? found->type : toml::Kind::string) {
        case toml::Kind::integer:
            return "integer";
        case toml::Kind::real:
            return "number";
        case toml::Kind::boolean:
            return "boolean";
        case toml::Kind::array:
            return "array";
        default:
            return "string";
    }
}

}  // namespace

std::vector<DeclarationCell> declaration_cells() {
    return {
        {"number", fmt::format("parameter number, 1..{}", highest_number),
         fmt::format(R"("minimum":1,"maximum":{})", highest_number)},
        {"name",
         fmt::format("name of the parameter: a letter first, then letters, digits and {}, up to {} in all",
                     fmt::join(name_marks, " "), longest_name),
         fmt::format(R"("pattern":"^[A-Za-z][A-Za-z0-9{}]*$","maxLength":{})", name_marks, longest_name)},
        {"kind", kinds_text(), fmt::format(R"("enum":[{}])", kind_names())},
        {"unit", fmt::format("engineering unit, 1 to {} bytes", longest_unit),
         fmt::format(R"("minLength":1,"maxLength":{})", longest_unit)},
        {"width", "bits of a measurement on the wire",
         fmt::format(R"("enum":[{}])", fmt::join(word_widths, ","))},
        {"bit", "true: a measurement of one bit, with neither width nor sign", ""},
        {"signed", "how the bits of a measurement are read", ""},
        {"internal", "lowest and highest raw value, to which `external` belongs",
         fmt::format(R"("items":{{"type":"number","minimum":{},"maximum":{}}},"minItems":2,"maxItems":2)",
                     lowest_raw, highest_raw)},
        {"external",
         "what these two are in units; { parameter = 980 } where the governor holds the limit in a parameter",
         fmt::format(R"("items":{{"anyOf":[{{"type":"number"}},{{"type":"object","properties":{{"parameter":)"
                     R"({{"type":"integer","minimum":1,"maximum":{}}}}},"required":["parameter"],)"
                     R"("additionalProperties":false}}]}},"minItems":2,"maxItems":2)",
                     highest_number)},
    };
}

void write_declaration(base::JsonWriter& json) {
    json.key(declaration).begin_object();
    json.key("description").string("one parameter of this governor that the shipped catalogue does not know");
    json.key("type").string("object").key("properties").begin_object();
    for (const DeclarationCell& cell : declaration_cells()) {
        json.key(cell.name).json(fmt::format(R"({{"description":{},"type":"{}"{}{}}})",
                                             base::json_quote(cell.text), type_name(cell.name),
                                             cell.facets.empty() ? "" : ",", cell.facets));
    }
    json.end_object().key("required").begin_array().string("number").end_array();
    json.key("additionalProperties").boolean(false).end_object();
}

}  // namespace cgw::schema
