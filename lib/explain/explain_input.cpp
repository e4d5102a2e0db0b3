// What the value of an 8nn, a 9nn or a TPDO word leads to: a bit, a channel, a measurement.
#include <cmath>

#include <fmt/format.h>

#include "config/numbers.hpp"
#include "explain/entries.hpp"

namespace cgw::explain {

namespace {

using config::governor::type_of;
using parameter::Catalogue;
using parameter::Device;
using parameter::Role;
using parameter::Row;

std::string with_canopen_type(const Row& row) {
    return fmt::format("with {} = {}", type_of(row.number), config::governor::canopen_type);
}

std::string switch_text(const Row& row, int value) {
    const int bit = std::abs(value);
    if (row.number == config::governor::engine_stop) {
        return fmt::format("{}: refused, engine stop is wired (E0212)", with_canopen_type(row));
    }
    if (bit == 0) {
        return fmt::format("{}: no bit, it does not come over CANopen (D27)", with_canopen_type(row));
    }
    if (bit > facts::switch_bits) {
        return fmt::format("{}: refused, RPDO1 word 1 has bits 1..{} (E0210)", with_canopen_type(row),
                           facts::switch_bits);
    }
    return fmt::format("{}: bit {} of RPDO1 word 1, {}-active", with_canopen_type(row), bit,
                       value < 0 ? "low" : "high");
}

std::string sensor_text(const Row& row, int value) {
    if (value == 0) {
        return fmt::format("{}: no channel, it does not come over CANopen (D27)", with_canopen_type(row));
    }
    if (value < 0 || value > facts::sensor_channels) {
        return fmt::format("{}: refused, there are channels 1..{} (E0211)", with_canopen_type(row),
                           facts::sensor_channels);
    }
    const auto channel = static_cast<unsigned>(value);
    return fmt::format("{}: word {} of RPDO{}, 2004h:{}", with_canopen_type(row),
                       facts::word_of_channel(channel), facts::rpdo_of_channel(channel), channel);
}

std::string assigned_text(int value, const Catalogue& catalogue) {
    const Row* const measurement = catalogue.find(Device::governor, static_cast<std::uint16_t>(value));
    if (value == 0) {
        return "nothing is sent; words behind it close up (D23)";
    }
    if (measurement == nullptr) {
        return fmt::format("refused, unless {} is declared: no catalogue knows it (E0213)", value);
    }
    if (measurement->is_bit()) {
        return fmt::format("refused, {} is a single bit (E0214)", label(*measurement));
    }
    return fmt::format("sends {}{}{}", label(*measurement), measurement->text.empty() ? "" : ": ",
                       measurement->text);
}

bool is_assignment(const Row& row) {
    return row.device == Device::governor && row.number >= config::governor::tpdo_assignment &&
           row.number <= config::governor::last_tpdo_assignment;
}

}  // namespace

void add_what_it_leads_to(Entry& entry, const Row& row, double value, const Catalogue& catalogue) {
    if (value != std::floor(value) || !row.allows(value)) {
        return;
    }
    const auto whole = static_cast<int>(value);
    if (row.role == Role::switch_assignment) {
        entry.add("means", switch_text(row, whole));
    } else if (row.role == Role::sensor_assignment) {
        entry.add("means", sensor_text(row, whole));
    } else if (is_assignment(row)) {
        entry.add("means", assigned_text(whole, catalogue));
    }
}

}  // namespace cgw::explain
