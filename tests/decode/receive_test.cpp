// Receive PDOs encoded with our database arrive in the governor as the switches and sensors they mean.
#include <gtest/gtest.h>

#include <cmath>

#include "config/numbers.hpp"
#include "running_plant.hpp"
#include "simulation/scaling.hpp"

namespace cgw::test {
namespace {

class EncodedReceivePdos : public testing::TestWithParam<std::string> {
  protected:
    EncodedReceivePdos() : running(std::string(CGW_SAMPLES "/") + GetParam() + ".toml") { running.start(); }

    const config::Configuration& configuration() const { return running.configuration(); }

    // The signal of a sensor's channel and its message.
    std::pair<const DbcMessage*, const DbcSignal*> sensor_signal(const config::Sensor& sensor) const {
        const int channel = sensor.channel - 1;
        const DbcMessage& message = running.message(configuration().rpdo(2 + channel / 4));
        return {&message, &message.at(static_cast<unsigned>(16 * (channel % 4)))};
    }

    void send_sensor(const config::Sensor& sensor, double physical) {
        const auto [message, signal] = sensor_signal(sensor);
        frame::Frame frame;
        signal->encode(physical, frame);
        running.send(*message, frame);
        running.run_for(second / 20);
    }

    RunningPlant running;
};

// Physical value at a part of the signal's range.
double at(const DbcSignal& signal, double part) {
    return signal.minimum + part * (signal.maximum - signal.minimum);
}

// The value of a VAL_ table that reads "on".
unsigned value_named(const DbcSignal& signal, const std::string& text) {
    for (const auto& [value, name] : signal.values) {
        if (name == text) {
            return value;
        }
    }
    ADD_FAILURE() << "no value is named " << text;
    return 0;
}

}  // namespace

TEST_P(EncodedReceivePdos, bring_every_sensor_to_the_governor) {
    for (const config::Sensor& sensor : configuration().sensors) {
        const DbcSignal& signal = *sensor_signal(sensor).second;
        for (const double part : {0.0, 0.37, 1.0}) {
            send_sensor(sensor, at(signal, part));
            const auto input = running.governor().inputs().sensor(sensor.row->number);
            EXPECT_TRUE(input.carried);
            EXPECT_FALSE(input.faulty) << sensor.row->number;
            EXPECT_NEAR(input.word, part * 65535, 0.5) << sensor.row->number;
            if (simulation::has_scaling(running.image(), sensor.row->number)) {
                const double governor = simulation::scale_of(running.image(), sensor.row->number, 0, 0)
                                            .to_engineering(input.word);
                EXPECT_NEAR(governor, at(signal, part), std::abs(signal.factor)) << sensor.row->number;
            }
        }
    }
}

TEST_P(EncodedReceivePdos, come_back_in_the_measurement_that_shows_the_sensor) {
    unsigned compared = 0;
    for (const config::Sensor& sensor : configuration().sensors) {
        for (const config::AnalogueOutput& output : configuration().analogue_outputs) {
            if (output.parameter->number != sensor.row->number + 2000) {
                continue;
            }
            const config::Pdo& pdo = configuration().tpdo(output.tpdo);
            running.node().master().subscribe(pdo.cob_id);
            const double sent = at(*sensor_signal(sensor).second, 0.37);
            send_sensor(sensor, sent);
            running.run_for(pdo.time.effective_us);
            const auto received = running.node().received(pdo.cob_id);
            ASSERT_TRUE(received);
            const DbcSignal& shown = running.message(pdo).at(16U * (output.word - 1U));
            EXPECT_NEAR(shown.decode(received->last), sent, std::abs(shown.factor))
                << output.parameter->number;
            ++compared;
        }
    }
    EXPECT_GT(compared, 0U);
}

TEST_P(EncodedReceivePdos, switch_every_function_on_and_off) {
    const DbcMessage& message = running.message(configuration().rpdo(1));
    for (const config::SwitchFunction& function : configuration().switches) {
        const DbcSignal& signal = message.at(function.bit - 1U);
        for (const std::string text : {"on", "off", "on"}) {
            frame::Frame frame;
            signal.encode(value_named(signal, text), frame);
            running.send(message, frame);
            running.run_for(second / 50);
            EXPECT_EQ(running.governor().inputs().switch_function(function.row->number), text == "on")
                << function.row->number << ' ' << text;
        }
    }
}

TEST_P(EncodedReceivePdos, flag_every_sensor_as_faulty) {
    const DbcMessage& flags = running.message(configuration().rpdo(1));
    for (const config::Sensor& sensor : configuration().sensors) {
        send_sensor(sensor, at(*sensor_signal(sensor).second, 0.5));
        for (const bool faulty : {true, false}) {
            frame::Frame frame;
            flags.at(32U + sensor.channel - 1U).encode(faulty ? 1 : 0, frame);
            running.send(flags, frame);
            running.run_for(second / 50);
            EXPECT_EQ(running.governor().inputs().sensor(sensor.row->number).faulty, faulty)
                << sensor.row->number;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Samples, EncodedReceivePdos, testing::Values("genset", "manual-example"),
                         [](const auto& instance) {
                             return instance.param == "genset" ? std::string("genset")
                                                               : std::string("manual_example");
                         });

}  // namespace cgw::test
