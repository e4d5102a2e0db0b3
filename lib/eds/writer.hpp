// A dictionary as an electronic data sheet (CiA 306): CRLF, ASCII, keys that strict importers accept.
#pragma once

#include <string>

#include "dictionary/dictionary.hpp"
#include "eds/document.hpp"

namespace cgw::eds {

Document to_document(const dictionary::Dictionary& dictionary);

// to_document() and print() in one.
std::string write(const dictionary::Dictionary& dictionary);

}  // namespace cgw::eds
