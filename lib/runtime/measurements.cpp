#include "runtime/measurements.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "catalogue/catalogue.hpp"
#include "runtime/error_memory.hpp"

namespace cgw::runtime {
namespace {

using device::Fault;
using device::GatewayState;
using Value = std::optional<std::uint32_t>;

constexpr unsigned word_bits = facts::word_bits;
constexpr std::uint32_t word_mask = 0xFFFF;

const device::GatewayErrors& errors(const Diagnosis& diagnosis) {
    return diagnosis.gateway->errors();
}

// 2401..2403 have one bit per device number; a governor beyond 15 has none.
Value governor_bit(const Diagnosis& diagnosis, bool set) {
    const unsigned node = diagnosis.image->can1().peer_node;
    if (!set) {
        return 0;
    }
    return node < word_bits ? Value(1U << node) : std::nullopt;
}

Value send_buffer(const Diagnosis&, std::uint16_t) {
    return 0;  // a telegram that waits is replaced by a newer one: the link's buffer cannot overflow
}
Value receive_buffer(const Diagnosis& diagnosis, std::uint16_t) {
    return governor_bit(diagnosis, errors(diagnosis).shown(Fault::can1_overflow));
}
Value receive_timeout(const Diagnosis& diagnosis, std::uint16_t) {
    return governor_bit(diagnosis, errors(diagnosis).present(Fault::governor_silent));
}
Value type_mismatch(const Diagnosis& diagnosis, std::uint16_t) {
    return errors(diagnosis).shown(Fault::node_number_twice) ? 1 : 0;
}
Value can1_online(const Diagnosis& diagnosis, std::uint16_t) {
    return diagnosis.can1.up ? 1 : 0;
}
Value can2_online(const Diagnosis& diagnosis, std::uint16_t) {
    return diagnosis.can2.up ? 1 : 0;
}
Value governors_16_to_31(const Diagnosis& diagnosis, std::uint16_t) {
    return diagnosis.governors_heard >> word_bits;
}
Value governors_1_to_15(const Diagnosis& diagnosis, std::uint16_t) {
    return diagnosis.governors_heard & word_mask;
}
Value service_tools(const Diagnosis&, std::uint16_t) {
    return 0;  // the governor link has no telegrams of a service tool
}

Value own_error(const Diagnosis& diagnosis, std::uint16_t number) {
    const unsigned bit = number - unsigned{facts::first_error_number};
    return (unsigned{errors(diagnosis).words()[bit / word_bits]} >> (bit % word_bits)) & 1U;
}
Value sentinel(const Diagnosis& diagnosis, std::uint16_t number) {
    return errors(diagnosis).sentinels()[number - std::size_t{sentinel_number(0)}];
}
Value canopen_error(const Diagnosis& diagnosis, std::uint16_t number) {
    return (unsigned{errors(diagnosis).canopen_errors()} >> (number - facts::first_canopen_error)) & 1U;
}

Value in_state(const Diagnosis& diagnosis, GatewayState state) {
    return diagnosis.gateway->state() == state ? 1 : 0;
}
Value is_stopped(const Diagnosis& diagnosis, std::uint16_t) {
    return in_state(diagnosis, GatewayState::stopped);
}
Value is_init(const Diagnosis& diagnosis, std::uint16_t) {
    return in_state(diagnosis, GatewayState::init);
}
Value is_pre_operational(const Diagnosis& diagnosis, std::uint16_t) {
    return in_state(diagnosis, GatewayState::pre_operational);
}
Value is_operational(const Diagnosis& diagnosis, std::uint16_t) {
    return in_state(diagnosis, GatewayState::operational);
}

// The identity is part of the image (D32).
Value software_version(const Diagnosis& diagnosis, std::uint16_t) {
    return diagnosis.image->identity().revision & word_mask;
}
Value serial_date(const Diagnosis& diagnosis, std::uint16_t) {
    return diagnosis.image->identity().serial >> word_bits;
}
Value serial_number(const Diagnosis& diagnosis, std::uint16_t) {
    return diagnosis.image->identity().serial & word_mask;
}

struct Source {
    std::uint16_t first;
    std::uint16_t last;
    Value (*value)(const Diagnosis& diagnosis, std::uint16_t number);
};

constexpr std::uint16_t last_own_error =
    device::GatewayErrors::first_error + device::GatewayErrors::error_count - 1;

constexpr Source sources[] = {
    {2401, 2401, send_buffer},
    {2402, 2402, receive_buffer},
    {2403, 2403, receive_timeout},
    {2404, 2404, type_mismatch},
    {2405, 2405, can1_online},
    {2410, 2410, governors_16_to_31},
    {2411, 2411, governors_1_to_15},
    {2424, 2425, service_tools},
    {device::GatewayErrors::first_error, last_own_error, own_error},
    {sentinel_number(0), sentinel_number(device::GatewayErrors::error_count - 1), sentinel},
    {3842, 3842, software_version},
    {3844, 3844, serial_date},
    {3845, 3845, serial_number},
    {12401, 12401, is_stopped},
    {12402, 12402, is_init},
    {12403, 12403, is_pre_operational},
    {12404, 12404, is_operational},
    {12405, 12405, can2_online},
    {facts::first_canopen_error, facts::last_canopen_error, canopen_error},
};

constexpr std::uint16_t printed_without_meaning[] = {2406, 12400, 12410};  // D59

bool of_gateway(const parameter::Row& row) {
    return row.device == parameter::Device::gateway && row.program == parameter::Program::application;
}

}  // namespace

std::optional<std::uint32_t> measurement(const Diagnosis& diagnosis, std::uint16_t number) {
    for (const Source& source : sources) {
        if (number >= source.first && number <= source.last) {
            return source.value(diagnosis, number);
        }
    }
    return std::nullopt;
}

Measurements measure(const Diagnosis& diagnosis) {
    Measurements result;
    for (const parameter::Row& row : catalogue::shipped_rows()) {
        if (!of_gateway(row) || row.list != parameter::List::measurement) {
            continue;
        }
        const Value value = measurement(diagnosis, row.number);
        if (value) {
            result.known.push_back({&row, *value});
        } else if (std::ranges::find(printed_without_meaning, row.number) !=
                   std::end(printed_without_meaning)) {
            result.without_meaning.push_back(&row);
        } else {
            result.unknown.push_back(&row);
        }
    }
    return result;
}

const parameter::Row* gateway_row(std::uint16_t number) {
    const auto rows = catalogue::shipped_rows();
    const auto row = std::ranges::find_if(rows, [number](const parameter::Row& candidate) {
        return of_gateway(candidate) && candidate.number == number;
    });
    return row == rows.end() ? nullptr : &*row;
}

std::string gateway_label(std::uint16_t number) {
    const parameter::Row* const row = gateway_row(number);
    return row == nullptr ? fmt::format("{}", number) : parameter::label(*row);
}

}  // namespace cgw::runtime
