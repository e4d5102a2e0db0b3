// What may happen to a plant.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "simulation/soak/world.hpp"

namespace cgw::simulation::soak {

struct Disturbance {
    std::string name;
    std::set<unsigned> errors;  // that it may bring about
    std::function<void(World&)> begin;
    std::function<void(World&)> end = [](World&) {};
    std::function<void(World&)> again = [](World&) {};  // now and then while it lasts
    std::set<Alarm> alarms = {};                        // that it may bring about
    Time lasts = 0;                                     // at most so much longer than others
};

std::vector<Disturbance> disturbances();

}  // namespace cgw::simulation::soak
