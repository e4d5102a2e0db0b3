// What `cgw simulate` says at the beginning and at the end of a run.
#pragma once

#include <string>

#include "scenario/run.hpp"

namespace cgw::cli {

// `scenario` may be nullptr.
std::string introduction(const image::Image& image, const scenario::Scenario* scenario);
std::string introduction_json(const image::Image& image, const scenario::Scenario* scenario);

// `complete`: the run was not interrupted.
std::string summary(scenario::Run& run, bool complete);
std::string summary_json(scenario::Run& run, bool complete);

}  // namespace cgw::cli
