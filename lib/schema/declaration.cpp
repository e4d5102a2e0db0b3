#include "schema/declaration.hpp"

#include <fmt/format.h>

#include "schema/parts.hpp"

namespace cgw::schema {
namespace {

constexpr DeclarationCell cells[] = {
    {"number", "parameter number, 1..29999", R"("type":"integer","minimum":1,"maximum":29999)"},
    {"name", "name of the parameter: a letter first, then letters, digits and _ - : . /, up to 64 in all",
     R"("type":"string","pattern":"^[A-Za-z][A-Za-z0-9_:./-]*$","maxLength":64)"},
    {"kind", "measurement: what a TPDO can carry; switch: 811..849, 4811..4849; sensor: 900..929, 4900..4929",
     R"("type":"string","enum":["measurement","switch","sensor"])"},
    {"unit", "engineering unit, 1 to 16 bytes", R"("type":"string","minLength":1,"maxLength":16)"},
    {"width", "bits of a measurement on the wire", R"("type":"integer","enum":[8,16])"},
    {"bit", "true: a measurement of one bit, with neither width nor sign", R"("type":"boolean")"},
    {"signed", "how the bits of a measurement are read", R"("type":"boolean")"},
    {"internal", "lowest and highest raw value, to which `external` belongs",
     R"("type":"array","items":{"type":"number","minimum":-32768,"maximum":65535},"minItems":2,"maxItems":2)"},
    {"external",
     "what these two are in units; { parameter = 980 } where the governor holds the limit in a parameter",
     R"("type":"array","items":{"anyOf":[{"type":"number"},{"type":"object","properties":{"parameter":)"
     R"({"type":"integer","minimum":1,"maximum":29999}},"required":["parameter"],)"
     R"("additionalProperties":false}]},"minItems":2,"maxItems":2)"},
};

}  // namespace

std::span<const DeclarationCell> declaration_cells() {
    return cells;
}

void write_declaration(base::JsonWriter& json) {
    json.key(declaration).begin_object();
    json.key("description").string("one parameter of this governor that the shipped catalogue does not know");
    json.key("type").string("object").key("properties").begin_object();
    for (const DeclarationCell& cell : cells) {
        json.key(cell.name).json(
            fmt::format(R"({{"description":{},{}}})", base::json_quote(cell.text), cell.facets));
    }
    json.end_object().key("required").begin_array().string("number").end_array();
    json.key("additionalProperties").boolean(false).end_object();
}

}  // namespace cgw::schema
