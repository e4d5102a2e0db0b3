#include "simulation/scaling.hpp"

#include <algorithm>
#include <cmath>

namespace cgw::simulation {
namespace {

bool find_scaled_label(const image::Image& image, std::uint16_t number, image::Label& label) {
    if (image.find_label(number, label) && label.has_scaling) {
        return true;
    }
    return facts::is_sensor(number) && image.find_label(facts::measurement_of(number), label) &&
           label.has_scaling;
}

}  // namespace

double Scale::to_engineering(std::uint16_t word) const {
    const double raw = is_signed ? static_cast<std::int16_t>(word) : static_cast<double>(word);
    const double internal_span = static_cast<double>(internal_maximum) - internal_minimum;
    if (internal_span == 0) {
        return external_minimum;
    }
    return external_minimum +
           (raw - internal_minimum) / internal_span * (external_maximum - external_minimum);
}

std::uint16_t Scale::to_word(double engineering) const {
    const double external_span = external_maximum - external_minimum;
    const double part = external_span == 0 ? 0 : (engineering - external_minimum) / external_span;
    const double internal_span = static_cast<double>(internal_maximum) - internal_minimum;
    const double raw = internal_minimum + std::clamp(part, 0.0, 1.0) * internal_span;
    return static_cast<std::uint16_t>(static_cast<std::int32_t>(std::lround(raw)));
}

Scale scale_of(const image::Image& image, std::uint16_t number, double external_minimum,
               double external_maximum) {
    Scale scale;
    scale.external_minimum = external_minimum;
    scale.external_maximum = external_maximum;
    image::Signal signal;
    if (image.find_signal(number, signal)) {
        scale.internal_minimum = signal.internal_minimum;
        scale.internal_maximum = signal.internal_maximum;
        scale.is_signed = signal.is_signed;
    }
    image::Label label;
    if (find_scaled_label(image, number, label)) {
        scale.external_minimum = label.external_minimum;
        scale.external_maximum = label.external_maximum;
    }
    return scale;
}

bool has_scaling(const image::Image& image, std::uint16_t number) {
    image::Label label;
    return find_scaled_label(image, number, label);
}

}  // namespace cgw::simulation
