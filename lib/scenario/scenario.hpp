// A scenario as plain data: what happens to a plant, when, and what is expected then. Format: TOML,
// docs/scenarios.md.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "canopen/protocol.hpp"
#include "diagnostic/diagnostic.hpp"
#include "image/image.hpp"

namespace cgw::scenario {

using canopen::Time;

inline constexpr int scenario_format = 1;
inline constexpr std::size_t maximum_steps = 1'000;
inline constexpr std::int64_t longest_duration = 30 * 86'400;  // s

struct Action;  // actions.hpp

// The value of one key of a step.
struct Value {
    bool given = false;
    double number = 0;
    // Of an integer its value, of a word its position in the list of words, of a duration microseconds; of
    // what has a number (sensor, error, …) that number, of an object index << 8 | sub-index.
    std::int64_t integer = 0;
    std::string text;
    diagnostic::Range where;
};

// The action's own value, and those of its further keys in the order of the table.
inline constexpr std::size_t maximum_values = 4;

struct Step {
    Time at = 0;  // us
    const Action* action = nullptr;
    std::array<Value, maximum_values> values{};
    diagnostic::Range where;  // of the step's time

    const Value& subject() const { return values[0]; }
};

struct Scenario {
    std::string path;
    std::string title;
    std::string plant;     // parameter file, relative to the scenario; "": none is named
    std::string governor;  // the parameter file that the governor was set up with, if it is another
    Time duration = 0;     // us
    std::vector<Step> steps;
};

// Reads everything it can and reports every mistake. To be run only without errors, and after bind().
Scenario read_scenario(std::string_view text, const std::string& path, diagnostic::Findings& findings);

// Looks up what the steps name in the gateway's image, which must have labels where names are used, and
// reports what this plant does not have.
void bind(Scenario& scenario, const image::Image& image, diagnostic::Findings& findings);

}  // namespace cgw::scenario
