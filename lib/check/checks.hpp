// The check table: what the settings must hold beyond their own ranges, so that the plant works.
#pragma once

#include <span>

#include "config/configuration.hpp"
#include "diagnostic/diagnostic.hpp"
#include "parameter/settings.hpp"

namespace cgw::check {

struct Context {
    const parameter::Settings& settings;
    const parameter::Catalogue& catalogue;
    const config::Configuration& configuration;
    diagnostic::Findings& findings;
};

struct Check {
    const diagnostic::Rule* rule;
    void (*run)(const Context&);
};

std::span<const Check> all_checks();

// Runs the whole table.
void check(const Context& context);

}  // namespace cgw::check
