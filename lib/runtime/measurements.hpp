// The gateway's measurements as a service tool would show them (GWM 11.3): one table row for each number or
// range of numbers that this program can tell.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "parameter/row.hpp"
#include "runtime/diagnosis.hpp"

namespace cgw::runtime {

struct Measurement {
    const parameter::Row* row = nullptr;  // of the catalogue: number, name, text
    std::uint32_t value = 0;
};

struct Measurements {
    std::vector<Measurement> known;                      // ascending by number
    std::vector<const parameter::Row*> unknown;          // what only a device of hardware knows
    std::vector<const parameter::Row*> without_meaning;  // D59
};

// Every measurement that the catalogue has of the gateway.
Measurements measure(const Diagnosis& diagnosis);

// Nothing when this program cannot know it.
std::optional<std::uint32_t> measurement(const Diagnosis& diagnosis, std::uint16_t number);

// A row of the catalogue of the gateway, or nullptr.
const parameter::Row* gateway_row(std::uint16_t number);
// `3072 ErrCanBus2`
std::string gateway_label(std::uint16_t number);

}  // namespace cgw::runtime
