#include "cli/cgw/bit_timing_table.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/numbers.hpp"
#include "config/numbers.hpp"

namespace cgw::cli {
namespace {

using bit_timing::Timing;

std::string percent(double fraction, int digits) {
    return fmt::format("{:.{}f}", fraction * 100, digits);
}

std::string rate_text(double bit_rate) {
    return base::to_text(std::round(bit_rate) / 1000);
}

// The registers' part of a row: blank where only a rate is known.
void append_timing(std::vector<std::string>& row, const TimingLine& line) {
    if (!line.timing) {
        row.resize(row.size() + bit_timing::registers().size() + 6);
        return;
    }
    const Timing& timing = *line.timing;
    std::vector<std::string> values;
    for (const bit_timing::Register& reg : bit_timing::registers()) {
        values.push_back(std::to_string(timing.registers.*reg.member));
    }
    row.push_back(fmt::format("{}", fmt::join(values, ",")));
    row.insert(row.end(), values.begin(), values.end());
    const auto cnf = bit_timing::cnf_registers(timing);
    row.push_back(cnf ? fmt::format("{:02X}", fmt::join(*cnf, " ")) : "");
    row.push_back(std::to_string(timing.quanta()));
    row.push_back(base::to_text(timing.quantum_ns()));
    row.push_back(percent(timing.sample_point(), 1));
    row.push_back(percent(timing.tolerance(), 4));
}

struct Bus {
    std::string_view name;
    std::uint16_t rate_number;
    std::uint16_t first_register;
    int register_count;
    config::BusTiming config::Configuration::*timing;
    std::optional<parameter::BitTiming> parameter::Settings::*controller;  // null: the file cannot state it
};

constexpr Bus buses[] = {
    {"governor", config::governor::bit_rate, config::governor::prescaler, 5,
     &config::Configuration::governor_can, nullptr},
    {"CAN1", config::gateway::hzm_bit_rate, config::gateway::hzm_prescaler, 6, &config::Configuration::can1,
     &parameter::Settings::can1_bit_timing},
    {"CAN2", config::gateway::canopen_bit_rate, config::gateway::canopen_prescaler, 6,
     &config::Configuration::can2, &parameter::Settings::can2_bit_timing},
};

}  // namespace

std::vector<TimingLine> timing_lines(const parameter::Settings& settings,
                                     const config::Configuration& configuration) {
    std::vector<TimingLine> lines;
    for (const Bus& bus : buses) {
        const config::BusTiming& timing = configuration.*bus.timing;
        TimingLine line{.bus = std::string(bus.name)};
        if (!timing.manual) {
            line.set_by = fmt::format("{} = {}", bus.rate_number, timing.bit_rate_kbit);
            line.bit_rate = timing.bit_rate_kbit * 1000.0;
        } else {
            line.set_by =
                fmt::format("{}..{}", bus.first_register, bus.first_register + bus.register_count - 1);
            line.timing = bus.controller == nullptr
                              ? std::nullopt
                              : config::timing_by_hand(timing, settings.*bus.controller);
            line.remark = line.timing ? "" : "clock not stated: no rate can be told (D7)";
            if (line.timing) {
                line.bit_rate = line.timing->bit_rate();
            }
        }
        lines.push_back(std::move(line));
    }
    return lines;
}

explain::Table timing_table(const std::vector<TimingLine>& lines) {
    using explain::everywhere;
    using explain::in_data;
    using explain::in_page;
    using explain::in_text;
    explain::Table table{"timings", false, {}, {}};
    table.columns = {{"bus", "bus"},
                     {"set_by", "set by"},
                     {"kbit_per_s", "kbit/s", everywhere, true},
                     {"registers", "registers", in_text | in_page}};
    for (const bit_timing::Register& reg : bit_timing::registers()) {
        table.columns.push_back({reg.key, reg.name, in_data, true});
    }
    table.columns.insert(table.columns.end(), {{"cnf", "CNF1..3"},
                                               {"quanta", "TQ", everywhere, true},
                                               {"quantum_ns", "TQ in ns", in_data, true},
                                               {"sample_point_percent", "SP %", everywhere, true},
                                               {"tolerance_percent", "osc. %", everywhere, true},
                                               {"bus_length_m", "bus m", everywhere, true},
                                               {"remark", "remark"}});
    for (const TimingLine& line : lines) {
        std::vector<std::string> row{line.bus, line.set_by, line.bit_rate ? rate_text(*line.bit_rate) : ""};
        append_timing(row, line);
        const double sample = line.timing ? line.timing->sample_point() : bit_timing::recommended_sample;
        row.push_back(line.bit_rate ? std::to_string(bit_timing::bus_length(*line.bit_rate, sample).metres)
                                    : "");
        row.push_back(line.remark);
        table.rows.push_back(std::move(row));
    }
    return table;
}

}  // namespace cgw::cli
