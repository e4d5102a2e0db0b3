// Walks TOML text once: every rule of the grammar, every span. What it accepts is well-formed and nested
// no deeper than maximum_nesting, so that the second judge may see it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "toml/document.hpp"
#include "toml/source.hpp"

namespace cgw::toml {

struct ScanResult {
    Node document;
    std::vector<Complaint> out_of_range;  // numbers that do not fit; their values are 0
    std::string text_for_judge;           // as the source, with literals that the judge miscomputes masked
};

// Throws Complaint at the first error. Needs text that passed check_characters().
ScanResult scan(const Source& source);

}  // namespace cgw::toml
