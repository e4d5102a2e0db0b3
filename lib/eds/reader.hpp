// EDS and DCF of any CANopen device (CiA 306) as a dictionary. What cannot be read is a finding (E08) and is
// left out; the rest is read all the same. Whether the file keeps the other rules of CiA 306 is not the
// reader's question: who asks it finds every key with its raw text and place through `sections` and the
// document.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "diagnostic/diagnostic.hpp"
#include "dictionary/dictionary.hpp"
#include "eds/document.hpp"
#include "eds/section_names.hpp"

namespace cgw::eds {

// Sub-objects of one file, over all its objects. CompactSubObj makes 255 of one line.
inline constexpr std::size_t most_variables = 1'000'000;

// Findings of one kind of one file that are told one by one; the others are counted.
inline constexpr std::size_t most_findings = 100;

struct Sheet {
    dictionary::Dictionary dictionary;
    std::optional<dictionary::Commissioning> commissioning;  // of a DCF
    SectionTable sections;                                   // where each object stands
};

// `path` as the findings are to name the file.
//
// Sub-objects that CompactSubObj, and PDO parameters that CompactPDO implies stand in the dictionary like all
// others; in `sections` they have no section of their own. Names and texts are as they stand there: ASCII,
// Latin-1 or UTF-8.
// Of each kind of finding `most` are told one by one.
Sheet read(const Document& document, const std::string& path, diagnostic::Findings& findings,
           std::size_t most = most_findings);

// False for UTF-16 and for what has no section that CiA 306 knows: of such bytes nothing is read.
bool is_sheet(const Document& document);

}  // namespace cgw::eds
