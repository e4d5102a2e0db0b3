// Every alarm of the engine: when it rises, when it goes, and that it does neither without reason.
#include "simulation/alarms.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "simulation/engine_state_word.hpp"

namespace cgw::simulation {
namespace {

constexpr Time cycle = 15'625;
constexpr Time second = 1'000'000;

// Alarms fed with made-up values of an engine.
class AlarmRows : public testing::TestWithParam<AlarmRow> {
  protected:
    AlarmRows() { running(); }

    void running() {
        engine_.ran_up = true, engine_.speed = rated_speed, engine_.oil_pressure = 4,
        engine_.coolant_temperature = 80;
    }
    void standing() { engine_.ran_up = false, engine_.speed = 0, engine_.oil_pressure = 0; }

    void set(double value) {
        double* const values[] = {&engine_.oil_pressure,           &engine_.oil_pressure,
                                  &engine_.coolant_temperature,    &engine_.coolant_temperature,
                                  &engine_.charge_air_temperature, &engine_.speed};
        *values[static_cast<std::size_t>(row().alarm)] = value;
    }
    // A little beyond `limit`, where the alarm is, or a little before.
    double beyond(double limit, double by = 0.01) const {
        return row().side == Side::below ? limit - by : limit + by;
    }
    void follow(Time time) {
        for (Time passed = 0; passed < time; passed += cycle) {
            alarms_.follow(engine_, cycle);
            changes_ += alarms_.present(row().alarm) == before_ ? 0 : 1;
            before_ = alarms_.present(row().alarm);
        }
    }
    void raise() {
        follow(run_up_time);
        set(beyond(row().limit));
        follow(row().delay + cycle);
        ASSERT_TRUE(present());
    }
    bool present() const { return alarms_.present(row().alarm); }
    static const AlarmRow& row() { return GetParam(); }

