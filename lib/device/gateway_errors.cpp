#include "device/gateway_errors.hpp"

#include <algorithm>

namespace cgw::device {
namespace {

using enum Fault;

constexpr unsigned most_counted = 255;

// GWM 9.4 and 9.5; what is not printed there is D45.
constexpr std::array<FaultRow, fault_count> rows{{
    {governor_reset, 0, 12411, Reaction::interrupted, Clearing::on_request},
    {initialisation, 0, 12412, Reaction::undefined, Clearing::on_request},
    {receive_pdo_late, 0, 12413, Reaction::none, Clearing::by_itself},
    {governor_can_bus, 0, 12414, Reaction::undefined, Clearing::on_request},
    {governor_can_comm, 0, 12415, Reaction::undefined, Clearing::on_request},
    {gateway_reset, 0, 12419, Reaction::none, Clearing::on_request},
    {heartbeat_lost, 0, 12420, Reaction::none, Clearing::by_itself},
    {can1_bus, 3070, 12421, Reaction::undefined, Clearing::on_request},
    {can1_overflow, 3071, 12422, Reaction::undefined, Clearing::on_request},
    {governor_silent, 3071, 12422, Reaction::undefined, Clearing::on_request},
    {node_number_twice, 3071, 12422, Reaction::undefined, Clearing::on_request},
    {can2_bus, 3072, 12423, Reaction::pre_operational, Clearing::on_request},
    {can2_receive_overflow, 3073, 12424, Reaction::undefined, Clearing::on_request},
    {sdo_overflow, 3073, 12424, Reaction::stopped, Clearing::on_request},
    {parameter_store, 3076, 0, Reaction::undefined, Clearing::by_reset},
    {program_memory, 3077, 0, Reaction::undefined, Clearing::by_reset},
    {working_memory, 3078, 0, Reaction::undefined, Clearing::by_reset},
    {supply_voltage, 3085, 0, Reaction::none, Clearing::by_itself},
    {data, 3090, 0, Reaction::undefined, Clearing::by_reset},
    {stack, 3093, 0, Reaction::undefined, Clearing::by_reset},
    {internal, 3094, 0, Reaction::undefined, Clearing::by_reset},
}};

constexpr bool in_order() {
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].fault != static_cast<Fault>(i)) {
            return false;
        }
    }
    return true;
}
static_assert(in_order());

void set_bit(std::array<std::uint16_t, facts::error_words>& words, std::uint16_t error) {
    const unsigned bit = error - facts::first_error_number;
    std::uint16_t& word = words[bit / facts::word_bits];
    word = static_cast<std::uint16_t>(word | (1U << (bit % facts::word_bits)));
}

bool has_bit(const std::array<std::uint16_t, facts::error_words>& words, std::size_t error) {
    const std::size_t bit = error - facts::first_error_number;
    return ((unsigned{words[bit / facts::word_bits]} >> (bit % facts::word_bits)) & 1U) != 0;
}

}  // namespace

std::span<const FaultRow, fault_count> fault_rows() {
    return rows;
}

const FaultRow& row_of(Fault fault) {
    return rows[static_cast<std::size_t>(fault)];
}

void GatewayErrors::set(Fault fault, bool present) {
    if (present) {
        present_ |= bit(fault);
        shown_ |= bit(fault);
    } else {
        present_ &= ~bit(fault);
        if (row_of(fault).clearing == Clearing::by_itself) {
            shown_ &= ~bit(fault);
        }
    }
    update();
}

void GatewayErrors::strike(Fault fault) {
    set(fault, true);
    set(fault, false);
}

void GatewayErrors::clear() {
    for (const FaultRow& row : rows) {
        if (row.clearing == Clearing::on_request && !present(row.fault)) {
            shown_ &= ~bit(row.fault);
        }
    }
    update();
}

bool GatewayErrors::blocking() const {
    for (const FaultRow& row : rows) {
        const bool there = present(row.fault) || (shown(row.fault) && row.clearing == Clearing::by_reset);
        if (there && row.reaction == Reaction::undefined) {
            return true;
        }
    }
    return false;
}

void GatewayErrors::update() {
    const std::array<std::uint16_t, facts::error_words> before = words_;
    words_ = {};
    canopen_errors_ = 0;
    for (const FaultRow& row : rows) {
        if (!shown(row.fault)) {
            continue;
        }
        if (row.error != 0) {
            set_bit(words_, row.error);
        }
        if (row.canopen_error != 0) {
            canopen_errors_ = static_cast<std::uint16_t>(
                canopen_errors_ | (1U << (row.canopen_error - facts::first_canopen_error)));
        }
    }
    if (canopen_errors_ != 0) {
        set_bit(words_, can_open_error);
    }
    count(before);
}

void GatewayErrors::restore(const std::array<std::uint8_t, error_count>& sentinels) {
    for (std::size_t i = 0; i < error_count; ++i) {
        const unsigned sum = unsigned{sentinels_[i]} + sentinels[i];
        sentinels_[i] = static_cast<std::uint8_t>(std::min(sum, most_counted));
    }
}

void GatewayErrors::reset() {
    present_ = 0;
    shown_ = 0;
    canopen_errors_ = 0;
    words_ = {};
}

void GatewayErrors::count(const std::array<std::uint16_t, facts::error_words>& before) {
    for (std::size_t i = 0; i < error_count; ++i) {
        const bool appeared = has_bit(words_, first_error + i) && !has_bit(before, first_error + i);
        if (appeared && sentinels_[i] != most_counted) {
            ++sentinels_[i];
        }
    }
}

}  // namespace cgw::device
