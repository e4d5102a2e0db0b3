// The cells of [[governor.declare]] for editors. catalogue/cells.hpp says which there are and reads them.
#pragma once

#include <span>
#include <string_view>

namespace cgw::schema {

struct DeclarationCell {
    std::string_view name;
    std::string_view text;
    std::string_view facets;  // members of its schema, as JSON
};

std::span<const DeclarationCell> declaration_cells();

}  // namespace cgw::schema
