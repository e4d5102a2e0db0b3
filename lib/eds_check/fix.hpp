// Repairs of EDS and DCF: of what the checks find, only what can be meant in one way, and nothing that
// changes the device that the file describes. Every byte that no repair names stays as it is.
#pragma once

#include <string>
#include <vector>

#include "diagnostic/diagnostic.hpp"
#include "eds_check/checks.hpp"

namespace cgw::eds_check {

struct Repaired {
    const diagnostic::Rule* rule;
    diagnostic::Location where;  // in the text as it was
    std::string what;            // "SubNumber=5 becomes 4"
};

struct Fixed {
    std::string text;               // the given one when there are doubts or nothing to repair
    std::vector<Repaired> repairs;  // by place
    diagnostic::Findings doubts;    // for which nothing was repaired: it is not certain what the file says
};

// `text` has at most eds::largest_text bytes. Of the result there is nothing left to repair.
Fixed fix(std::string text, const std::string& path, const Options& given);

}  // namespace cgw::eds_check
