// A scenario file from its path to a scenario, and the images of the plants it runs on.
#pragma once

#include <map>
#include <string>

#include "base/bytes.hpp"
#include "base/result.hpp"
#include "driver/check_file.hpp"
#include "scenario/scenario.hpp"

namespace cgw::driver {

struct ScenarioFile {
    scenario::Scenario scenario;
    diagnostic::Findings findings;
    std::map<std::string, std::string> sources;  // by path: the file's text
    bool unreadable = false;                     // exit code 3

    bool valid() const { return !unreadable && !findings.has_errors(); }
};

// Reads a scenario; what its steps name is looked up later, by scenario::bind(). Path "-" is standard input.
ScenarioFile read_scenario_file(const std::string& path);

// The same for a text that is or will be the file `path`.
ScenarioFile read_scenario_text(const std::string& path, std::string text);

// The configuration image of a valid file, as `emit image` writes it. Fails on a malformed SOURCE_DATE_EPOCH.
base::Result<base::Bytes> image_bytes(const CheckedFile& file);

}  // namespace cgw::driver
