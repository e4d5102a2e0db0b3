// What the devices' errors mean and what to do about them: schemas/errors/*.toml, compiled in.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "parameter/row.hpp"

namespace cgw::catalogue {

// Texts are whole clauses in our words, without a final period.
struct ErrorDescription {
    std::uint16_t number = 0;  // of the parameter that shows it; 0: the manual prints none
    std::string_view key{};    // "sensor-error": a word for what has no number; else ""
    bool governor = false;     // which devices show it
    bool gateway = false;
    parameter::Program program = parameter::Program::application;
    std::uint16_t counter = 0;  // parameter that counts it in the permanent memory (GWM 9.2); 0: none
    std::span<const std::uint16_t> with{};  // parameters that tell more
    std::span<const std::uint16_t> see{};   // errors that go with it
    std::span<const std::string_view> cause{};
    std::span<const std::string_view> response{};  // what the devices do
    std::span<const std::string_view> action{};    // in this order
    std::string_view clears{};
    std::string_view section{};  // "GWM 9.5, D52"

    bool shown_by(parameter::Device device) const {
        return device == parameter::Device::governor ? governor : gateway;
    }
};

// Sorted by program, number, key, governor first.
std::span<const ErrorDescription> shipped_errors();

// The error that this parameter shows or, in the permanent memory, counts: 3070 and 3170 are the same one.
const ErrorDescription* find_error(parameter::Device device, parameter::Program program,
                                   std::uint16_t number);

// By key, ignoring case.
const ErrorDescription* find_error(std::string_view key);

}  // namespace cgw::catalogue
