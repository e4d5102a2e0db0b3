// The reader of XML device descriptions (XDD) and configurations of a node (XDC), CiA 311 1.0 and 1.1, from
// any bytes: it never fails, tells what is wrong (E09) and leaves that out.
//
// Both dialects: type, access and values stand on the object, in the parameter that its uniqueIDRef names, or
// in both. What the object says counts; what it does not say comes from the parameter, also the difference
// between rw, rwr and rww, for which the object has no word. Where both say different things, that is a
// finding. Prefixes and name spaces of elements are passed over.
//
// Nothing outside of the text is read; a document type, and with it every entity of its own, is refused.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostic/diagnostic.hpp"
#include "dictionary/dictionary.hpp"
#include "xdd/unread.hpp"

namespace cgw::xdd {

// Some half a million sub-objects: an object takes 48 bytes at least.
inline constexpr std::size_t largest_text = 32U * 1024U * 1024U;

// Findings of one kind of one file that are told one by one; the others are counted.
inline constexpr std::size_t most_findings = 100;

struct Sheet {
    dictionary::Dictionary dictionary;
    std::optional<dictionary::Commissioning> commissioning;  // of an XDC
    std::vector<Unread> unread;                              // what the dictionary has no place for
};

// `path` as the findings are to name the file.
Sheet read(std::string_view text, const std::string& path, diagnostic::Findings& findings);

// True when these bytes begin like XML, in UTF-8 or UTF-16: a reader of EDS files has no use for them.
bool is_xml(std::string_view text);

}  // namespace cgw::xdd
