#include "scenario/act.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>
#include <vector>

#include "base/canopen_text.hpp"
#include "base/numbers.hpp"
#include "canopen/words.hpp"
#include "facts/gateway.hpp"
#include "scenario/run.hpp"
#include "simulation/faults.hpp"
#include "simulation/scaling.hpp"
#include "simulation/text.hpp"

namespace cgw::scenario {
namespace {

using simulation::Plant;

constexpr Word sources[] = {{"RPDO1", ""}, {"RPDO2", ""},     {"RPDO3", ""},
                            {"RPDO4", ""}, {"heartbeat", ""}, {"all", "all of these"}};
static_assert(std::size(sources) == facts::rpdo_count + 2U);

constexpr Word addressees[] = {{"gateway", ""}, {"all", "all nodes"}};
constexpr Plant::BusName buses[] = {Plant::BusName::can1, Plant::BusName::can2};
constexpr Word bus_names[] = {{"CAN1", "between governor and gateway"}, {"CAN2", "the CANopen bus"}};
constexpr Word devices[] = {{"gateway", ""}, {"governor", ""}};

bool is_governor(const Step& step) {
    return step.subject().integer == 1;
}

std::string_view bus_name(const Step& step) {
    return bus_names[step.subject().integer].name;
}

std::uint16_t number_of(const Step& step) {
    return static_cast<std::uint16_t>(step.subject().integer);
}

simulation::Installation& plant_of(Run& run) {
    return run.installation();
}

std::string name_of(Run& run, const Step& step) {
    return simulation::parameter_text(plant_of(run).image(), number_of(step));
}

// Applies to RPDO1..4, to the heartbeat, or to all that there is.
void set_silent(Run& run, const Step& step, bool silent) {
    const auto source = static_cast<std::size_t>(step.subject().integer);
    const bool all = source == facts::rpdo_count + 1U;
    simulation::Plc& plc = plant_of(run).plc();
    for (std::uint8_t rpdo = 1; rpdo <= facts::rpdo_count; ++rpdo) {
        if (all || source == rpdo - 1U) {
            plc.silence_rpdo(rpdo, silent);
        }
    }
    if (all || source == facts::rpdo_count) {
        plc.silence_heartbeat(silent);
    }
}

std::string source_text(const Step& step) {
    const auto source = static_cast<std::size_t>(step.subject().integer);
    return source < facts::rpdo_count    ? std::string(sources[source].name)
           : source == facts::rpdo_count ? "the heartbeat"
                                         : "RPDOs and heartbeat";
}

Outcome flag(Run& run, const Step& step, bool faulty) {
    simulation::Plc& plc = plant_of(run).plc();
    plc.flag_sensor(number_of(step), faulty);
    plc.send_outputs();
    return {fmt::format("the PLC {} {}", faulty ? "flags" : "no longer flags", name_of(run, step))};
}

canopen::sdo::Multiplexer object_of(const Step& step) {
    return {static_cast<std::uint16_t>(step.subject().integer >> 8),
            static_cast<std::uint8_t>(step.subject().integer & 0xFF)};
}

Outcome asked(Run& run, const Step& step, bool taken, std::string_view verb) {
    const canopen::sdo::Multiplexer object = object_of(step);
    const std::string text = base::object_text(object.index, object.sub_index);
    if (taken) {
        run.commentary().asked(text);
    }
    return {fmt::format("the PLC {} {}", verb, text), taken, "the transfer before it is not over"};
}

Outcome set_fault(Run& run, const Step& step, bool present) {
    const simulation::NamedFault& fault =
        simulation::named_faults()[static_cast<std::size_t>(step.subject().integer)];
    std::visit([&](auto cause) { plant_of(run).plant().report(cause, present); }, fault.cause);
    return {fmt::format("fault {} {}", fault.name, present ? "appears" : "is gone")};
}

}  // namespace

std::span<const Word> source_words() {
    return sources;
}
std::span<const Word> command_words() {
    static const std::vector<Word> words = [] {
        std::vector<Word> all;
        all.reserve(canopen::nmt_commands.size());
        for (const canopen::NmtCommandWords& row : canopen::nmt_commands) {
            all.push_back({row.word, ""});
        }
        return all;
    }();
    return words;
}
std::span<const Word> addressee_words() {
    return addressees;
}
std::span<const Word> bus_words() {
    return bus_names;
}
std::span<const Word> device_words() {
    return devices;
}
std::span<const Word> fault_words() {
    static const std::vector<Word> words = [] {
        std::vector<Word> all;
        for (const simulation::NamedFault& fault : simulation::named_faults()) {
            all.push_back({fault.name, fault.summary});
        }
        return all;
    }();
    return words;
}

Outcome set_sensor(Run& run, const Step& step) {
    const image::Image& image = plant_of(run).image();
    const std::uint16_t word =
        simulation::scale_of(image, number_of(step), 0, 100).to_word(step.values[1].number);
    plant_of(run).plc().set_sensor(number_of(step), word);
    plant_of(run).plc().send_outputs();
    return {fmt::format("the PLC sends {} at {}", name_of(run, step),
                        simulation::value_text(image, number_of(step), word))};
}

Outcome set_switch(Run& run, const Step& step) {
    const bool on = step.values[1].integer != 0;
    plant_of(run).plc().set_switch(number_of(step), on);
    plant_of(run).plc().send_outputs();
    return {fmt::format("the PLC switches {} {}", name_of(run, step), on ? "on" : "off")};
}

Outcome fail_sensor(Run& run, const Step& step) {
    return flag(run, step, true);
}

Outcome repair_sensor(Run& run, const Step& step) {
    return flag(run, step, false);
}

Outcome silence(Run& run, const Step& step) {
    set_silent(run, step, true);
    return {fmt::format("the PLC stops sending {}", source_text(step))};
}

Outcome resume(Run& run, const Step& step) {
    set_silent(run, step, false);
    return {fmt::format("the PLC sends {} again", source_text(step))};
}

Outcome command(Run& run, const Step& step) {
    simulation::Installation& plant = plant_of(run);
    const auto row = static_cast<std::size_t>(step.subject().integer);
    const bool all = step.values[1].integer == 1;
    const std::uint8_t node = all ? canopen::all_nodes : plant.image().can2().own_node;
    const canopen::NmtCommandWords& command = canopen::nmt_commands.at(row);
    const bool sent = plant.node().master().command(command.command, node);
    return {fmt::format("the PLC commands {}", command.word), sent, "the bus takes no frame"};
}

Outcome upload(Run& run, const Step& step) {
    return asked(run, step, plant_of(run).node().master().sdo().upload(object_of(step)), "reads");
}

Outcome write(Run& run, const Step& step) {
    constexpr std::uint8_t usual_length = 2;
    const std::uint8_t length =
        step.values[2].given ? static_cast<std::uint8_t>(step.values[2].integer) : usual_length;
    const auto value = static_cast<std::uint32_t>(step.values[1].integer);
    return asked(run, step, plant_of(run).node().master().sdo().download(object_of(step), value, length),
                 "writes");
}

Outcome drop(Run& run, const Step& step) {
    plant_of(run).plant().connect(buses[step.subject().integer], false);
    return {fmt::format("{} is cut", bus_name(step))};
}

Outcome restore(Run& run, const Step& step) {
    plant_of(run).plant().connect(buses[step.subject().integer], true);
    return {fmt::format("{} is mended", bus_name(step))};
}

Outcome reset(Run& run, const Step& step) {
    if (is_governor(step)) {
        plant_of(run).plant().reset_governor();
    } else {
        plant_of(run).plant().reset_gateway();
    }
    return {fmt::format("the {} is reset", is_governor(step) ? "governor" : "gateway")};
}

Outcome saturate(Run& run, const Step& step) {
    frame::Frame frame;
    frame.id = static_cast<std::uint32_t>(step.values[1].integer);
    frame.extended = frame.id > facts::cob::highest;
    frame.length = 8;
    const Time duration = static_cast<Time>(step.values[2].integer);
    plant_of(run).jammer(buses[step.subject().integer]).start(frame, plant_of(run).now() + duration);
    return {fmt::format("{} is full of {} for {} s", bus_name(step), base::identifier_text(frame.id),
                        base::to_text(static_cast<double>(duration) / 1e6))};
}

Outcome report_fault(Run& run, const Step& step) {
    return set_fault(run, step, true);
}

Outcome mend_fault(Run& run, const Step& step) {
    return set_fault(run, step, false);
}

Outcome clear_errors(Run& run, const Step& step) {
    if (is_governor(step)) {
        plant_of(run).plant().governor().clear_errors();
    } else {
        plant_of(run).plant().clear_gateway_errors();
    }
    return {fmt::format("errors are cleared at the {}", is_governor(step) ? "governor" : "gateway")};
}

std::string sensor_cannot_be(const image::Image& image, const Step& step) {
    const simulation::Scale scale = simulation::scale_of(image, number_of(step), 0, 100);
    const double value = step.values[1].number;
    const double least = std::min(scale.external_minimum, scale.external_maximum);
    const double greatest = std::max(scale.external_minimum, scale.external_maximum);
    if (value >= least && value <= greatest) {
        return "";
    }
    const std::string_view unit = simulation::unit_text(image, number_of(step));
    return fmt::format("{} cannot be {}, it reaches from {} to {}{}{}",
                       simulation::parameter_text(image, number_of(step)), base::to_text(value),
                       base::to_text(least), base::to_text(greatest), unit.empty() ? "" : " ", unit);
}

std::string value_too_long(const image::Image&, const Step& step) {
    const std::int64_t bytes = step.values[2].given ? step.values[2].integer : 2;
    if (bytes == 3) {
        return "an expedited transfer of this PLC has 1, 2 or 4 bytes";
    }
    const bool fits = step.values[1].integer < (std::int64_t{1} << (8 * bytes));
    return fits ? "" : fmt::format("{} does not fit into {} bytes", step.values[1].integer, bytes);
}

}  // namespace cgw::scenario
