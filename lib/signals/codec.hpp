// Between the bytes of a frame, raw values and physical values. Nothing here fails on any input.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "signals/frames.hpp"

namespace cgw::signals {

using Data = std::array<std::uint8_t, 8>;

// `data` may be shorter than the frame: false when a bit of the signal is not in it.
bool reaches(const Signal& signal, std::span<const std::uint8_t> data);

// Sign applied. The signal reaches into `data`.
std::int32_t raw_value(const Signal& signal, std::span<const std::uint8_t> data);

// `raw` is one that can_carry().
void put_raw(const Signal& signal, Data& data, std::int32_t raw);

// What to send of a frame before anything is set: switch functions off, which of low-active ones is 1; all
// else 0.
Data rest_data(const Frame& frame);

// Width and sign hold the number: 0..1, 0..65535, -32768..32767.
bool can_carry(const Signal& signal, std::int64_t raw);

// The raw values that mean something: the signal's range, and all of a signal without scaling.
bool in_range(const Signal& signal, std::int32_t raw);

double physical_value(const Signal& signal, double raw);

// The raw value that comes nearest; nothing where the physical value is beyond the signal's range. A value
// that is beyond by no more than rounding of its text is taken for the end of the range.
std::optional<std::int32_t> raw_of(const Signal& signal, double physical);

// The physical value with as many digits as tell neighbouring raw values apart, without its unit: "1500.02".
// raw_of() of that number is `raw` again, if it is in_range().
std::string physical_text(const Signal& signal, std::int32_t raw);

// For people: "1500.02 1/min"; "on" and "off"; a bit without names "1"; a number without scaling "8000 raw".
std::string value_text(const Signal& signal, std::int32_t raw);

// A physical value as it is, with the unit; "raw" behind it without scaling.
std::string quantity_text(const Signal& signal, double physical);

// "0..4000 1/min", "0..65535 raw", "0 or 1", "on or off"
std::string range_text(const Signal& signal);

// "0..65535 is 0..4000 1/min"; "not known" without scaling; "" for a bit.
std::string scaling_text(const Signal& signal);

}  // namespace cgw::signals
