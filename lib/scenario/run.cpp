#include "scenario/run.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "scenario/actions.hpp"

namespace cgw::scenario {
namespace {

std::string said_of(const Step& step, const Outcome& outcome) {
    if (outcome.met) {
        return outcome.text;
    }
    return step.action->expects ? fmt::format("expected: {}; {}", outcome.text, outcome.instead)
                                : fmt::format("{}: {}", outcome.text, outcome.instead);
}

}  // namespace

Run::Run(simulation::Installation& installation, const Scenario* scenario, Time end, EventListener listener)
    : installation_(&installation),
      scenario_(scenario),
      end_(end),
      commentary_(installation, std::move(listener)) {}

// Steps take place at their time to the microsecond; between them the buses run in quanta that depend on
// nothing but simulated time.
Time Run::next_stop() const {
    Time stop = std::min((installation_->now() / quantum + 1) * quantum, end_);
    if (next_step_ < steps()) {
        stop = std::min(stop, scenario_->steps[next_step_].at);
    }
    return stop;
}

void Run::advance(Time time) {
    while (true) {
        const Time stop = next_stop();
        if (stop > time || over()) {
            return;
        }
        installation_->plant().run_until(stop);
        take_steps();
    }
}

void Run::take_steps() {
    while (next_step_ < steps() && scenario_->steps[next_step_].at <= installation_->now()) {
        const Step& step = scenario_->steps[next_step_++];
        const Outcome outcome = step.action->run(*this, step);
        ++count_.steps;
        count_.expectations += step.action->expects ? 1 : 0;
        count_.failed += outcome.met ? 0 : 1;
        commentary_.tell(step.action->expects ? EventKind::expected : EventKind::step, said_of(step, outcome),
                         !outcome.met);
        commentary_.poll(installation_->now());
    }
}

}  // namespace cgw::scenario
