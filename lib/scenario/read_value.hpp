// Inside the room scenario: one value of a scenario file, as its key's row demands.
#pragma once

#include <string>
#include <string_view>

#include "scenario/actions.hpp"
#include "toml/document.hpp"

namespace cgw::scenario {

struct Reader {
    const std::string& path;
    diagnostic::Findings& findings;

    void report(const diagnostic::Rule& rule, const diagnostic::Range& where, std::string message,
                std::string help = {}) const;
};

// False after a finding.
bool read_value(const Reader& reader, const toml::Entry& entry, const Key& key, Value& value);

// "did you mean `x`?", or empty when no candidate is near.
std::string did_you_mean(std::string_view text, std::span<const std::string_view> candidates);

std::int64_t microseconds(double seconds);

}  // namespace cgw::scenario
