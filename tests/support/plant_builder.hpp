// Settings made by hand, with a small catalogue of its own, for tests of the rooms behind the parameter file.
#pragma once

#include <algorithm>
#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "config/configuration.hpp"
#include "parameter/catalogue.hpp"
#include "parameter/settings.hpp"

namespace cgw::test {

// Every assigned value stands on a line of its own, in the order of the calls, in column 8; a number
// assigned again takes the new value and place.
class PlantBuilder {
  public:
    PlantBuilder() {
        settings_.path = "plant.toml";
        settings_.governor_table = place(1);
        settings_.gateway_table = place(2);
    }

    PlantBuilder& governor(std::uint16_t number, double value) {
        return assign(parameter::Device::governor, number, value);
    }
    PlantBuilder& gateway(std::uint16_t number, double value) {
        return assign(parameter::Device::gateway, number, value);
    }
    PlantBuilder& governor_list(std::uint16_t first, const std::vector<double>& values) {
        for (const double value : values) {
            governor(first++, value);
        }
        return *this;
    }
    PlantBuilder& without(parameter::Device device, std::uint16_t number) {
        remove(device, number);
        return *this;
    }
    // As the input does when the file's value for the number is wrong and reported.
    PlantBuilder& rejected(parameter::Device device, std::uint16_t number) {
        remove(device, number);
        set_of(device).reject(number);
        return *this;
    }
    PlantBuilder& network_node(std::uint8_t node_id) {
        settings_.network_nodes.push_back({.node_id = node_id, .where = place(++line_)});
        return *this;
    }

    // What every plant needs, so that it has no finding.
    PlantBuilder& minimal() {
        governor(401, 1).governor(403, 2).governor(416, 250).governor(4406, 1);
        assign_at(parameter::Device::gateway, 429, 800, 3);
        return gateway(401, 2).gateway(402, 1).gateway(416, 250).gateway(426, 125).gateway(427, 1).gateway(
            4400, 1);
    }

    parameter::Settings& settings() { return settings_; }
    const parameter::Catalogue& catalogue() { return catalogue_; }
    config::Configuration resolve() { return config::resolve(settings_, catalogue_); }

  private:
    static diagnostic::Location place(std::uint32_t line) {
        return {.path = "plant.toml", .range = {.start = {line, 8}, .end = {line, 9}}};
    }

    parameter::ParameterSet& set_of(parameter::Device device) {
        return device == parameter::Device::governor ? settings_.governor : settings_.gateway;
    }

    void remove(parameter::Device device, std::uint16_t number) {
        parameter::ParameterSet others;
        for (const auto& [other, assignment] : set_of(device).all()) {
            if (other != number) {
                others.assign(assignment);
            }
        }
        set_of(device) = others;
    }

    PlantBuilder& assign(parameter::Device device, std::uint16_t number, double value) {
        return assign_at(device, number, value, ++line_);
    }

    PlantBuilder& assign_at(parameter::Device device, std::uint16_t number, double value,
                            std::uint32_t line) {
        remove(device, number);
        parameter::Assignment assignment;
        assignment.row = catalogue_.find(device, number);
        assignment.value = value;
        assignment.where = place(line);
        set_of(device).assign(std::move(assignment));
        return *this;
    }

    parameter::Row& add(parameter::Device device, std::uint16_t number, const std::string& name) {
        parameter::Row row;
        row.device = device;
        row.number = number;
        names_.push_back(name);
        row.name = names_.back();
        rows_.push_back(row);
        return rows_.back();
    }

    void add_range(parameter::Device device, std::uint16_t first, std::uint16_t last,
                   const std::string& name) {
        for (std::uint16_t number = first; number <= last; ++number) {
            add(device, number, name.empty() ? name : name + "(" + std::to_string(number - first) + ")");
        }
    }

    void add_measurement(std::uint16_t number, std::uint8_t width, bool is_signed, const std::string& name) {
        parameter::Row& row = add(parameter::Device::governor, number, name);
        row.list = parameter::List::measurement;
        row.width = width;
        row.is_signed = is_signed;
    }

    void limit(parameter::Row& row, double minimum, double maximum, std::string_view unit = {}) {
        row.minimum = minimum;
        row.maximum = maximum;
        row.unit = unit;
    }

