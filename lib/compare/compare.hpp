// What tells two configurations apart: parameters, and what the devices make of them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "config/configuration.hpp"
#include "parameter/settings.hpp"

namespace cgw::compare {

// The settings and what config::resolve() made of them; both must outlive the comparison.
struct Side {
    const parameter::Settings& settings;
    const config::Configuration& configuration;
};

struct ParameterDifference {
    const parameter::Row* row = nullptr;
    double a = 0;
    double b = 0;
};

// `kind` is a stable word of the JSON document (docs/command-line.md); `a` and `b` are texts for people, and
// "nothing", "off" and the like where one side has none.
struct Difference {
    std::string_view kind;
    std::string subject;
    std::string a;
    std::string b;
};

struct Comparison {
    std::vector<ParameterDifference> parameters;    // by device and number
    std::vector<ParameterDifference> not_in_table;  // set in A, absent from the tables that are side B
    std::vector<Difference> consequences;           // buses, then PDOs, then switches and sensors
    std::vector<Difference> otherwise;              // title, identity, declarations, listed nodes

    bool same() const {
        return parameters.empty() && not_in_table.empty() && consequences.empty() && otherwise.empty();
    }
};

Comparison compare(const Side& a, const Side& b);

// How the two sides are called in texts.
struct SideName {
    std::vector<std::string> paths;
    std::string configuration_id;  // 16 digits; "" for tables
};

// For people, 80 columns as far as names and titles allow; one line when nothing differs.
std::string render_text(const Comparison& comparison, const SideName& a, const SideName& b);

// One JSON document, schemas/diff-report.schema.json.
std::string render_json(const Comparison& comparison, const SideName& a, const SideName& b);

}  // namespace cgw::compare
