// The parameter file that a new plant begins with.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "parameter/catalogue.hpp"

namespace cgw::authoring {

// What stands in the file about one parameter, or about the list that begins at it.
struct Start {
    enum class How : std::uint8_t {
        preset,   // a value that holds for most plants
        fill_in,  // nobody can guess it: a comment until the user writes the value
        example,  // a comment; the feature is off
    };
    parameter::Device device;
    std::uint16_t number;
    How how;
    std::string_view value{};    // as TOML takes it
    std::string_view heading{};  // of the group that begins here
    std::string_view remark{};   // what follows from another parameter
};

std::span<const Start> starts();

// Commented with text, range and unit of the catalogue's rows. cgw refuses it with one error for each value
// that is to be filled in; filled in, it has no findings. `title` "": none.
std::string new_file_text(std::string_view title, const parameter::Catalogue& catalogue);

}  // namespace cgw::authoring
