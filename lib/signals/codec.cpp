#include "signals/codec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"

namespace cgw::signals {
namespace {

constexpr unsigned byte_bits = 8;

std::string with_unit(std::string text, const Signal& signal) {
    if (!signal.scaled) {
        return text + " raw";
    }
    return signal.unit.empty() ? text : fmt::format("{} {}", text, signal.unit);
}

// Digits behind the point with which half a raw step is still seen; nothing for a step that is too small for
// such a text.
std::optional<int> decimals(const Signal& signal) {
    constexpr int most = 12;
    for (int count = 0; count <= most; ++count) {
        if (std::pow(10.0, -count) <= std::abs(signal.factor) / 2) {
            return count;
        }
    }
    return std::nullopt;
}

const NamedValue* find_value(const Signal& signal, std::int32_t raw) {
    for (const NamedValue& value : signal.values) {
        if (value.raw == raw) {
            return &value;
        }
    }
    return nullptr;
}

}  // namespace

bool reaches(const Signal& signal, std::span<const std::uint8_t> data) {
    return signal.first_bit + signal.width <= data.size() * byte_bits;
}

std::int32_t raw_value(const Signal& signal, std::span<const std::uint8_t> data) {
    const std::size_t byte = signal.first_bit / byte_bits;
    if (signal.is_bit()) {
        return data[byte] >> (signal.first_bit % byte_bits) & 1;
    }
    const auto word = static_cast<std::uint16_t>(data[byte] | data[byte + 1] << byte_bits);
    return signal.is_signed ? static_cast<std::int16_t>(word) : word;
}

void put_raw(const Signal& signal, Data& data, std::int32_t raw) {
    const std::size_t byte = signal.first_bit / byte_bits;
    if (signal.is_bit()) {
        const auto mask = static_cast<std::uint8_t>(1U << signal.first_bit % byte_bits);
        data[byte] = static_cast<std::uint8_t>(raw != 0 ? data[byte] | mask : data[byte] & ~mask);
        return;
    }
    const auto word = static_cast<std::uint16_t>(raw);
    data[byte] = static_cast<std::uint8_t>(word);
    data[byte + 1] = static_cast<std::uint8_t>(word >> byte_bits);
}

Data rest_data(const Frame& frame) {
    Data data{};
    for (const Signal& signal : frame.signals) {
        for (const NamedValue& value : signal.values) {
            if (signal.kind == Kind::switch_function && value.text == "off") {
                put_raw(signal, data, value.raw);
            }
        }
    }
    return data;
}

bool can_carry(const Signal& signal, std::int64_t raw) {
    const std::int64_t count = std::int64_t{1} << signal.width;
    return signal.is_signed ? raw >= -count / 2 && raw < count / 2 : raw >= 0 && raw < count;
}

bool in_range(const Signal& signal, std::int32_t raw) {
    return !signal.scaled || (raw >= signal.raw_minimum && raw <= signal.raw_maximum);
}

double physical_value(const Signal& signal, double raw) {
    return raw * signal.factor + signal.offset;
}

std::optional<std::int32_t> raw_of(const Signal& signal, double physical) {
    const double slack = std::abs(signal.factor) / 2;
    if (!std::isfinite(physical) || physical < signal.minimum - slack || physical > signal.maximum + slack) {
        return std::nullopt;
    }
    const double inside = std::clamp(physical, signal.minimum, signal.maximum);
    const double raw = std::round((inside - signal.offset) / signal.factor);
    constexpr double beyond_any_word = 1 << 20;
    if (!(std::abs(raw) < beyond_any_word) || !can_carry(signal, static_cast<std::int64_t>(raw))) {
        return std::nullopt;
    }
    return static_cast<std::int32_t>(raw);
}

std::string physical_text(const Signal& signal, std::int32_t raw) {
    const double value = physical_value(signal, raw);
    const std::optional<int> digits = decimals(signal);
    const double rounded =
        digits ? base::parse_real(fmt::format("{:.{}f}", value, *digits)).value_or(value) : value;
    return base::to_text(rounded == 0 ? 0.0 : rounded);  // no "-0"
}

std::string value_text(const Signal& signal, std::int32_t raw) {
    if (const NamedValue* const named = find_value(signal, raw); named != nullptr) {
        return named->text;
    }
    return signal.is_bit() ? fmt::format("{}", raw) : with_unit(physical_text(signal, raw), signal);
}

std::string quantity_text(const Signal& signal, double physical) {
    const double rounded = base::parse_real(fmt::format("{:.12g}", physical)).value_or(physical);
    return with_unit(base::to_text(rounded), signal);
}

std::string range_text(const Signal& signal) {
    if (signal.is_bit()) {
        return signal.values.empty() ? "0 or 1" : "on or off";
    }
    return with_unit(fmt::format("{}..{}", base::to_text(signal.minimum), base::to_text(signal.maximum)),
                     signal);
}

std::string scaling_text(const Signal& signal) {
    if (signal.is_bit()) {
        return {};
    }
    if (!signal.scaled) {
        return "not known";
    }
    return with_unit(
        fmt::format("{}..{} is {}..{}", signal.raw_minimum, signal.raw_maximum,
                    physical_text(signal, signal.raw_minimum), physical_text(signal, signal.raw_maximum)),
        signal);
}

}  // namespace cgw::signals
