#include "authoring/declaration_text.hpp"

#include <fmt/format.h>

#include "authoring/toml_text.hpp"
#include "base/numbers.hpp"
#include "catalogue/kinds.hpp"
#include "catalogue/values.hpp"

namespace cgw::authoring {
namespace {

using parameter::Row;

bool is_declared_kind(const Row& row) {
    const catalogue::Kind* kind = catalogue::find_kind(catalogue::kind_of(row), row.device, row.number);
    return kind != nullptr && kind->first_declared != 0 && row.number >= kind->first_declared;
}

std::string limit(std::optional<double> constant, std::uint16_t reference) {
    return reference != 0 ? fmt::format("{{ parameter = {} }}", reference)
                          : base::to_text(constant.value_or(0));
}

std::string scaling_text(const parameter::Scaling& scaling) {
    std::string text;
    if (scaling.internal_minimum != scaling.internal_maximum) {
        text += fmt::format("internal = [{}, {}]\n", scaling.internal_minimum, scaling.internal_maximum);
    }
    const bool has_low = scaling.external_minimum || scaling.external_minimum_parameter != 0;
    const bool has_high = scaling.external_maximum || scaling.external_maximum_parameter != 0;
    if (has_low && has_high) {
        text += fmt::format("external = [{}, {}]\n",
                            limit(scaling.external_minimum, scaling.external_minimum_parameter),
                            limit(scaling.external_maximum, scaling.external_maximum_parameter));
    }
    return text;
}

std::string measurement_text(const Row& row) {
    std::string text = row.unit.empty() ? "" : fmt::format("unit = {}\n", toml_string(row.unit));
    if (row.is_bit()) {
        text += "bit = true\n";
    } else if (row.width != 0) {
        text += fmt::format("width = {}\nsigned = {}\n", row.width, row.is_signed);
    }
    return text + (row.scaling ? scaling_text(*row.scaling) : "");
}

}  // namespace

std::string declaration_text(const Row& row) {
    std::string text = fmt::format("\n[[governor.declare]]\nnumber = {}\n", row.number);
    text += !catalogue::is_name(row.name) ? "" : fmt::format("name = {}\n", toml_string(row.name));
    if (is_declared_kind(row)) {
        text += fmt::format("kind = \"{}\"\n", catalogue::kind_of(row));
    }
    return text + (row.list == parameter::List::measurement ? measurement_text(row) : "");
}

}  // namespace cgw::authoring
