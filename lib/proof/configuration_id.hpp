// Where the artefacts of cgw say which configuration they are of: 16 hexadecimal digits, in an image 64. ""
// where a file says none, as those of other programs do.
#pragma once

#include <string>
#include <string_view>

#include "dbc/database.hpp"
#include "dictionary/dictionary.hpp"
#include "image/image.hpp"

namespace cgw::proof {

std::string configuration_id(const dictionary::Dictionary& description);  // behind FileInfo's Description
std::string configuration_id(const dbc::Database& database);              // behind VERSION
std::string configuration_id(const image::Image& image);                  // in the header

// A text with an id behind it: "Genset 2, configuration 0123456789abcdef". Without one all of it is the text.
struct Identified {
    std::string_view text;
    std::string_view id;
};
Identified split_id(std::string_view text);

}  // namespace cgw::proof
