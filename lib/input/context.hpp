// What the readers of the file's tables share.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "input/parameter_file.hpp"
#include "toml/document.hpp"

namespace cgw::input {

// Tables that are read last, when the catalogue is complete. More than one of a kind only where a table
// stands twice, once under a misspelt name.
struct Postponed {
    const toml::Entry* catalogues = nullptr;
    std::vector<const toml::Entry*> declarations;
    std::vector<const toml::Entry*> governor_parameters;
    std::vector<const toml::Entry*> gateway_parameters;
};

struct Context {
    const std::string& path;
    parameter::Catalogue& catalogue;
    diagnostic::Findings& findings;
    ParameterFile& file;
    Postponed postponed{};
    std::array<bool, 2> misplaced{};  // by device: it has no table of parameters, and they stand elsewhere

    // True for the first key of such a device; that one is reported, and neither the others nor what is
    // missing.
    bool is_first_misplaced(parameter::Device device) {
        return !std::exchange(misplaced[static_cast<std::size_t>(device)], true);
    }
    parameter::Settings& settings() { return file.settings; }
    diagnostic::Location at(const diagnostic::Range& range) const { return {path, range}; }

    void report(const diagnostic::Rule& rule, const diagnostic::Range& where, std::string message,
                std::string help = {}) {
        findings.report({&rule, std::move(message), at(where), {}, std::move(help)});
    }
};

// "did you mean `x`?", or empty when no candidate is near.
std::string did_you_mean(std::string_view text, std::span<const std::string_view> candidates);

}  // namespace cgw::input