    void add_governor() {
        using enum parameter::Device;
        limit(add(governor, 400, "CanStartTimeOutDelay"), 0, 100, "s");
        limit(add(governor, 401, "CanMyNodeNumber"), 1, 31);
        limit(add(governor, 403, "CanCMNodeNumber"), 1, 31);
        add_range(governor, 410, 414, "Register");
        limit(add(governor, 416, "CanBaudrate"), 125, 1000, "kbit/s");
        add_range(governor, 810, 849, "");
        add_range(governor, 900, 929, "");
        add_range(governor, 980, 981, "OilPressureEnd");
        limit(add(governor, 4406, "CanCommCMOn"), 0, 1);
        add(governor, 4416, "CanSegmentOrBaudrate");
        add_range(governor, 4810, 4849, "");
        add_range(governor, 4900, 4929, "");
        add(governor, 14401, "CanOpenSendErrors");
        add(governor, 14402, "CanOpenSendStatus");
        add_range(governor, 16400, 16451, "Assign");
        add_range(governor, 16460, 16472, "CanOpTPDO4-16Cyc");
        add_range(governor, 16480, 16483, "CanOpRPDO1-4Cyc");
    }

    void add_measurements() {
        add_measurement(2000, 16, false, "Speed");
        add_measurement(2031, 16, false, "SpeedSetp");
        add_measurement(2300, 16, false, "ActPos");
        add_measurement(2330, 16, false, "ActPosSetpoint");
        add_measurement(2500, 16, true, "TorqueActual");
        add_measurement(2501, 8, false, "Gear");
        add_measurement(2502, 8, true, "Trim");
        add_measurement(2503, 0, false, "Unmeasured");
        add_measurement(2905, 16, false, "OilPressure");
        rows_.back().scaling = parameter::Scaling{
            .internal_maximum = 65535, .external_minimum_parameter = 980, .external_maximum_parameter = 981};
        add_measurement(2908, 16, false, "ChargeAirTemp");
        add_measurement(2917, 16, false, "CurrentLoad");
        add_measurement(3070, 1, false, "ErrCanBus");
        add_measurement(12411, 1, false, "CanOpDCResetErr");
    }

    void add_gateway() {
        using enum parameter::Device;
        limit(add(gateway, 400, "CanStartTimeOutDelay"), 0, 100, "s");
        limit(add(gateway, 401, "CanMyNodeNumber"), 1, 31);
        limit(add(gateway, 402, "CanDCNodeNumber"), 1, 31);
        add_range(gateway, 410, 415, "HzmRegister");
        limit(add(gateway, 416, "HzmCanBaudrate"), 125, 1000, "kbit/s");
        add_range(gateway, 420, 425, "OpenRegister");
        limit(add(gateway, 426, "CanOpenBaudrate"), 125, 1000, "kbit/s");
        limit(add(gateway, 427, "CanOpenMyNodeID"), 1, 127);
        limit(add(gateway, 428, "CanOpenPartnerNodeID"), 0, 127);
        limit(add(gateway, 429, "CanOpHeartBeatTxTime"), 0, 65535, "ms");
        limit(add(gateway, 430, "CanOpHeartBeatRxTime"), 0, 65535, "ms");
        limit(add(gateway, 4400, "HzmCanCommDCon"), 0, 1);
        add(gateway, 4416, "HzmCanSegmOrBaudrate");
        add(gateway, 4426, "CanOpSegmOrBaudrate");
        add_range(gateway, 16404, 16415, "CanOpTPDO5-16ID");
    }

    std::vector<parameter::Row> make_rows() {
        add_governor();
        add_measurements();
        add_gateway();
        std::sort(rows_.begin(), rows_.end(), [](const parameter::Row& a, const parameter::Row& b) {
            return std::pair(a.device, a.number) < std::pair(b.device, b.number);
        });
        return {rows_.begin(), rows_.end()};
    }

    std::deque<std::string> names_;
    std::deque<parameter::Row> rows_;
    std::vector<parameter::Row> shipped_ = make_rows();
    parameter::Catalogue catalogue_{shipped_};
    parameter::Settings settings_;
    std::uint32_t line_ = 9;
};

}  // namespace cgw::test
