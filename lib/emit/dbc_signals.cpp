// What the words of a PDO mean, as signals: scaled measurements and sensors, single bits by name.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/canopen_text.hpp"
#include "config/numbers.hpp"
#include "dbc/names.hpp"
#include "dictionary/ascii.hpp"
#include "emit/dbc_parts.hpp"
#include "facts/gateway.hpp"
#include "parameter/settings.hpp"

namespace cgw::emit {
namespace {

using config::WordKind;
using parameter::Device;

constexpr unsigned engine_state_bits = 8;  // D22: the low byte
constexpr std::array<std::string_view, 2> on_off{"off", "on"};

dbc::Signal bit_signal(std::string name, unsigned start_bit, std::string comment) {
    dbc::Signal signal;
    signal.name = std::move(name);
    signal.start_bit = start_bit;
    signal.length = 1;
    signal.maximum = 1;
    signal.comment = std::move(comment);
    return signal;
}

std::string object_text(const config::MappedWord& word) {
    return base::object_text(word.index, word.sub_index);
}

// --- errors and engine state ---

// D58: one bit stands for the error in both devices; the governor's name goes first.
dbc::Signal error_signal(const Plant& plant, const config::MappedWord& word, unsigned bit,
                         unsigned start_bit) {
    const auto number = facts::error_number((word.sub_index - 1U) * config::word_bits + bit);
    std::string name;
    std::string comment = fmt::format("{}, {}", number, object_text(word));
    for (const Device device : {Device::governor, Device::gateway}) {
        const parameter::Row* const row = plant.catalogue.find(device, number);
        if (row != nullptr && !row->name.empty()) {
            name = name.empty() ? std::string(row->name) : name;
            comment += fmt::format("; {} {}", parameter::to_text(device), row->name);
        }
    }
    return bit_signal(name.empty() ? fmt::format("Error_{}", number) : dbc::identifier(name), start_bit,
                      comment + "; 1: the error is present");
}

std::vector<dbc::Signal> error_signals(const Plant& plant, const config::MappedWord& word,
                                       unsigned first_bit) {
    std::vector<dbc::Signal> signals;
    for (unsigned bit = 0; bit < config::word_bits; ++bit) {
        signals.push_back(error_signal(plant, word, bit, first_bit + bit));
    }
    return signals;
}

std::vector<dbc::Signal> engine_state_signals(const config::MappedWord& word, unsigned first_bit) {
    std::vector<dbc::Signal> signals;
    for (unsigned bit = 1; bit <= engine_state_bits; ++bit) {
        signals.push_back(
            bit_signal(fmt::format("EngineState_Bit{}", bit), first_bit + bit - 1,
                       fmt::format("{} bit {}; its meaning depends on the governor and is not printed",
                                   object_text(word), bit)));
    }
    return signals;
}

// --- switch functions and sensor flags ---

std::string switch_text(const config::SwitchFunction& function) {
    return fmt::format("{}, {}", parameter::label(*function.row),
                       function.low_active ? "low-active: 0 is on" : "high-active: 1 is on");
}

// A bit that several functions share is one signal, named after the first; its values are named only where
// all agree.
dbc::Signal switch_signal(const config::MappedWord& word, std::uint8_t bit,
                          const std::vector<config::SwitchFunction>& functions, unsigned start_bit) {
    const config::SwitchFunction& first = functions.front();
    std::string comment = fmt::format("{} bit {}", object_text(word), bit);
    for (const config::SwitchFunction& function : functions) {
        comment += "; " + switch_text(function);
    }
    const std::string name = first.row->name.empty() ? fmt::format("Switch_{}", first.row->number)
                                                     : dbc::identifier(first.row->name);
    dbc::Signal signal = bit_signal(name, start_bit, comment);
    const bool agree = std::all_of(functions.begin(), functions.end(),
                                   [&](const auto& other) { return other.low_active == first.low_active; });
    if (agree) {
        signal.values = {{0, std::string(on_off[first.low_active ? 1 : 0])},
                         {1, std::string(on_off[first.low_active ? 0 : 1])}};
    }
    return signal;
}

std::vector<dbc::Signal> switch_signals(const config::Configuration& configuration,
                                        const config::MappedWord& word, unsigned first_bit) {
    std::vector<dbc::Signal> signals;
    for (std::uint8_t bit = 1; bit <= config::switch_bits; ++bit) {
        std::vector<config::SwitchFunction> functions;
        std::copy_if(configuration.switches.begin(), configuration.switches.end(),
                     std::back_inserter(functions), [bit](const auto& f) { return f.bit == bit; });
        if (!functions.empty()) {
            signals.push_back(switch_signal(word, bit, functions, first_bit + bit - 1));
        }
    }
    return signals;
}

std::string sensor_name(const parameter::Row& row, std::string_view ending = {}) {
    return row.name.empty() ? fmt::format("Sensor_{}{}", row.number, ending)
                            : dbc::identifier(row.name, ending);
}

std::vector<const parameter::Row*> sensors_of(const config::Configuration& configuration,
                                              std::uint8_t channel) {
    std::vector<const parameter::Row*> rows;
    for (const config::Sensor& sensor : configuration.sensors) {
        if (sensor.channel == channel) {
            rows.push_back(sensor.row);
        }
    }
    return rows;
}

std::string labels_of(const std::vector<const parameter::Row*>& rows) {
    std::string text;
    for (const parameter::Row* const row : rows) {
        text += (text.empty() ? "" : ", ") + parameter::label(*row);
    }
    return text;
}

std::vector<dbc::Signal> sensor_flag_signals(const config::Configuration& configuration,
                                             const config::MappedWord& word, unsigned first_bit) {
    std::vector<dbc::Signal> signals;
    for (std::uint8_t channel = 1; channel <= config::sensor_channels; ++channel) {
        const std::vector<const parameter::Row*> rows = sensors_of(configuration, channel);
        if (!rows.empty()) {
            signals.push_back(bit_signal(sensor_name(*rows.front(), "_Error"), first_bit + channel - 1,
                                         fmt::format("{} bit {}, error flag of channel {}: {}; 1: faulty",
                                                     object_text(word), channel, channel, labels_of(rows))));
        }
    }
    return signals;
}

// --- words with a value ---

// Range, factor and unit from the row's limits; the raw number, without a unit, where they are not known.
void scale(dbc::Signal& signal, const parameter::Row& row, const parameter::ParameterSet& references) {
    const std::optional<parameter::ExternalLimits> limits = parameter::external_limits(row, references);
    if (!limits) {
        const unsigned bits = row.width == 0 ? config::word_bits : row.width;
        signal.minimum = row.is_signed ? -std::ldexp(1, static_cast<int>(bits) - 1) : 0;
        signal.maximum = std::ldexp(1, static_cast<int>(row.is_signed ? bits - 1 : bits)) - 1;
        signal.comment += "; raw number, its scaling is not known";
        return;
    }
    const double internal_span =
        static_cast<double>(row.scaling->internal_maximum) - row.scaling->internal_minimum;
    signal.factor = (limits->maximum - limits->minimum) / internal_span;
    signal.offset = limits->minimum - row.scaling->internal_minimum * signal.factor;
    signal.minimum = std::min(limits->minimum, limits->maximum);
    signal.maximum = std::max(limits->minimum, limits->maximum);
    if (dictionary::has_ascii_form(row.unit)) {
        signal.unit = row.unit;
    } else {
        signal.comment += "; scaled, but its unit has no spelling in ASCII and is left out";
    }
}

dbc::Signal measurement_signal(const Plant& plant, const config::MappedWord& word, unsigned first_bit) {
    const parameter::Row& row = *word.parameter;
    dbc::Signal signal;
    signal.name = row.name.empty() ? fmt::format("Parameter_{}", row.number) : dbc::identifier(row.name);
    signal.start_bit = first_bit;
    signal.is_signed = row.is_signed;
    signal.comment = fmt::format("{}, {}", parameter::label(row), object_text(word));
    scale(signal, row, plant.settings.governor);
    return signal;
}

dbc::Signal sensor_signal(const Plant& plant, const config::MappedWord& word, unsigned first_bit) {
    const parameter::Row& scaled = config::scaling_row(*word.parameter, plant.catalogue);
    dbc::Signal signal;
    signal.name = sensor_name(*word.parameter);
    signal.start_bit = first_bit;
    signal.is_signed = scaled.is_signed;
    signal.comment = fmt::format("channel {}, {}: {}", word.sub_index, object_text(word),
                                 labels_of(sensors_of(plant.configuration, word.sub_index)));
    if (&scaled != word.parameter) {
        signal.comment += fmt::format("; shown by {}", parameter::label(scaled));
    }
    scale(signal, scaled, plant.settings.governor);
    return signal;
}

}  // namespace

std::vector<dbc::Signal> dbc_word_signals(const Plant& plant, const config::MappedWord& word,
                                          unsigned first_bit) {
    switch (word.kind) {
        case WordKind::errors:
            return error_signals(plant, word, first_bit);
        case WordKind::engine_state:
            return engine_state_signals(word, first_bit);
        case WordKind::measurement:
            return {measurement_signal(plant, word, first_bit)};
        case WordKind::switches:
            return switch_signals(plant.configuration, word, first_bit);
        case WordKind::sensor_flags:
            return sensor_flag_signals(plant.configuration, word, first_bit);
        case WordKind::sensor:
            return {sensor_signal(plant, word, first_bit)};
        case WordKind::dummy:
            break;
    }
    return {};
}

}  // namespace cgw::emit
