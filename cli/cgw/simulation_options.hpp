// What `cgw simulate` was asked for, checked.
#pragma once

#include <optional>
#include <string>

#include "media/log.hpp"
#include "simulation/bus.hpp"

namespace cgw::cli {

struct SimulateOptions {
    std::string file;
    std::string scenario;
    std::optional<double> speed;  // nothing: as fast as possible
    std::optional<simulation::Time> duration;
    std::string can2;  // a CAN bus instead of the simulated one; empty: none
    std::string log;
    std::optional<media::LogFormat> log_format;
    bool json = false;
    bool live = false;
    bool color = false;         // of standard output
    bool color_errors = false;  // of the other stream
};

}  // namespace cgw::cli
