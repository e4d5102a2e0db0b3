// Inside the signals room: the signals of one mapped word. Names are not unique yet.
#pragma once

#include <string_view>

#include "signals/frames.hpp"

namespace cgw::signals {

struct Origin {
    const parameter::Settings& settings;
    const parameter::Catalogue& catalogue;
    const config::Configuration& configuration;
};

// `first_bit` is that of the word in its frame.
struct PlacedWord {
    const config::MappedWord& word;
    unsigned first_bit = 0;
};

Signal bit_signal(Kind kind, const PlacedWord& placed, unsigned bit);
Source source_of(const parameter::Row& row);

// "AssignIn_Setp1Ext", "Sensor_907"
std::string sensor_name(const parameter::Row& row, std::string_view ending = {});
std::vector<Source> sensors_of(const config::Configuration& configuration, std::uint8_t channel);

// "900 AssignIn_Setp1Ext, 901 …"
std::string labels_of(const std::vector<Source>& sources);

std::vector<Signal> error_signals(const Origin& origin, const PlacedWord& placed);
std::vector<Signal> engine_state_signals(const PlacedWord& placed);
std::vector<Signal> switch_signals(const Origin& origin, const PlacedWord& placed);
std::vector<Signal> sensor_flag_signals(const Origin& origin, const PlacedWord& placed);
Signal measurement_signal(const Origin& origin, const PlacedWord& placed);
Signal sensor_signal(const Origin& origin, const PlacedWord& placed);

}  // namespace cgw::signals
