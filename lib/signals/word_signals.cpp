// Words with a number: measurements and sensors, scaled by the rows of the catalogue.
#include <fmt/format.h>

#include <algorithm>

#include "dbc/names.hpp"
#include "parameter/settings.hpp"
#include "signals/parts.hpp"

namespace cgw::signals {
namespace {

Signal word_signal(Kind kind, const PlacedWord& placed) {
    Signal signal;
    signal.kind = kind;
    signal.first_bit = placed.first_bit;
    signal.width = config::word_bits;
    signal.index = placed.word.index;
    signal.sub_index = placed.word.sub_index;
    signal.number = placed.word.parameter->number;
    return signal;
}

// Range, factor and unit from the row's limits; the raw number, without a unit, where they are not known.
void scale(Signal& signal, const parameter::Row& row, const parameter::ParameterSet& references) {
    signal.is_signed = row.is_signed;
    const std::optional<parameter::ExternalLimits> limits = parameter::external_limits(row, references);
    if (!limits) {
        const unsigned bits = row.width == 0 ? config::word_bits : row.width;
        signal.raw_minimum = row.is_signed ? -(1 << (bits - 1)) : 0;
        signal.raw_maximum = (1 << (row.is_signed ? bits - 1 : bits)) - 1;
        signal.minimum = signal.raw_minimum;
        signal.maximum = signal.raw_maximum;
        return;
    }
    const parameter::Scaling& scaling = *row.scaling;
    signal.scaled = true;
    signal.raw_minimum = std::min(scaling.internal_minimum, scaling.internal_maximum);
    signal.raw_maximum = std::max(scaling.internal_minimum, scaling.internal_maximum);
    const double internal_span = static_cast<double>(scaling.internal_maximum) - scaling.internal_minimum;
    signal.factor = (limits->maximum - limits->minimum) / internal_span;
    signal.offset = limits->minimum - scaling.internal_minimum * signal.factor;
    signal.minimum = std::min(limits->minimum, limits->maximum);
    signal.maximum = std::max(limits->minimum, limits->maximum);
    signal.unit = row.unit;
}

}  // namespace

Source source_of(const parameter::Row& row) {
    return {.device = row.device, .number = row.number, .name = std::string(row.name)};
}

std::string sensor_name(const parameter::Row& row, std::string_view ending) {
    return row.name.empty() ? fmt::format("Sensor_{}{}", row.number, ending)
                            : dbc::identifier(row.name, ending);
}

std::vector<Source> sensors_of(const config::Configuration& configuration, std::uint8_t channel) {
    std::vector<Source> sources;
    for (const config::Sensor& sensor : configuration.sensors) {
        if (sensor.channel == channel) {
            sources.push_back(source_of(*sensor.row));
        }
    }
    return sources;
}

Signal measurement_signal(const Origin& origin, const PlacedWord& placed) {
    const parameter::Row& row = *placed.word.parameter;
    Signal signal = word_signal(Kind::measurement, placed);
    signal.name = row.name.empty() ? fmt::format("Parameter_{}", row.number) : dbc::identifier(row.name);
    signal.sources = {source_of(row)};
    scale(signal, row, origin.settings.governor);
    return signal;
}

Signal sensor_signal(const Origin& origin, const PlacedWord& placed) {
    const parameter::Row& row = *placed.word.parameter;
    const parameter::Row& scaled = config::scaling_row(row, origin.catalogue);
    Signal signal = word_signal(Kind::sensor, placed);
    signal.name = sensor_name(row);
    signal.channel = placed.word.sub_index;
    signal.sources = sensors_of(origin.configuration, signal.channel);
    if (&scaled != &row) {
        signal.scaled_as = {source_of(scaled)};
    }
    scale(signal, scaled, origin.settings.governor);
    return signal;
}

}  // namespace cgw::signals
