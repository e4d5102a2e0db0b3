// Raw words and engineering units. Only simulation and displays scale; the gateway moves words (D23).
#pragma once

#include <cstdint>

#include "facts/gateway.hpp"
#include "image/image.hpp"

namespace cgw::simulation {

using facts::sensor_to_measurement;

// The linear relation between a word's internal range and engineering units.
struct Scale {
    std::int32_t internal_minimum = 0;
    std::int32_t internal_maximum = 65535;
    double external_minimum = 0;
    double external_maximum = 100;
    bool is_signed = false;

    double to_engineering(std::uint16_t word) const;
    // Values outside the external range stop at its ends.
    std::uint16_t to_word(double engineering) const;
};

// The scale of a parameter: internal range from the image's signal, external range from its label, or the one
// given here where the image has no label or the label no scaling. A sensor 9nn without scaling of its own
// has that of its measurement 29nn.
Scale scale_of(const image::Image& image, std::uint16_t number, double external_minimum,
               double external_maximum);

// False when the image tells no external range for the parameter: scale_of() would use the one given.
bool has_scaling(const image::Image& image, std::uint16_t number);

}  // namespace cgw::simulation
