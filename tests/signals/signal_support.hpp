// The frames of configurations made by hand.
#pragma once

#include <string>
#include <vector>

#include "parameter/settings.hpp"
#include "signals/frames.hpp"
#include "support/sample_configuration.hpp"

namespace cgw::test {

inline std::vector<signals::Frame> frames_of(const config::Configuration& configuration) {
    const parameter::Catalogue catalogue{{}};
    return signals::frames_of(parameter::Settings{}, catalogue, configuration);
}

inline const signals::Frame& frame_named(const std::vector<signals::Frame>& frames, std::string_view name) {
    for (const signals::Frame& frame : frames) {
        if (frame.name == name) {
            return frame;
        }
    }
    static const signals::Frame none;
    return none;
}

inline parameter::Row scaled_row(std::uint16_t number, std::string_view name, double low, double high,
                                 std::int32_t internal_low = 0, std::int32_t internal_high = 65535) {
    parameter::Row row = make_row(number, name, internal_low < 0);
    row.scaling = parameter::Scaling{.internal_minimum = internal_low,
                                     .internal_maximum = internal_high,
                                     .external_minimum = low,
                                     .external_maximum = high};
    return row;
}

// The signal of TPDO4 that shows this row alone.
inline signals::Signal signal_of(const parameter::Row& row) {
    config::Configuration configuration = empty_configuration();
    add_output(configuration, 4, row);
    return frames_of(configuration).front().signals.front();
}

}  // namespace cgw::test
