#include "simulation/readings.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "simulation/scaling.hpp"

namespace cgw::simulation {
namespace {

constexpr double generic_period = 8;  // seconds

// The external range stands in where the image carries no scaling. A relative quantity is a percentage of the
// range, whatever its unit.
struct Model {
    std::uint16_t number;
    double (*value)(const EngineState&);
    double external_minimum;
    double external_maximum;
    bool relative;
};

constexpr std::array models = {
    Model{2000, [](const EngineState& e) { return e.speed; }, 0, 4000, false},
    Model{2031, [](const EngineState& e) { return e.speed_setpoint; }, 0, 4000, false},
    Model{2300, [](const EngineState& e) { return e.position; }, 0, 100, true},
    Model{2330, [](const EngineState& e) { return e.position_setpoint; }, 0, 100, true},
    Model{2350, [](const EngineState& e) { return e.position; }, 0, 100, true},
    Model{2900, [](const EngineState&) { return 72.7; }, 0, 100, true},
    Model{2901, [](const EngineState&) { return 50.0; }, 0, 100, true},
    Model{2902, [](const EngineState& e) { return e.load; }, 0, 100, true},
    Model{2903, [](const EngineState&) { return 50.0; }, 0, 100, true},
    Model{2904, [](const EngineState& e) { return e.boost_pressure; }, 0, 5, false},
    Model{2905, [](const EngineState& e) { return e.oil_pressure; }, 0, 20, false},
    Model{2906, [](const EngineState& e) { return e.ambient; }, 0, 2000, false},
    Model{2907, [](const EngineState& e) { return e.coolant_temperature; }, -100, 1000, false},
    Model{2908, [](const EngineState& e) { return e.charge_air_temperature; }, -100, 1000, false},
    Model{2909, [](const EngineState& e) { return e.oil_temperature; }, -100, 1000, false},
    Model{2910, [](const EngineState& e) { return e.fuel_temperature; }, -100, 1000, false},
    Model{2911, [](const EngineState& e) { return e.exhaust_temperature; }, -100, 1000, false},
    Model{2914, [](const EngineState&) { return 0.0; }, 0, 100, true},
    Model{2915, [](const EngineState&) { return 0.0; }, 0, 100, true},
    Model{2916, [](const EngineState& e) { return e.coolant_pressure; }, 0, 5, false},
    Model{2917, [](const EngineState& e) { return e.load; }, 0, 100, true},
    Model{2918, [](const EngineState& e) { return e.power; }, 0, 100, true},
    Model{2919, [](const EngineState& e) { return e.load; }, 0, 100, true},
};

// 0..1 and back, once per period.
double swing(double seconds, std::uint16_t number) {
    const double phase = seconds / generic_period + number * 0.137;
    return std::abs(2 * (phase - std::floor(phase)) - 1);
}

// The model of measurement `measured`, in the scale of parameter `scaled`.
std::uint16_t model_word(const image::Image& image, std::uint16_t measured, std::uint16_t scaled,
                         const EngineState& engine, double seconds) {
    const auto* const model = std::find_if(models.begin(), models.end(),
                                           [measured](const Model& row) { return row.number == measured; });
    const bool modelled = model != models.end();
    const double minimum = modelled ? model->external_minimum : 0;
    const double maximum = modelled ? model->external_maximum : 100;
    Scale scale = scale_of(image, scaled, minimum, maximum);
    if (!modelled || model->relative) {
        scale.external_minimum = minimum;
        scale.external_maximum = maximum;
    }
    return scale.to_word(modelled ? model->value(engine) : 25 + 50 * swing(seconds, measured));
}

}  // namespace

std::uint16_t reading(const image::Image& image, std::uint16_t number, const EngineState& engine,
                      const CanopenInputs& inputs, double seconds) {
    if (number >= sensor_to_measurement) {
        const auto sensor = inputs.sensor(static_cast<std::uint16_t>(number - sensor_to_measurement));
        if (sensor.usable()) {
            return sensor.word;
        }
    }
    return model_word(image, number, number, engine, seconds);
}

std::uint16_t sensor_word(const image::Image& image, std::uint16_t number, const EngineState& engine,
                          double seconds) {
    return model_word(image, facts::measurement_of(number), number, engine, seconds);
}

}  // namespace cgw::simulation
