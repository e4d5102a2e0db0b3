// One run of an installation, with or without a scenario, told as events. The same images and scenario give
// the same frames and events, however the time is cut into calls of advance().
#pragma once

#include <cstddef>

#include "scenario/commentary.hpp"
#include "scenario/scenario.hpp"
#include "simulation/installation.hpp"

namespace cgw::scenario {

class Run {
  public:
    // Everything handed in outlives the run. `scenario` is bound, or nullptr; `end` may be canopen::never.
    Run(simulation::Installation& installation, const Scenario* scenario, Time end, EventListener listener);

    // Runs on in whole quanta, at most up to `time` and to the end.
    void advance(Time time);
    static constexpr Time quantum = 10'000;  // us

    bool over() const { return installation_->now() >= end_; }
    Time end() const { return end_; }

    simulation::Installation& installation() { return *installation_; }
    Commentary& commentary() { return commentary_; }

    struct Count {
        std::size_t steps = 0;         // taken, expectations included
        std::size_t expectations = 0;  // looked at
        std::size_t failed = 0;        // steps that could not be taken, expectations not met
    };
    const Count& count() const { return count_; }
    std::size_t steps() const { return scenario_ == nullptr ? 0 : scenario_->steps.size(); }

  private:
    Time next_stop() const;
    void take_steps();

    simulation::Installation* installation_;
    const Scenario* scenario_;
    Time end_;
    Commentary commentary_;
    std::size_t next_step_ = 0;
    Count count_;
};

}  // namespace cgw::scenario
