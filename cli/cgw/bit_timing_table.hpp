// Bit timings as a list, for cgw bit-timing.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bit_timing/timing.hpp"
#include "config/configuration.hpp"
#include "explain/table.hpp"

namespace cgw::cli {

struct TimingLine {
    std::string bus{};                 // "CAN2"; empty where no plant is concerned
    std::string set_by{};              // "426 = 125", "registers 420..425"
    std::optional<double> bit_rate{};  // bit/s
    std::optional<bit_timing::Timing> timing{};
    std::string remark{};
};

// The buses of a plant: the governor's CAN, the gateway's CAN1 and CAN2.
std::vector<TimingLine> timing_lines(const parameter::Settings& settings,
                                     const config::Configuration& configuration);

explain::Table timing_table(const std::vector<TimingLine>& lines);

}  // namespace cgw::cli
