// The pages of docs/ that are made from the tables. A test compares them with the files; with
// CGW_UPDATE_GOLDEN=1 it rewrites them.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "parameter/catalogue.hpp"

namespace cgw::explain {

struct Page {
    std::string_view file_name;  // in docs/
    std::string (*text)(const parameter::Catalogue& catalogue);
};

std::span<const Page> generated_pages();

}  // namespace cgw::explain
