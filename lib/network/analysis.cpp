#include "network/analysis.hpp"

#include <algorithm>
#include <cmath>

#include "network/frame_bits.hpp"

namespace cgw::network {
namespace {

constexpr std::uint64_t ns_per_second = 1'000'000'000;
constexpr std::uint64_t ns_per_us = 1'000;
constexpr double us_per_second = 1e6;

std::uint64_t ns_of(std::uint64_t us) {
    return std::min(us, longest_ns / ns_per_us) * ns_per_us;
}

BusLoad load_of(const Message& message, double bit_rate) {
    const double frames_per_second = us_per_second / static_cast<double>(message.period_us);
    const double worst = worst_case_bits(message.bytes) * frames_per_second / bit_rate;
    const double average = average_bits(message.identifier, message.bytes) * frames_per_second / bit_rate;
    return {message.release == Release::cyclic ? average : 0, worst};
}

Disturbance disturbance_of(const Bus& bus) {
    Disturbance disturbance{.bit_ns = (ns_per_second + bus.bit_rate - 1) / bus.bit_rate};
    if (bus.errors_per_second > 0) {
        const double interval = static_cast<double>(ns_per_second) / bus.errors_per_second;
        disturbance.error_interval_ns =
            static_cast<std::uint64_t>(std::clamp(interval, 1.0, static_cast<double>(longest_ns)));
    }
    return disturbance;
}

}  // namespace

Analysis analyse(std::span<const Message> messages, const Bus& bus) {
    Analysis analysis{.bus = bus};
    analysis.bus.bit_rate = std::clamp(bus.bit_rate, lowest_bit_rate, highest_bit_rate);
    const Disturbance disturbance = disturbance_of(analysis.bus);
    std::vector<Stream> streams;
    for (const Message& message : messages) {
        if (message.kind == Kind::sdo && bus.sdo_interval_us == 0) {
            continue;
        }
        MessageResult result{.message = message};
        result.message.period_us =
            std::max<std::uint64_t>(1, message.kind == Kind::sdo ? bus.sdo_interval_us : message.period_us);
        result.worst_bits = worst_case_bits(std::min<unsigned>(message.bytes, most_data_bytes));
        result.load = load_of(result.message, analysis.bus.bit_rate);
        analysis.load += result.load;
        streams.push_back({message.identifier, result.worst_bits * disturbance.bit_ns,
                           ns_of(result.message.period_us), ns_of(message.jitter_us)});
        analysis.messages.push_back(std::move(result));
    }
    const std::vector<Response> responses = response_times(streams, disturbance);
    for (std::size_t i = 0; i < responses.size(); ++i) {
        analysis.messages[i].bound = responses[i].bound;
        analysis.messages[i].response_us = (responses[i].time_ns + ns_per_us - 1) / ns_per_us;
    }
    return analysis;
}

}  // namespace cgw::network
