// The cells of [[governor.declare]] for editors. The catalogue says which there are, of what type and within
// what limits, and reads them; here they get their words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cgw::schema {

struct DeclarationCell {
    std::string_view name;
    std::string text;
    std::string facets;  // members of its schema beside the type, as JSON
};

std::vector<DeclarationCell> declaration_cells();

}  // namespace cgw::schema
