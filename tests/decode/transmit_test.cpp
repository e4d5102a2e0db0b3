// What a bus monitor with our database shows, against what the simulated governor measures at that instant.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "running_plant.hpp"

namespace cgw::test {
namespace {

using simulation::EngineState;

// Which quantity of the engine a measurement shows. A percentage is one of the measurement's range, whatever
// its unit.
struct Quantity {
    std::uint16_t number;
    double (*value)(const EngineState&);
    bool percentage;
};

constexpr std::array quantities{
    Quantity{2000, [](const EngineState& e) { return e.speed; }, false},
    Quantity{2031, [](const EngineState& e) { return e.speed_setpoint; }, false},
    Quantity{2300, [](const EngineState& e) { return e.position; }, true},
    Quantity{2330, [](const EngineState& e) { return e.position_setpoint; }, true},
    Quantity{2904, [](const EngineState& e) { return e.boost_pressure; }, false},
    Quantity{2905, [](const EngineState& e) { return e.oil_pressure; }, false},
    Quantity{2906, [](const EngineState& e) { return e.ambient; }, false},
    Quantity{2907, [](const EngineState& e) { return e.coolant_temperature; }, false},
    Quantity{2908, [](const EngineState& e) { return e.charge_air_temperature; }, false},
    Quantity{2909, [](const EngineState& e) { return e.oil_temperature; }, false},
    Quantity{2911, [](const EngineState& e) { return e.exhaust_temperature; }, false},
    Quantity{2916, [](const EngineState& e) { return e.coolant_pressure; }, false},
    Quantity{2917, [](const EngineState& e) { return e.load; }, true},
    Quantity{2918, [](const EngineState& e) { return e.power; }, true},
};

const Quantity* quantity_of(std::uint16_t number) {
    const auto* const found = std::find_if(quantities.begin(), quantities.end(),
                                           [number](const Quantity& row) { return row.number == number; });
    return found != quantities.end() ? found : nullptr;
}

// Compares every measurement of every transmit PDO as it passes.
class Monitor {
  public:
    explicit Monitor(RunningPlant& running) : running_(&running) {
        running.plant().can2().observe([this](const frame::Frame& frame, Time) { look_at(frame); });
    }

    unsigned compared() const { return compared_; }
    unsigned raw_only() const { return raw_only_; }

  private:
    void look_at(const frame::Frame& frame) {
        for (const config::Pdo& pdo : running_->configuration().pdos) {
            if (!pdo.active || pdo.direction != config::Direction::transmit || pdo.cob_id != frame.id) {
                continue;
            }
            const DbcMessage& message = running_->message(pdo);
            ASSERT_EQ(message.id, frame.id);
            ASSERT_EQ(message.length, frame.length);
            for (std::size_t i = 0; i < pdo.mapping.size(); ++i) {
                compare(pdo.mapping[i], message.at(static_cast<unsigned>(16 * i)), frame);
            }
        }
    }

    void compare(const config::MappedWord& word, const DbcSignal& signal, const frame::Frame& frame) {
        const Quantity* const quantity =
            word.parameter != nullptr ? quantity_of(word.parameter->number) : nullptr;
        if (quantity == nullptr) {
            return;
        }
        const double shown = signal.decode(frame);
        double measured = quantity->value(running_->governor().engine().state());
        if (quantity->percentage) {
            measured = signal.minimum + measured / 100 * (signal.maximum - signal.minimum);
        } else if (signal.unit.empty()) {
            ++raw_only_;  // the file does not tell what the word means, and neither may the database
            EXPECT_EQ(signal.factor, 1);
            return;
        }
        measured = std::clamp(measured, signal.minimum, signal.maximum);
        EXPECT_NEAR(shown, measured, std::abs(signal.factor) * 0.5 + 1e-9 * std::abs(measured))
            << word.parameter->number << " in frame " << frame.id;
        ++compared_;
    }

