#include "runtime/status_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/sha256.hpp"
#include "base/utf8.hpp"
#include "base/wrap.hpp"
#include "runtime/measurements.hpp"
#include "simulation/text.hpp"

namespace cgw::runtime {
namespace {

constexpr std::size_t line_width = 80;
constexpr std::size_t longest_bus_name = 60;

std::string bus_lines(std::string_view which, const BusView& bus) {
    std::string name = base::printable(bus.name);
    if (base::width_of(name) > longest_bus_name) {
        name = "..." + name.substr(name.size() - (longest_bus_name - 3));
    }
    return fmt::format("{}  {}, {}\n      frames received {}, sent {}, lost {}\n", which, name,
                       bus.up ? "up" : "down", bus.received, bus.sent, bus.lost);
}

std::string value_text(const Measurement& measurement) {
    return measurement.row->base == parameter::Base::hexadecimal ? fmt::format("0x{:04X}", measurement.value)
                                                                 : fmt::format("{}", measurement.value);
}

// "not known to this program: 3099 EEPROMErrorCode, …"
std::string list_of(std::string_view what, const std::vector<const parameter::Row*>& rows) {
    constexpr char glue = '_';  // number and name stay on one line; no name has it
    std::string all = std::string(what) + ":";
    for (const parameter::Row* const row : rows) {
        all += fmt::format(" {}{}{}{}", row->number, glue, row->name, row == rows.back() ? "" : ",");
    }
    std::string text;
    for (const std::string& line : base::wrap(all, line_width)) {
        text += line + "\n";
    }
    std::ranges::replace(text, glue, ' ');
    return rows.empty() ? std::string() : text;
}

}  // namespace

std::string status_page(const Diagnosis& diagnosis) {
    const canopen::Slave& slave = diagnosis.gateway->slave();
    std::string text =
        fmt::format("state {}, {:.1f} s after the start\n", simulation::to_text(diagnosis.gateway->state()),
                    static_cast<double>(diagnosis.now) / 1e6);
    text += fmt::format("configuration {}, node {}\n", base::short_id(diagnosis.image->configuration_id()),
                        diagnosis.image->can2().own_node);
    text += bus_lines("CAN1", diagnosis.can1);
    text += bus_lines("CAN2", diagnosis.can2);
    text += fmt::format("      TPDOs {}, RPDOs {}, SDO answers {}, aborts {}, overflows {}\n",
                        slave.transmitter().counters().sent, slave.receiver().counters().received,
                        slave.sdo().counters().answers, slave.sdo().counters().aborts,
                        slave.sdo().counters().overflows);
    const Measurements measurements = measure(diagnosis);
    for (const Measurement& measurement : measurements.known) {
        text += fmt::format("{:>6} {:<24} {:>8}\n", measurement.row->number, measurement.row->name,
                            value_text(measurement));
    }
    text += list_of("not known to this program", measurements.unknown);
    text += list_of("meaning not printed in the manual", measurements.without_meaning);
    return text;
}

}  // namespace cgw::runtime
