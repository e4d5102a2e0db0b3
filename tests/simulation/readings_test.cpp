#include "simulation/readings.hpp"

#include <set>

#include "simulation/scaling.hpp"
#include "support/sample_plant.hpp"

namespace cgw::simulation {
namespace {

class Readings : public testing::Test {
  protected:
    Readings() { EXPECT_EQ(image::Image::open(bytes_, image_), image::Status::ok); }
    std::uint16_t read(std::uint16_t number, double seconds = 0) {
        return reading(image_, number, engine_, inputs_, seconds);
    }

    test::SamplePlant plant_;
    base::Bytes bytes_ = plant_.image();
    image::Image image_;
    CanopenInputs inputs_{image_};
    EngineState engine_;
};

TEST_F(Readings, shows_the_speed_in_the_internal_range) {
    engine_.speed = 1500;
    EXPECT_EQ(read(2000), 24000U);  // 0..4000 1/min is 0..64000
}

TEST_F(Readings, shows_a_relative_quantity_as_part_of_any_range) {
    engine_.position = 100;
    EXPECT_EQ(read(2300), 32767U);  // signed, without scaling
    engine_.position = 0;
    EXPECT_EQ(read(2300), 0x8000U);
}

TEST_F(Readings, never_shows_a_number_without_a_model_as_zero_and_keeps_it_moving) {
    std::set<std::uint16_t> seen;
    for (int i = 0; i < 80; ++i) {
        const std::uint16_t word = read(2101, 0.1 * i);
        EXPECT_GE(word, 65535 / 4);
        EXPECT_LE(word, 65535 * 3 / 4 + 1);
        seen.insert(word);
    }
    EXPECT_GT(seen.size(), 20U);
    EXPECT_NE(read(2101, 1), read(2102, 1));
}

TEST_F(Readings, keeps_eight_bit_signals_in_their_range) {
    for (int i = 0; i < 80; ++i) {
        const auto value = static_cast<std::int16_t>(read(2201, 0.1 * i));
        EXPECT_GE(value, -128);
        EXPECT_LE(value, 127);
    }
}

TEST_F(Readings, shows_a_received_sensor_in_its_measurement) {
    const std::uint16_t own = read(2906);
    EXPECT_NEAR(own, 1013.0 / 2000 * 65535, 1);
    device::GatewayStatus status;
    status.state = device::GatewayState::operational;
    inputs_.follow(status);
    inputs_.receive(3, {0, 0, 0x7000, 0});
    EXPECT_EQ(read(2906), 0x7000U);
    inputs_.receive(1, {0, 0, 1U << 6, 0});  // flagged faulty: the substitute again
    EXPECT_EQ(read(2906), own);
}

EngineInputs running(double setpoint) {
    EngineInputs inputs;
    inputs.setpoint = setpoint;
    return inputs;
}

TEST(Engine, runs_up_to_its_setpoint_and_takes_load) {
    Engine engine;
    EXPECT_TRUE(engine.state().standing());
    engine.advance(0.4, running(72.727));
    EXPECT_FALSE(engine.state().standing());
    EXPECT_LT(engine.state().speed, 700);
    engine.advance(5, running(72.727));
    EXPECT_NEAR(engine.state().speed, 1500, 1);
    EXPECT_TRUE(engine.state().at_setpoint());
    EXPECT_NEAR(engine.state().load, 60, 0.1);
    EXPECT_GT(engine.state().oil_pressure, 3);
    EXPECT_GT(engine.state().position, 20);
}

TEST(Engine, drops_to_idle_and_off_load_when_idle_is_requested) {
    Engine engine;
    engine.advance(5, running(72.727));
    EngineInputs idle = running(72.727);
    idle.idle_requested = true;
    engine.advance(5, idle);
    EXPECT_NEAR(engine.state().speed, idle_speed, 1);
    EXPECT_NEAR(engine.state().load, 0, 0.1);
}

TEST(Engine, sheds_its_load_when_load_is_not_enabled) {
    Engine engine;
    engine.advance(5, running(72.727));
    EngineInputs unloaded = running(72.727);
    unloaded.load_enabled = false;
    engine.advance(5, unloaded);
    EXPECT_NEAR(engine.state().load, 0, 0.1);
    EXPECT_NEAR(engine.state().speed, 1500, 1);
}

TEST(Engine, survives_very_long_and_very_short_cycles) {
    Engine engine;
    engine.advance(4294, running(50));
    EXPECT_NEAR(engine.state().speed, 1250, 1);
    engine.advance(1e-6, running(50));
    EXPECT_NEAR(engine.state().speed, 1250, 1);
}

}  // namespace
}  // namespace cgw::simulation