    RunningPlant* running_;
    unsigned compared_ = 0;
    unsigned raw_only_ = 0;
};

}  // namespace

TEST(DecodedTransmitPdos, show_what_the_governor_of_the_genset_measures) {
    RunningPlant running(CGW_SAMPLES "/genset.toml");
    Monitor monitor(running);
    running.start_alone();
    running.run_for(20 * second);  // start, run-up, load
    EXPECT_GT(running.governor().engine().state().speed, 1000);
    EXPECT_GT(monitor.compared(), 20U * (8 * 4 + 2 * 4 + 4) * 9 / 10);
    EXPECT_EQ(monitor.raw_only(), 0U);
}

TEST(DecodedTransmitPdos, show_what_the_governor_of_the_manuals_example_measures) {
    RunningPlant running(CGW_SAMPLES "/manual-example.toml");
    Monitor monitor(running);
    running.start();
    running.run_for(10 * second);
    EXPECT_GT(monitor.compared(), 10U * 64 * 4 * 9 / 10);
    EXPECT_GT(monitor.raw_only(), 0U);  // 2905: 980 and 981 are not set
}

TEST(DecodedTransmitPdos, show_which_errors_are_present) {
    RunningPlant running(CGW_SAMPLES "/genset.toml");
    const config::Configuration& configuration = running.configuration();
    for (const int number : {1, 2}) {
        running.node().master().subscribe(configuration.tpdo(number).cob_id);
    }
    running.start_alone();
    running.run_for(2 * second);
    constexpr unsigned first_sensor_bit = 5;  // error of sensor 900 in the simulated governor
    unsigned present = 0;
    for (unsigned bit = 0; bit < 96; ++bit) {
        const config::Pdo& pdo = configuration.tpdo(bit < 64 ? 1 : 2);
        const auto received = running.node().received(pdo.cob_id);
        ASSERT_TRUE(received);
        const auto sensor =
            running.governor().inputs().sensor(static_cast<std::uint16_t>(900 + bit - first_sensor_bit));
        const bool faulty = bit >= first_sensor_bit && sensor.carried && sensor.faulty;
        const bool canopen_error = bit == 74;  // 3074: RPDOs and heartbeat are late
        EXPECT_EQ(running.message(pdo).at(bit % 64).decode(received->last), faulty || canopen_error ? 1 : 0)
            << 3000 + bit;
        present += faulty ? 1 : 0;
    }
    EXPECT_EQ(present, configuration.sensors.size());  // no receive PDO came yet
}

TEST(DecodedTransmitPdos, show_the_engine_state) {
    RunningPlant running(CGW_SAMPLES "/genset.toml");
    const config::Pdo& pdo = running.configuration().tpdo(3);
    running.node().master().subscribe(pdo.cob_id);
    running.start_alone();
    running.run_for(15 * second);
    const auto received = running.node().received(pdo.cob_id);
    ASSERT_TRUE(received);
    const DbcMessage& message = running.message(pdo);
    EXPECT_EQ(message.signals.at("EngineState_Bit1").decode(received->last), 0);  // standing
    EXPECT_EQ(message.signals.at("EngineState_Bit3").decode(received->last), 1);  // running
    EXPECT_EQ(message.signals.at("EngineState_Bit8").decode(received->last), 1);  // alarm: sensors missing
}

TEST(DecodedHeartbeat, shows_the_state_of_the_node) {
    RunningPlant running(CGW_SAMPLES "/genset.toml");
    const DbcMessage& message = running.message("GW12_Heartbeat");
    std::vector<std::string> states;
    running.plant().can2().observe([&](const frame::Frame& frame, Time) {
        if (frame.id == message.id) {
            const DbcSignal& state = message.signals.at("State");
            states.push_back(state.values.at(static_cast<unsigned>(state.decode(frame))));
        }
    });
    running.start();
    running.run_for(2 * second);
    ASSERT_GE(states.size(), 3U);
    EXPECT_EQ(states.front(), "boot-up");
    EXPECT_EQ(states[1], "Pre-Operational");
    EXPECT_EQ(states.back(), "Operational");
}

}  // namespace cgw::test
