#include "partner/frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "signals/codec.hpp"
#include "simulation/installation.hpp"

namespace cgw::test {
namespace {

using signals::Signal;

constexpr std::uint32_t seed = 20260301;
constexpr simulation::Time second = 1'000'000;

std::string hexadecimal(const std::vector<std::uint8_t>& data) {
    std::string text;
    for (const std::uint8_t byte : data) {
        text += fmt::format("{:02X}", byte);
    }
    return text;
}

const signals::Frame* find(const partner::Half& half, std::uint32_t identifier) {
    for (const signals::Frame& frame : half.frames) {
        if (frame.identifier == identifier) {
            return &frame;
        }
    }
    return nullptr;
}

// The plant through a start, errors of the device and the engine, and outputs of every kind.
void drive(simulation::Installation& installation, std::mt19937& random) {
    installation.plc().start_after_boot_up(true);
    installation.plc().set_healthy_outputs();
    installation.plc().send_outputs();
    for (unsigned step = 1; step <= 12; ++step) {
        installation.plant().run_until(step * second);
        for (auto& words : installation.plc().outputs()) {
            for (auto& word : words) {
                word = static_cast<std::uint16_t>(step % 3 == 0 ? random() : word);
            }
        }
        installation.plc().send_outputs();
        installation.plant().connect(simulation::Plant::BusName::can1, step != 7);
        if (step == 10) {
            installation.plant().clear_gateway_errors();
        }
    }
}

bool is_switch(const Signal& signal) {
    return signal.is_bit() && !signal.values.empty();
}

bool is_on(const Signal& signal, std::int32_t raw) {
    return std::any_of(signal.values.begin(), signal.values.end(),
                       [raw](const auto& value) { return value.raw == raw && value.text == "on"; });
}

// Around the range in steps of half a raw value and less, and far beyond it; what a raw number can be.
double some_value(const Signal& signal, std::mt19937& random) {
    if (signal.is_bit()) {
        return static_cast<double>(random() & 1U);
    }
    const double low = signal.raw_minimum;
    const double span = static_cast<double>(signal.raw_maximum) - low;
    if (!signal.scaled) {
        return low + static_cast<double>(random() % static_cast<unsigned>(span + 1));
    }
    constexpr unsigned parts = 1000;
    const unsigned kind = random() % 16;
    const double beyond = kind == 0   ? -1000
                          : kind == 1 ? 1000
                          : kind == 2 ? -0.25
                          : kind == 3 ? span + 0.25
                                      : 0;
    const double inside = static_cast<double>(random() % parts) / parts * span;
    return signals::physical_value(signal, low + (kind < 4 ? beyond + (kind == 1 ? span : 0) : inside));
}

// What lib/signals makes of it; false when it refuses the value.
bool put(const Signal& signal, signals::Data& data, double value) {
    if (signal.is_bit()) {
        const bool high = is_switch(signal) ? is_on(signal, 1) == (value != 0) : value != 0;
        signals::put_raw(signal, data, high ? 1 : 0);
        return true;
    }
    if (!signal.scaled) {
        signals::put_raw(signal, data, static_cast<std::int32_t>(value));
        return true;
    }
    const std::optional<std::int32_t> raw = signals::raw_of(signal, value);
    if (raw) {
        signals::put_raw(signal, data, *raw);
    }
    return raw.has_value();
}

}  // namespace

std::vector<PdoFrame> record(const partner::Half& half, const base::Bytes& bytes, unsigned random_frames) {
    std::vector<PdoFrame> frames;
    std::set<std::pair<const signals::Frame*, std::vector<std::uint8_t>>> seen;
    const auto keep = [&](const signals::Frame* frame, std::vector<std::uint8_t> data) {
        if (frame != nullptr && seen.emplace(frame, data).second) {
            frames.push_back({frame, std::move(data)});
        }
    };
    std::mt19937 random(seed);
    image::Image image;
    if (image::Image::open(bytes, image) != image::Status::ok) {
        return {};
    }
    simulation::Installation installation(image);
    installation.plant().can2().observe([&](const frame::Frame& frame, simulation::Time) {
        if (!frame.remote && !frame.extended) {
            keep(find(half, frame.id), {frame.data.begin(), frame.data.begin() + frame.length});
        }
    });
    drive(installation, random);
    for (const signals::Frame& frame : half.frames) {
        for (unsigned i = 0; i < random_frames; ++i) {
            std::vector<std::uint8_t> data(frame.length);
            std::generate(data.begin(), data.end(), [&] { return static_cast<std::uint8_t>(random()); });
            keep(&frame, std::move(data));
        }
    }
    return frames;
}

std::string frame_lines(const std::vector<PdoFrame>& frames) {
    std::string text;
    for (const PdoFrame& frame : frames) {
        text += fmt::format("{:03X} {}\n", frame.frame->identifier, hexadecimal(frame.data));
    }
    return text;
}

std::string decoded_lines(const std::vector<PdoFrame>& frames) {
    std::string text;
    for (const PdoFrame& frame : frames) {
        for (const Signal& signal : frame.frame->signals) {
            const std::int32_t raw = signals::raw_value(signal, frame.data);
            text += fmt::format("{} {} {}", frame.frame->name, signal.name, raw);
            if (is_switch(signal)) {
                text += is_on(signal, raw) ? " on" : " off";
            } else if (signal.scaled) {
                text += fmt::format(" {:.17g}", signals::physical_value(signal, raw));
            }
            text += '\n';
        }
    }
    return text;
}

Encoding encodings(const partner::Half& half, unsigned count) {
    Encoding all;
    std::mt19937 random(seed);
    for (const signals::Frame& frame : half.frames) {
        for (unsigned i = 0; !frame.transmit() && i < count; ++i) {
            signals::Data data{};
            std::string put_or_not;
            all.lines += frame.name;
            for (const Signal& signal : frame.signals) {
                const double value = some_value(signal, random);
                all.lines += fmt::format(" {:.17g}", value);
                put_or_not += put(signal, data, value) ? '1' : '0';
            }
            all.lines += '\n';
            all.expected += fmt::format("{} {} {}\n", frame.name,
                                        hexadecimal({data.begin(), data.begin() + frame.length}), put_or_not);
        }
    }
    return all;
}

}  // namespace cgw::test
