#include "simulation/governor.hpp"

#include "simulation/engine_state_word.hpp"
#include "simulation/readings.hpp"
#include "simulation/scaling.hpp"

namespace cgw::simulation {
namespace {

constexpr std::uint16_t idle_switch = 811;
constexpr std::uint16_t setpoint_2_switch = 827;
constexpr std::uint16_t load_enable_switch = 835;
constexpr std::uint16_t setpoint_1_sensor = 900;
constexpr std::uint16_t setpoint_2_sensor = 901;
constexpr std::uint16_t ambient_sensor = 906;
constexpr std::uint16_t load_sensor = 917;

// What counts while no valid sensor value is there.
constexpr double setpoint_1_substitute = 72.727;  // %: rated speed
constexpr double setpoint_2_substitute = 50;
constexpr double load_substitute = 60;
constexpr double ambient_substitute = 1013;

constexpr std::uint16_t first_sensor = 900;
// Sensor errors are reported from 3005 on (manual 9.6); here sensor 900 + k is error 3005 + k, bit 5 + k.
constexpr unsigned first_sensor_error_bit = 5;
constexpr unsigned bits_per_word = 16;

}  // namespace

SimulatedGovernor::SimulatedGovernor(Bus& can1, const image::Image& image)
    : image_(&image),
      link_(can1.attach(*this), *this),
      inputs_(image),
      cycle_(image.governor().main_cycle_us) {
    link_.open(image, boot_);
}

void SimulatedGovernor::reset() {
    link_.open(*image_, ++boot_);
    inputs_.follow({});
}

void SimulatedGovernor::clear_errors() {
    link_.clear_errors();
    errors_cleared();
}

Time SimulatedGovernor::poll(Time now) {
    if (now < next_cycle_) {
        link_.poll();
        return next_cycle_;
    }
    next_cycle_ += cycle_;
    ++main_cycles_;
    run_engine();
    device::GovernorData delivered = data();
    if (amend_) {
        amend_(delivered);
    }
    errors_ = delivered.errors;
    link_.main_cycle(delivered, cycle_flags(), now);
    return next_cycle_;
}

void SimulatedGovernor::process_data(std::uint8_t rpdo, const device::PdoWords& words) {
    inputs_.receive(rpdo, words);
    if (received_) {
        received_(rpdo, words);
    }
}

void SimulatedGovernor::run_engine() {
    EngineInputs engine;
    engine.idle_requested = inputs_.switch_function(idle_switch).value_or(false);
    engine.load_enabled = inputs_.switch_function(load_enable_switch).value_or(true);
    const bool second = inputs_.switch_function(setpoint_2_switch).value_or(false);
    engine.setpoint = second ? percentage(setpoint_2_sensor, setpoint_2_substitute)
                             : percentage(setpoint_1_sensor, setpoint_1_substitute);
    engine.load = percentage(load_sensor, load_substitute);
    engine.ambient = ambient_substitute;
    const CanopenInputs::SensorValue ambient = inputs_.sensor(ambient_sensor);
    if (ambient.usable()) {
        engine.ambient = scale_of(*image_, ambient_sensor, 0, 2000).to_engineering(ambient.word);
    }
    engine.emergency_stop = alarms_.emergency_stop();
    engine_.advance(static_cast<double>(cycle_) / 1e6, engine);
    alarms_.follow(engine_.state(), cycle_);
}

std::uint8_t SimulatedGovernor::cycle_flags() const {
    return static_cast<std::uint8_t>((can_bus_error_ ? link::cycle::can_bus_error : 0) |
                                     (can_comm_error_ ? link::cycle::can_comm_error : 0));
}

// A sensor's value as a percentage of its range, whatever its unit.
double SimulatedGovernor::percentage(std::uint16_t sensor_number, double substitute) const {
    const CanopenInputs::SensorValue sensor = inputs_.sensor(sensor_number);
    if (!sensor.usable()) {
        return substitute;
    }
    Scale scale = scale_of(*image_, sensor_number, 0, 100);
    scale.external_minimum = 0;
    scale.external_maximum = 100;
    return scale.to_engineering(sensor.word);
}

device::GovernorData SimulatedGovernor::data() const {
    device::GovernorData data;
    fill_analogue(data);
    bool sensor_faulty = false;
    for (std::size_t i = 0; i < image_->sensor_count(); ++i) {
        const std::uint16_t number = image_->sensor(i).number;
        if (inputs_.sensor(number).faulty) {
            const unsigned bit = first_sensor_error_bit + number - first_sensor;
            data.errors[bit / bits_per_word] =
                static_cast<std::uint16_t>(data.errors[bit / bits_per_word] | (1U << (bit % bits_per_word)));
            sensor_faulty = true;
        }
    }
    data.engine_state = engine_state_word({&engine_.state(), &alarms_, sensor_faulty});
    return data;
}

void SimulatedGovernor::fill_analogue(device::GovernorData& data) const {
    const double seconds = static_cast<double>(main_cycles_ * cycle_) / 1e6;
    for (std::size_t i = 0; i < device::analogue_tpdos; ++i) {
        const image::Pdo pdo = image_->pdo(device::first_analogue_tpdo - 1 + i);
        for (std::size_t word = 0; word < pdo.word_count; ++word) {
            data.analogue[i][word] =
                reading(*image_, pdo.mapping[word].parameter, engine_.state(), inputs_, seconds);
        }
    }
}

}  // namespace cgw::simulation
