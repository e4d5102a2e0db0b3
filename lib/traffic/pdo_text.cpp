#include <fmt/format.h>

#include <algorithm>

#include "base/utf8.hpp"
#include "signals/codec.hpp"
#include "traffic/decoder.hpp"

namespace cgw::traffic {
namespace {

using signals::Kind;
using signals::Signal;

// What is told of one kind of bits only where they are set.
struct SetBits {
    Kind kind;
    std::string_view none;
    std::string_view before;
};

constexpr SetBits set_bits[] = {
    {Kind::error, "no error", "error "},
    {Kind::engine_state, "no bit set", "bits "},
    {Kind::sensor_flag, "no sensor faulty", "faulty "},
};

std::string name_of_bit(const Signal& signal) {
    if (signal.kind == Kind::engine_state) {
        return fmt::format("{}", signal.object_bit + 1);
    }
    return signal.sources.empty() ? fmt::format("{}", signal.number) : signal.sources.front().label();
}

void add(std::string& text, const std::string& part) {
    text += text.empty() ? "" : ", ";
    text += part;
}

void add_set_bits(std::string& text, const SetBits& row, const signals::Frame& pdo,
                  std::span<const std::uint8_t> data) {
    bool any = false;
    std::string bits;
    for (const Signal& signal : pdo.signals) {
        if (signal.kind != row.kind || !signals::reaches(signal, data)) {
            continue;
        }
        any = true;
        if (signals::raw_value(signal, data) != 0) {
            add(bits, name_of_bit(signal));
        }
    }
    if (any) {
        add(text, bits.empty() ? std::string(row.none) : std::string(row.before) + bits);
    }
}

}  // namespace

std::string pdo_text(const signals::Frame& pdo, std::span<const std::uint8_t> data) {
    std::string text;
    for (const Signal& signal : pdo.signals) {
        const bool told = signal.kind == Kind::measurement || signal.kind == Kind::sensor ||
                          signal.kind == Kind::switch_function;
        if (told && signals::reaches(signal, data)) {
            const std::int32_t raw = signals::raw_value(signal, data);
            add(text, fmt::format("{} {}{}", signal.name, signals::value_text(signal, raw),
                                  signals::in_range(signal, raw) ? "" : " (beyond its range)"));
        }
    }
    for (const SetBits& row : set_bits) {
        add_set_bits(text, row, pdo, data);
    }
    if (data.size() != pdo.length) {
        add(text,
            fmt::format("{} byte{} instead of {}", data.size(), data.size() == 1 ? "" : "s", pdo.length));
    }
    return base::printable(text);
}

std::string bytes_text(std::span<const std::uint8_t> data) {
    return fmt::format("{:02X}", fmt::join(data, " "));
}

}  // namespace cgw::traffic
