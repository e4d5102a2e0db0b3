// What targets have in common.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "base/bytes.hpp"
#include "driver/check_file.hpp"
#include "fuzz/targets.hpp"

namespace cgw::fuzz {

// Ends the program, and says what did not hold, unless `holds`.
void demand(bool holds, std::string_view what);

// True for one input in `n`, always the same ones: for what would make a target slow if it were done each
// time.
bool sometimes(Input input, unsigned n);

// Every finding has a message and stands in one of the texts it may point into; every renderer takes them.
void demand_sound(const diagnostic::FileReport& report, const std::map<std::string, std::string>& sources);

// Text before and behind the first line that is `separator`; without one the second is empty.
struct Parts {
    std::string first;
    std::string second;
    bool separated = false;
};
Parts split(Input input, std::string_view separator);

// The image of a valid file.
base::Bytes image_of(const driver::CheckedFile& file, bool labels);

}  // namespace cgw::fuzz
