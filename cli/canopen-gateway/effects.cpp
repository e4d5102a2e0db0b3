#include "cli/canopen-gateway/effects.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <map>

#include "base/canopen_text.hpp"
#include "cli/canopen-gateway/display.hpp"
#include "facts/gateway.hpp"
#include "simulation/plc.hpp"
#include "simulation/scaling.hpp"
#include "wire/little_endian.hpp"

namespace cgw::gateway_cli {
namespace {

constexpr Time settling = 2'000'000;  // after a change, until its effect is shown
constexpr std::size_t transmit_pdos = 16;
constexpr std::size_t first_rpdo = facts::tpdo_count;
constexpr int visible_change = 650;  // of a word's 65536 steps
constexpr std::size_t most_changes_shown = 4;
constexpr std::size_t name_width = 26;

// What to change, the most telling first.
constexpr std::uint16_t telling_sensors[] = {900, 901, 917, 906};
constexpr std::uint16_t telling_switches[] = {827, 835, 811};

using Words = std::map<std::uint16_t, std::uint16_t>;  // parameter to word

Words words_of(PlantRun& plant_run) {
    return simulation::received_words(plant_run.node(), plant_run.image());
}

// Words that carry no parameter are TPDO1..3's (D20, D21).
std::string binary_name(const image::MappedObject& mapped) {
    constexpr unsigned bits = facts::word_bits;
    const unsigned first = facts::error_number(bits * (mapped.sub_index - 1U));
    const bool errors = mapped.sub_index <= device::error_words;
    return fmt::format("{} {}", base::object_text(mapped.index, mapped.sub_index),
                       errors ? fmt::format("errors {}..{}", first, first + bits - 1) : "engine state");
}

void show_words(PlantRun& plant_run, const image::Pdo& pdo, const frame::Frame& frame) {
    for (std::size_t word = 0; word < pdo.word_count; ++word) {
        const std::uint16_t value = wire::load_u16(&frame.data[2 * word]);
        const image::MappedObject& mapped = pdo.mapping[word];
        const bool measured = mapped.parameter != 0;
        const std::string name =
            measured ? parameter_text(plant_run.image(), mapped.parameter) : binary_name(mapped);
        plant_run.detail(fmt::format("  {:<{}} {:>18}", clipped(name, name_width), name_width,
                                     measured ? value_text(plant_run.image(), mapped.parameter, value)
                                              : fmt::format("0x{:04X}", value)));
    }
}

void show_changes(PlantRun& plant_run, const Words& before) {
    std::size_t shown = 0;
    for (const auto& [number, word] : words_of(plant_run)) {
        const auto old = before.find(number);
        if (old == before.end() || shown == most_changes_shown) {
            continue;
        }
        if (std::abs(static_cast<std::int16_t>(word - old->second)) >= visible_change) {
            plant_run.detail(fmt::format("  {:<{}} {:>18} -> {}",
                                         clipped(parameter_text(plant_run.image(), number), name_width),
                                         name_width, value_text(plant_run.image(), number, old->second),
                                         value_text(plant_run.image(), number, word)));
            ++shown;
        }
    }
    if (shown == 0) {
        plant_run.detail("  no word of a transmit PDO shows it");
    }
}

// The most telling one that there is, else the first.
bool choose_sensor(const image::Image& image, image::Sensor& sensor) {
    for (const std::uint16_t number : telling_sensors) {
        if (const auto found = simulation::find_sensor(image, number)) {
            sensor = *found;
            return true;
        }
    }
    if (image.sensor_count() != 0) {
        sensor = image.sensor(0);
    }
    return image.sensor_count() != 0;
}

bool choose_switch(const image::Image& image, image::SwitchFunction& function) {
    for (const std::uint16_t number : telling_switches) {
        if (const auto found = simulation::find_switch(image, number)) {
            function = *found;
            return true;
        }
    }
    if (image.switch_count() != 0) {
        function = image.switch_function(0);
    }
    return image.switch_count() != 0;
}

std::uint16_t& output_of(PlantRun& plant_run, const image::Sensor& sensor) {
    return plant_run.plc()
        .outputs()[facts::rpdo_of_channel(sensor.channel) - 1U][facts::word_of_channel(sensor.channel) - 1U];
}

// Sends the changed outputs, lets the plant follow, and shows what followed.
void follow(PlantRun& plant_run) {
    const Words before = words_of(plant_run);
    plant_run.plc().send_outputs();
    plant_run.run_for(settling);
    show_changes(plant_run, before);
}

void change_sensor(PlantRun& plant_run, const image::Sensor& sensor) {
    const image::Image& image = plant_run.image();
    const simulation::Scale scale = simulation::scale_of(image, sensor.number, 0, 100);
    std::uint16_t& word = output_of(plant_run, sensor);
    const std::uint16_t old = word;
    const double span = scale.external_maximum - scale.external_minimum;
    const double part = (scale.to_engineering(old) - scale.external_minimum) / span;
    word = scale.to_word(scale.external_minimum + span * (part > 0.85 ? part - 0.15 : part + 0.15));
    const image::Pdo pdo = image.pdo(first_rpdo + facts::rpdo_of_channel(sensor.channel) - 1U);
    plant_run.say(fmt::format("{} {} changes {}", pdo_text(pdo), base::identifier_text(pdo.cob_id),
                              parameter_text(image, sensor.number)));
    plant_run.detail(fmt::format("  from {} to {}; then", value_text(image, sensor.number, old),
                                 value_text(image, sensor.number, word)));
    follow(plant_run);
}

void toggle_switch(PlantRun& plant_run, const image::SwitchFunction& function) {
    std::uint16_t& word = plant_run.plc().outputs()[0][0];
    const auto mask = static_cast<std::uint16_t>(1U << (function.bit - 1U));
    word = static_cast<std::uint16_t>(word ^ mask);
    const bool active = ((word & mask) != 0) != function.low_active;
    plant_run.say(fmt::format("RPDO1 {} switches {} {}, bit {} is {}",
                              base::identifier_text(plant_run.image().pdo(first_rpdo).cob_id),
                              parameter_text(plant_run.image(), function.number), active ? "on" : "off",
                              function.bit, (word & mask) != 0 ? 1 : 0));
    follow(plant_run);
}

}  // namespace

void show_transmit_pdos(PlantRun& plant_run) {
    std::size_t active = 0;
    for (std::size_t position = 0; position < transmit_pdos; ++position) {
        const image::Pdo pdo = plant_run.image().pdo(position);
        if (!pdo.active) {
            continue;
        }
        ++active;
        const auto received = plant_run.node().received(pdo.cob_id);
        const std::string rhythm =
            pdo.cycles == 0 ? "on change"
                            : fmt::format("every {:.3f} ms", static_cast<double>(pdo.effective_us) / 1000);
        plant_run.say(fmt::format("{} {} {}, {} received", pdo_text(pdo), base::identifier_text(pdo.cob_id),
                                  rhythm, received ? received->count : 0));
        if (received) {
            show_words(plant_run, pdo, received->last);
        }
    }
    if (active == 0) {
        plant_run.say("no transmit PDO is active in this configuration");
    }
}

void show_effects(PlantRun& plant_run) {
    image::Sensor sensor;
    image::SwitchFunction function;
    const bool has_sensor = choose_sensor(plant_run.image(), sensor);
    const bool has_switch = choose_switch(plant_run.image(), function);
    if (!has_sensor && !has_switch && !plant_run.over()) {
        plant_run.say("no receive PDO is active in this configuration");
    }
    if (has_sensor && !plant_run.over()) {
        change_sensor(plant_run, sensor);
    }
    if (has_switch && !plant_run.over()) {
        toggle_switch(plant_run, function);
    }
}

}  // namespace cgw::gateway_cli
