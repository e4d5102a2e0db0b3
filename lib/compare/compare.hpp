// What tells two configurations apart: parameters, and what the devices make of them.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "config/configuration.hpp"
#include "parameter/catalogue.hpp"
#include "parameter/settings.hpp"

namespace cgw::compare {

// The settings, what config::resolve() made of them, and the rows of the plant; all outlive the comparison.
struct Side {
    const parameter::Settings& settings;
    const config::Configuration& configuration;
    const parameter::Catalogue& catalogue;
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

// Neighbours in the catalogue, though not always in number.
struct NumberRange {
    parameter::Device device = parameter::Device::governor;
    std::uint16_t first = 0;
    std::uint16_t last = 0;
    std::size_t count = 0;
};

struct Comparison {
    std::vector<ParameterDifference> parameters;    // by device and number
    std::vector<ParameterDifference> not_in_table;  // set in A, absent from the tables that are side B
    std::vector<NumberRange> not_printed;           // settable, absent from the tables; whatever A has
    std::vector<Difference> consequences;           // buses, PDOs, words, switches and sensors
    std::vector<Difference> otherwise;              // title, identity, declarations, listed nodes

    // False: one of the sides does not tell all its parameters, as images without a model.
    bool all_parameters_known = true;

    bool same() const {
        return parameters.empty() && not_in_table.empty() && consequences.empty() && otherwise.empty();
    }
};

Comparison compare(const Side& a, const Side& b);

// The settable parameters of the device that are not among `printed`, ascending.
std::vector<NumberRange> ranges_not_printed(const parameter::Catalogue& catalogue, parameter::Device device,
                                            const std::set<std::uint16_t>& printed);

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
