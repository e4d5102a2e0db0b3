#include "parameter/settings.hpp"

#include <limits>
#include <utility>

namespace cgw::parameter {

namespace {

std::optional<double> limit(std::optional<double> constant, std::uint16_t reference,
                            const ParameterSet& references) {
    return reference == 0 ? constant : references.value(reference);
}

}  // namespace

bool ParameterSet::assign(Assignment assignment) {
    const auto [place, fresh] = assigned_.try_emplace(assignment.row->number);
    if (fresh) {
        place->second = std::move(assignment);
    }
    return fresh;
}

const Assignment* ParameterSet::find(std::uint16_t number) const {
    const auto place = assigned_.find(number);
    return place != assigned_.end() ? &place->second : nullptr;
}

double ParameterSet::value(std::uint16_t number) const {
    const Assignment* assigned = find(number);
    return assigned != nullptr ? assigned->value : 0.0;
}

std::uint32_t ParameterSet::integer(std::uint16_t number) const {
    const double typed = value(number);
    constexpr auto highest = std::numeric_limits<std::uint32_t>::max();
    if (!(typed > 0)) {
        return 0;
    }
    return typed >= static_cast<double>(highest) ? highest : static_cast<std::uint32_t>(typed);
}

std::optional<ExternalLimits> external_limits(const Row& row, const ParameterSet& references) {
    if (!row.scaling) {
        return std::nullopt;
    }
    const Scaling& scaling = *row.scaling;
    const std::optional<double> minimum =
        limit(scaling.external_minimum, scaling.external_minimum_parameter, references);
    const std::optional<double> maximum =
        limit(scaling.external_maximum, scaling.external_maximum_parameter, references);
    const bool is_stated = scaling.external_maximum_parameter == 0 || maximum != 0.0;  // D49
    if (!minimum || !maximum || *minimum == *maximum || !is_stated) {
        return std::nullopt;
    }
    return ExternalLimits{*minimum, *maximum};
}

}  // namespace cgw::parameter
