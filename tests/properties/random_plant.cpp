#include "properties/random_plant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "catalogue/catalogue.hpp"
#include "config/configuration.hpp"
#include "config/numbers.hpp"

namespace cgw::test {

using parameter::Device;
using parameter::Row;
namespace governor = config::governor;
namespace gateway = config::gateway;

namespace {

const parameter::Catalogue& shipped() {
    static const parameter::Catalogue catalogue(catalogue::shipped_rows());
    return catalogue;
}

std::vector<std::uint16_t> words_that_travel() {
    std::vector<std::uint16_t> numbers;
    for (const Row* row : shipped().rows(Device::governor)) {
        if (config::transmittable(row)) {
            numbers.push_back(row->number);
        }
    }
    return numbers;
}

// A key of the parameter file for this row: number, name, or both, an alias, or a misprint of the manuals.
std::string spelling(const Row& row, Dice* dice) {
    const std::uint32_t kind = dice == nullptr ? 0 : dice->below(5);
    if (kind == 3 && !row.aliases.empty()) {
        return fmt::format("\"{}\"",
                           row.aliases[dice->below(static_cast<std::uint32_t>(row.aliases.size()))]);
    }
    if (kind == 4 && !row.misprints.empty()) {
        return fmt::format("\"{}\"",
                           row.misprints[dice->below(static_cast<std::uint32_t>(row.misprints.size()))]);
    }
    if (kind == 0 || row.name.empty()) {
        return fmt::format("{}", row.number);
    }
    return kind == 1 ? fmt::format("\"{}\"", row.name) : fmt::format("\"{} {}\"", row.number, row.name);
}

}  // namespace

std::int64_t Dice::between(std::int64_t lowest, std::int64_t highest) {
    return lowest + static_cast<std::int64_t>(engine_() % static_cast<std::uint64_t>(highest - lowest + 1));
}

RandomPlant::RandomPlant(std::uint32_t seed, bool careful, Identifiers identifiers)
    : dice_(seed), careful_(careful), identifiers_(identifiers) {
    required();
    declare();
    outputs();
    this->identifiers();
    inputs();
    if (!careful_) {
        anything();
    }
}

void RandomPlant::set(Device device, unsigned number, std::int64_t value) {
    (device == Device::governor ? governor_ : gateway_)[static_cast<std::uint16_t>(number)] =
        fmt::format("{}", value);
}

void RandomPlant::required() {
    const std::vector<int> rates(facts::bit_rates_kbit.begin(), facts::bit_rates_kbit.end());
    const std::int64_t governor_node = dice_.between(1, 31);
    const std::int64_t gateway_node = dice_.between(1, 31);
    const int rate = dice_.pick(rates);
    set(Device::governor, governor::own_node, governor_node);
    set(Device::governor, governor::gateway_node, gateway_node);
    set(Device::governor, governor::bit_rate, rate);
    set(Device::governor, governor::gateway_communication, 1);
    set(Device::gateway, gateway::own_node, gateway_node);
    set(Device::gateway, gateway::governor_node, governor_node);
    set(Device::gateway, gateway::hzm_bit_rate, rate);
    set(Device::gateway, gateway::canopen_bit_rate, dice_.pick(rates));
    set(Device::gateway, gateway::governor_communication, 1);
    const std::int64_t node = dice_.between(2, 127);
    node_ = node;
    set(Device::gateway, gateway::node_id, node);
    set(Device::gateway, gateway::heartbeat_producer, dice_.between(16, 60000));
    if (dice_.one_in(2)) {
        set(Device::gateway, gateway::partner_node_id, 1);
        set(Device::gateway, gateway::heartbeat_consumer, dice_.between(100, 60000));
    }
    for (std::uint32_t n = dice_.below(4); n > 0; --n) {
        const auto other = static_cast<int>(dice_.between(1, 127));
        if (other != node && std::find(nodes_.begin(), nodes_.end(), other) == nodes_.end()) {
            nodes_.push_back(other);
        }
    }
}

void RandomPlant::declare() {
    main_cycle_us_ = dice_.one_in(3) ? dice_.between(10000, 20000) : 15625;
    if (dice_.one_in(2)) {
        identity_ = fmt::format(
            "\n[gateway]\nidentity = {{ software_version = {}, serial_date = {}, serial_number = {} }}\n",
            dice_.below(1000), dice_.between(401, 412), dice_.below(65536));
    }
    for (std::uint32_t n = dice_.below(4); n > 0; --n) {
        const auto number = static_cast<std::uint16_t>(2990 + n);
        const bool is_signed = dice_.one_in(2);
        declared_.push_back(number);
        declarations_.push_back(fmt::format(
            "\n[[governor.declare]]\nnumber = {}\nname = \"Declared{}\"\nkind = \"measurement\"\nwidth = "
            "16\nsigned = {}\ninternal = [0, {}]\nexternal = [0.0, {}.5]\n",
            number, number, is_signed, dice_.between(100, 32767), dice_.between(1, 999)));
    }
}

// Only so many bases of CiA 301 belong to no PDO, SDO or heartbeat of the gateway itself.
void RandomPlant::identifiers() {
    std::uint16_t next = facts::first_free_identifier;
    std::vector<std::int64_t> unused{0x080, 0x100, 0x680, 0x780};
    dice_.shuffle(unused);
    for (unsigned tpdo = facts::predefined_pdos + 1; tpdo <= facts::tpdo_count; ++tpdo) {
        const bool active = std::find(active_.begin(), active_.end(), tpdo) != active_.end();
        std::int64_t identifier = next++;
        if (identifiers_ == Identifiers::follow_node && active) {
            identifier = unused.back() | node_;
            unused.pop_back();
        } else if (identifiers_ == Identifiers::follow_node) {
            identifier = (0x80 * dice_.between(1, 15)) | node_;
        }
        gateway_[static_cast<std::uint16_t>(gateway::tpdo_identifier + tpdo - facts::predefined_pdos - 1)] =
            fmt::format("0x{:X}", identifier);
    }
}

bool RandomPlant::may_be_active(unsigned tpdo) {
    constexpr std::size_t bases = 4;
    if (dice_.one_in(2) || (identifiers_ == Identifiers::follow_node && active_.size() == bases)) {
        return false;
    }
    if (tpdo > facts::predefined_pdos) {
        active_.push_back(tpdo);
    }
    return true;
}

void RandomPlant::outputs() {
    std::vector<std::uint16_t> measurements = words_that_travel();
    for (int often = 0; often < 8; ++often) {
        measurements.insert(measurements.end(), declared_.begin(), declared_.end());
    }
    set(Device::governor, governor::send_errors, dice_.below(2));
    set(Device::governor, governor::send_status, dice_.below(2));
    for (unsigned tpdo = facts::first_analogue_tpdo; tpdo <= facts::tpdo_count; ++tpdo) {
        const unsigned offset = tpdo - facts::first_analogue_tpdo;
        if (!may_be_active(tpdo)) {
            continue;
        }
        set(Device::governor, governor::tpdo_cycle + offset, dice_.between(1, 3999));
        for (unsigned word = 0; word < facts::words_per_pdo; ++word) {
            if (!dice_.one_in(3)) {
                set(Device::governor, governor::tpdo_assignment + facts::words_per_pdo * offset + word,
                    dice_.pick(measurements));
            }
        }
    }
}

void RandomPlant::inputs() {
    for (std::uint16_t number = governor::first_switch; number <= governor::last_switch; ++number) {
        if (dice_.one_in(6)) {
            const std::int64_t bit = dice_.between(1, facts::switch_bits);
            set(Device::governor, number, dice_.one_in(2) ? bit : -bit);
            set(Device::governor, governor::type_of(number), governor::canopen_type);
        }
    }
    for (std::uint16_t number = governor::first_sensor; number <= governor::last_sensor; ++number) {
        if (dice_.one_in(6)) {
            set(Device::governor, number, dice_.between(1, facts::sensor_channels));
            set(Device::governor, governor::type_of(number), governor::canopen_type);
        }
    }
    for (unsigned rpdo = 0; rpdo < facts::rpdo_count; ++rpdo) {
        set(Device::governor, governor::rpdo_monitoring + rpdo, dice_.between(0, 3999));
    }
}

std::string RandomPlant::value_in_range(const Row& row) {
    if (!row.choices.empty()) {
        return fmt::format("{}", row.choices[dice_.below(static_cast<std::uint32_t>(row.choices.size()))]);
    }
    const auto lowest = static_cast<std::int64_t>(std::ceil(row.minimum.value_or(-32768)));
    const auto highest = static_cast<std::int64_t>(std::floor(row.maximum.value_or(65535)));
    const std::int64_t value = dice_.between(lowest, std::max(lowest, highest)) + (dice_.one_in(20) ? 1 : 0);
    if (row.decimal && dice_.one_in(2)) {
        return fmt::format("{}.{}", value, dice_.below(100));
    }
    return row.base == parameter::Base::hexadecimal && value >= 0 ? fmt::format("0x{:X}", value)
                                                                  : fmt::format("{}", value);
}

void RandomPlant::anything() {
    for (const Device device : {Device::governor, Device::gateway}) {
        const std::vector<const Row*>& rows = shipped().rows(device);
        for (std::uint32_t n = dice_.below(40); n > 0; --n) {
            const Row& row = *dice_.pick(rows);
            if (row.settable() || dice_.one_in(10)) {
                (device == Device::governor ? governor_ : gateway_)[row.number] = value_in_range(row);
            }
        }
    }
    if (dice_.one_in(4)) {
        gateway_.erase(dice_.pick(std::vector<std::uint16_t>{gateway::own_node, gateway::node_id}));
    }
}

std::vector<std::string> RandomPlant::lines(Device device, const Values& values, std::uint32_t order,
                                            Dice& dice) const {
    std::vector<std::string> all;
    for (auto value = values.begin(); value != values.end();) {
        const Row& row = *shipped().find(device, value->first);
        const std::string key = spelling(row, order != 0 ? &dice : nullptr);
        std::vector<std::string> elements{value->second};
        std::uint16_t next = row.number;
        for (++value; order != 0 && value != values.end() && value->first == ++next &&
                      value->first <= row.list_end && !dice.one_in(4);
             ++value) {
            elements.push_back(value->second);
        }
        all.push_back(elements.size() == 1 ? fmt::format("{} = {}\n", key, elements[0])
                                           : fmt::format("{} = [{}]\n", key, fmt::join(elements, ", ")));
    }
    return all;
}

std::string RandomPlant::text(std::uint32_t order) const {
    Dice dice(order);
    std::vector<std::string> tables;
    for (const Device device : {Device::governor, Device::gateway}) {
        std::vector<std::string> all =
            lines(device, device == Device::governor ? governor_ : gateway_, order, dice);
        if (order != 0) {
            dice.shuffle(all);
        }
        tables.push_back(fmt::format("\n[{}.parameters]\n{}", to_text(device), fmt::join(all, "")));
    }
    if (!nodes_.empty()) {
        std::vector<int> nodes = nodes_;
        if (order != 0) {
            dice.shuffle(nodes);
        }
        tables.push_back(fmt::format("\n[network]\nnodes = [{}]\n", fmt::join(nodes, ", ")));
    }
    tables.push_back(identity_);
    tables.insert(tables.end(), declarations_.begin(), declarations_.end());
    if (order != 0) {
        dice.shuffle(tables);
    }
    // [governor] must stand before its [[governor.declare]].
    tables.insert(tables.begin(), fmt::format("\n[governor]\nmain_cycle_us = {}\n", main_cycle_us_));
    return fmt::format("format = 1\ntitle = \"random\"\n{}", fmt::join(tables, ""));
}

}  // namespace cgw::test