    EngineState engine_;
    EngineAlarms alarms_;
    bool before_ = false;
    int changes_ = 0;
};

TEST_P(AlarmRows, rises_beyond_its_limit_after_its_delay) {
    follow(run_up_time);
    set(row().limit);
    follow(10 * second);
    EXPECT_FALSE(present()) << "at the limit itself";
    set(beyond(row().limit));
    if (row().delay != 0) {
        follow(row().delay - 2 * cycle);
        EXPECT_FALSE(present());
    }
    follow(2 * cycle);
    EXPECT_TRUE(present());
}

TEST_P(AlarmRows, ignores_what_is_shorter_than_its_delay) {
    follow(run_up_time);
    for (int i = 0; i < 100 && row().delay != 0; ++i) {
        set(beyond(row().limit));
        follow(row().delay - 2 * cycle);
        set(beyond(row().released, -0.01));
        follow(cycle);
    }
    EXPECT_FALSE(present());
}

TEST_P(AlarmRows, does_not_flicker_around_its_limit) {
    ASSERT_NE(row().limit, row().released);
    raise();
    for (int i = 0; i < 100; ++i) {
        set(beyond(row().limit, i % 2 == 0 ? -0.01 : 0.01));
        follow(row().delay + cycle);
        EXPECT_TRUE(present());
    }
    EXPECT_EQ(changes_, 1);
}

TEST_P(AlarmRows, goes_by_itself_when_its_cause_is_gone_unless_it_stops_the_engine) {
    raise();
    set(beyond(row().released));
    follow(10 * second);
    EXPECT_TRUE(present());
    set(row().released);
    follow(cycle);
    EXPECT_EQ(present(), row().stops);
    EXPECT_EQ(alarms_.emergency_stop(), row().stops);
}

TEST_P(AlarmRows, is_cleared_only_at_stand_still_and_without_its_cause) {
    raise();
    alarms_.clear(engine_);
    EXPECT_TRUE(present());
    set(row().released);
    alarms_.clear(engine_);
    EXPECT_TRUE(present()) << "the engine still turns";
    standing();
    follow(10 * second);
    EXPECT_EQ(present(), row().stops);
    alarms_.clear(engine_);
    EXPECT_FALSE(present());
    EXPECT_FALSE(alarms_.emergency_stop());
}

TEST_P(AlarmRows, of_a_running_engine_is_silent_at_stand_still_and_during_run_up) {
    const bool always = row().watched == Watched::always;
    standing();
    set(beyond(row().limit));
    follow(60 * second);
    EXPECT_EQ(present(), always);
    alarms_ = {};
    engine_.ran_up = true;
    engine_.speed = std::max(engine_.speed, idle_speed);
    follow(run_up_time - cycle);
    EXPECT_EQ(present(), always);
    follow(row().delay + cycle);
    EXPECT_TRUE(present());
}

INSTANTIATE_TEST_SUITE_P(All, AlarmRows, testing::ValuesIn(alarm_rows().begin(), alarm_rows().end()),
                         [](const auto& test) {
                             std::string name(test.param.name);
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

TEST(AlarmTable, is_in_the_order_of_the_alarms) {
    for (std::size_t i = 0; i < alarm_count; ++i) {
        EXPECT_EQ(static_cast<std::size_t>(alarm_rows()[i].alarm), i);
    }
}

// --- with the engine ---

class GuardedEngine : public testing::Test {
  protected:
    void run_for(double seconds) {
        for (Time passed = 0; passed < static_cast<Time>(seconds * 1e6); passed += cycle) {
            inputs_.emergency_stop = alarms_.emergency_stop();
            engine_.advance(static_cast<double>(cycle) / 1e6, inputs_);
            alarms_.follow(engine_.state(), cycle);
            raised_ |= alarms_.any();
            highest_ = std::max(highest_, engine_.state().speed);
        }
    }
    std::string raised() const {
        std::string names;
        for (const AlarmRow& row : alarm_rows()) {
            names += alarms_.present(row.alarm) ? (names.empty() ? "" : ", ") + std::string(row.name) : "";
        }
        return names;
    }
    std::uint16_t word(bool sensor_faulty = false) const {
        return engine_state_word({&engine_.state(), &alarms_, sensor_faulty});
    }

    EngineInputs inputs_{.setpoint = 72.727};
    Engine engine_;
    EngineAlarms alarms_;
    bool raised_ = false;
    double highest_ = 0;
};

TEST_F(GuardedEngine, raises_nothing_when_it_starts_changes_speed_and_load_and_warms_up) {
    for (const double load : {0.0, 60.0, 100.0}) {
        for (const double setpoint : {0.0, 100.0, 40.0}) {
            inputs_.load = load;
            inputs_.setpoint = setpoint;
            run_for(60);
            engine_.report(EngineFault::load_rejection, true);
            run_for(5);
            engine_.report(EngineFault::load_rejection, false);
        }
    }
    inputs_.idle_requested = true;
    run_for(600);
    EXPECT_FALSE(raised_) << raised();
    EXPECT_GT(highest_, maximum_speed);  // thrown-off load makes it swing
}

TEST_F(GuardedEngine, loses_its_oil_is_warned_of_and_stopped) {
    run_for(10);
    engine_.report(EngineFault::oil_leak, true);
    run_for(14);
    EXPECT_EQ(raised(), "low-oil-pressure");
    EXPECT_EQ(word(), 0x20 | 0x80 | 0x04 | 0x08 | 0x10);
    run_for(10);
    EXPECT_EQ(raised(), "lost-oil-pressure") << "the warning is for a running engine";
    run_for(20);
    EXPECT_EQ(word(), 0x01 | 0x20 | 0x40 | 0x80);
    EXPECT_EQ(engine_text(engine_.state()), "stands");
}

TEST_F(GuardedEngine, starts_again_after_a_stop_is_lifted_and_stops_again_while_the_leak_is_there) {
    run_for(10);
    engine_.report(EngineFault::oil_leak, true);
    run_for(60);
    alarms_.clear(engine_.state());
    run_for(2.5);
    EXPECT_EQ(raised(), "");
    EXPECT_TRUE(engine_.state().running());
    run_for(20);
    EXPECT_TRUE(alarms_.emergency_stop());
    engine_.report(EngineFault::oil_leak, false);
    run_for(20);
    alarms_.clear(engine_.state());
    run_for(60);
    EXPECT_EQ(raised(), "");
    EXPECT_TRUE(engine_.state().at_setpoint());
}

TEST_F(GuardedEngine, gets_hot_without_cooling_and_may_run_again_once_it_is_cool) {
    run_for(120);
    engine_.report(EngineFault::cooling_failure, true);
    run_for(30);
    EXPECT_EQ(raised(), "hot-coolant");
    engine_.report(EngineFault::cooling_failure, false);
    run_for(60);
    EXPECT_EQ(raised(), "");
    engine_.report(EngineFault::cooling_failure, true);
    run_for(50);
    EXPECT_TRUE(alarms_.emergency_stop());
    engine_.report(EngineFault::cooling_failure, false);
    run_for(60);
    EXPECT_EQ(raised(), "overheated-coolant");
    alarms_.clear(engine_.state());
    EXPECT_EQ(raised(), "");
}

TEST_F(GuardedEngine, gets_hot_charge_air_under_load_only) {
    inputs_.load = 0;
    engine_.report(EngineFault::charge_air_cooler, true);
    run_for(120);
    EXPECT_EQ(raised(), "");
    inputs_.load = 80;
    run_for(60);
    EXPECT_EQ(raised(), "hot-charge-air");
    EXPECT_FALSE(alarms_.emergency_stop());
    inputs_.load = 0;
    run_for(60);
    EXPECT_EQ(raised(), "");
}

TEST_F(GuardedEngine, runs_away_with_a_stuck_actuator_when_its_load_is_thrown_off_and_is_stopped) {
    run_for(10);
    engine_.report(EngineFault::actuator_stuck, true);
    run_for(10);
    EXPECT_FALSE(raised_) << "nothing changes";
    EXPECT_NEAR(engine_.state().speed, rated_speed, 20);
    engine_.report(EngineFault::load_rejection, true);
    run_for(3);
    EXPECT_EQ(raised(), "overspeed");
    EXPECT_EQ(engine_text(engine_.state()), "runs down");
    EXPECT_LT(highest_, 1.25 * maximum_speed);
    EXPECT_EQ(word() & 0x47, 0x40) << "neither running nor starting";
    run_for(20);
    EXPECT_TRUE(engine_.state().standing());
    EXPECT_EQ(word(), 0x01 | 0x20 | 0x40 | 0x80);
}

TEST_F(GuardedEngine, runs_when_it_is_dragged_down_and_starts_only_from_standstill_or_a_stop) {
    run_for(0.3);
    EXPECT_EQ(engine_text(engine_.state()), "starts");
    EXPECT_EQ(word() & 0x07, 0x02);
    inputs_.idle_requested = true;
    run_for(10);
    EXPECT_EQ(word() & 0x07, 0x04);
    engine_.report(EngineFault::actuator_stuck, true);
    inputs_.idle_requested = false;
    for (int cycles = 0; engine_.state().up_to_speed(); ++cycles) {
        ASSERT_LT(cycles, 100) << "more load than the fuel it has, but it does not get slower";
        run_for(0.01);
    }
    EXPECT_EQ(engine_text(engine_.state()), "runs");
    EXPECT_EQ(word() & 0x07, 0x04);
}

TEST_F(GuardedEngine, alarm_bit_shows_faulty_sensors_as_well) {
    EXPECT_EQ(word(), 0x01);
    EXPECT_EQ(word(true), 0x81);
}

}  // namespace
}  // namespace cgw::simulation
