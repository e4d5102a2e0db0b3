// Words whose bits mean something each: errors, engine state, switch functions, error flags of sensors.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "config/numbers.hpp"
#include "dbc/names.hpp"
#include "facts/gateway.hpp"
#include "signals/parts.hpp"

namespace cgw::signals {
namespace {

using parameter::Device;

constexpr unsigned engine_state_bits = 8;  // D22: the low byte
constexpr std::array<std::string_view, 2> on_off{"off", "on"};

// D58: one bit stands for the error in both devices; the governor's name goes first.
Signal error_signal(const Origin& origin, const PlacedWord& placed, unsigned bit) {
    Signal signal = bit_signal(Kind::error, placed, bit);
    signal.number = facts::error_number((placed.word.sub_index - 1U) * config::word_bits + bit);
    signal.name = fmt::format("Error_{}", signal.number);
    for (const Device device : {Device::governor, Device::gateway}) {
        const parameter::Row* const row = origin.catalogue.find(device, signal.number);
        if (row != nullptr && !row->name.empty()) {
            signal.name = signal.sources.empty() ? dbc::identifier(row->name) : signal.name;
            signal.sources.push_back(source_of(*row));
        }
    }
    return signal;
}

// A bit that several functions share is one signal, named after the first; its values are named only where
// all agree.
Signal switch_signal(const PlacedWord& placed, std::uint8_t bit,
                     const std::vector<config::SwitchFunction>& functions) {
    const config::SwitchFunction& first = functions.front();
    Signal signal = bit_signal(Kind::switch_function, placed, bit - 1U);
    signal.number = first.row->number;
    signal.name = first.row->name.empty() ? fmt::format("Switch_{}", first.row->number)
                                          : dbc::identifier(first.row->name);
    for (const config::SwitchFunction& function : functions) {
        signal.sources.push_back(source_of(*function.row));
        signal.sources.back().low_active = function.low_active;
    }
    const bool agree = std::all_of(functions.begin(), functions.end(),
                                   [&](const auto& other) { return other.low_active == first.low_active; });
    if (agree) {
        signal.values = {{0, std::string(on_off[first.low_active ? 1 : 0])},
                         {1, std::string(on_off[first.low_active ? 0 : 1])}};
    }
    return signal;
}

}  // namespace

Signal bit_signal(Kind kind, const PlacedWord& placed, unsigned bit) {
    Signal signal;
    signal.kind = kind;
    signal.first_bit = placed.first_bit + bit;
    signal.width = 1;
    signal.index = placed.word.index;
    signal.sub_index = placed.word.sub_index;
    signal.object_bit = static_cast<std::uint8_t>(bit);
    signal.raw_maximum = 1;
    signal.maximum = 1;
    return signal;
}

std::vector<Signal> error_signals(const Origin& origin, const PlacedWord& placed) {
    std::vector<Signal> signals;
    for (unsigned bit = 0; bit < config::word_bits; ++bit) {
        signals.push_back(error_signal(origin, placed, bit));
    }
    return signals;
}

std::vector<Signal> engine_state_signals(const PlacedWord& placed) {
    std::vector<Signal> signals;
    for (unsigned bit = 0; bit < engine_state_bits; ++bit) {
        signals.push_back(bit_signal(Kind::engine_state, placed, bit));
        signals.back().name = fmt::format("EngineState_Bit{}", bit + 1);
    }
    return signals;
}

std::vector<Signal> switch_signals(const Origin& origin, const PlacedWord& placed) {
    std::vector<Signal> signals;
    for (std::uint8_t bit = 1; bit <= config::switch_bits; ++bit) {
        std::vector<config::SwitchFunction> functions;
        const auto& all = origin.configuration.switches;
        std::copy_if(all.begin(), all.end(), std::back_inserter(functions),
                     [bit](const auto& function) { return function.bit == bit; });
        if (!functions.empty()) {
            signals.push_back(switch_signal(placed, bit, functions));
        }
    }
    return signals;
}

std::vector<Signal> sensor_flag_signals(const Origin& origin, const PlacedWord& placed) {
    std::vector<Signal> signals;
    for (std::uint8_t channel = 1; channel <= config::sensor_channels; ++channel) {
        const auto& all = origin.configuration.sensors;
        const auto first = std::find_if(all.begin(), all.end(),
                                        [channel](const auto& sensor) { return sensor.channel == channel; });
        if (first == all.end()) {
            continue;
        }
        Signal signal = bit_signal(Kind::sensor_flag, placed, channel - 1U);
        signal.number = first->row->number;
        signal.name = sensor_name(*first->row, "_Error");
        signal.channel = channel;
        signal.sources = sensors_of(origin.configuration, channel);
        signals.push_back(std::move(signal));
    }
    return signals;
}

}  // namespace cgw::signals
