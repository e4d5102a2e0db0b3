#include "authoring/rest_of_plant.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "config/numbers.hpp"
#include "parameter/value_text.hpp"

namespace cgw::authoring {

using parameter::Device;
using parameter::Row;
namespace governor = config::governor;
namespace gateway = config::gateway;

RestOfPlant::RestOfPlant(ImageDraft& to, const PlantSource* plant) : to_(to), plant_(plant) {
    if (plant_ != nullptr) {
        take_sections();
    }
}

void RestOfPlant::take_sections() {
    const parameter::Settings& settings = plant_->settings;
    if (settings.main_cycle_us != facts::usual_governor_main_cycle_us) {
        to_.draft.main_cycle_us = settings.main_cycle_us;
    }
    to_.draft.document = settings.document;
    to_.draft.can1_bit_timing = settings.can1_bit_timing;
    to_.draft.can2_bit_timing = settings.can2_bit_timing;
    for (const parameter::NetworkNode& node : settings.network_nodes) {
        to_.draft.network_nodes.push_back(node.node_id);
    }
    if (const auto model = parameter::read_canonical_text(parameter::canonical_text(settings))) {
        draft_rows(*model, to_);
    }
}

std::uint32_t RestOfPlant::main_cycle_us() const {
    return plant_ != nullptr ? plant_->settings.main_cycle_us : facts::usual_governor_main_cycle_us;
}

void RestOfPlant::contradict(Device device, std::uint16_t number, double value) {
    const parameter::Assignment* const other =
        plant_ != nullptr ? plant_->settings.of(device).find(number) : nullptr;
    const Row* const row = to_.catalogue().find(device, number);
    if (other == nullptr || row == nullptr || other->value == value) {
        contradictions_.erase({device, number});
        return;
    }
    contradictions_[{device, number}] =
        fmt::format("{} {}: {}, not {}", parameter::to_text(device), parameter::label(*row),
                    parameter::quantity_text(*row, value), parameter::quantity_text(*row, other->value));
}

void RestOfPlant::say(Device device, std::uint16_t number, double value) {
    said_.insert({device, number});
    to_.set(device, number, value);
    contradict(device, number, value);
}

void RestOfPlant::say_time(Device device, std::uint16_t number, std::uint32_t effective_ms, double asked_ms,
                           const config::CyclicTime* of_plant) {
    if (of_plant == nullptr || of_plant->effective_ms() != effective_ms) {
        say(device, number, asked_ms);
    }
}

void RestOfPlant::say_bit_rate(std::uint32_t kbit) {
    constexpr std::uint32_t bits = 1000;
    if (plant_ != nullptr) {
        const config::BusTiming& timing = plant_->configuration.can2;
        if (config::bit_rate(timing, plant_->settings.can2_bit_timing) == kbit * bits) {
            return;
        }
        say(Device::gateway, gateway::canopen_manual_timing, 0);
    }
    say(Device::gateway, gateway::canopen_bit_rate, kbit);
}

bool RestOfPlant::sends(int tpdo, const std::vector<const Row*>& words) const {
    if (plant_ == nullptr) {
        return false;
    }
    std::vector<const Row*> of_plant;
    for (int word = 1; word <= static_cast<int>(facts::words_per_pdo); ++word) {
        const auto number = static_cast<std::uint16_t>(
            plant_->settings.governor.integer(governor::tpdo_assignment_of(tpdo, word)));
        const Row* const row = to_.catalogue().find(Device::governor, number);
        if (number != 0 && config::transmittable(row)) {
            of_plant.push_back(row);
        }
    }
    return std::equal(words.begin(), words.end(), of_plant.begin(), of_plant.end(),
                      [](const Row* a, const Row* b) { return a == nullptr || a == b; });
}

// The type goes with what it is the type of.
void RestOfPlant::clear(std::uint16_t assignment) {
    if (!said_.contains({Device::governor, assignment})) {
        say(Device::governor, assignment, 0);
        said_.insert({Device::governor, governor::type_of(assignment)});
    }
}

bool RestOfPlant::clear_channel(std::uint8_t channel, const Row* stays) {
    if (plant_ == nullptr) {
        return true;
    }
    std::vector<std::uint16_t> there;
    for (const config::Sensor& sensor : plant_->configuration.sensors) {
        if (sensor.channel == channel) {
            there.push_back(sensor.row->number);
        }
    }
    if (stays != nullptr && std::find(there.begin(), there.end(), stays->number) != there.end()) {
        return false;
    }
    for (const std::uint16_t sensor : there) {
        clear(sensor);
    }
    return true;
}

void RestOfPlant::clear_switches() {
    if (plant_ != nullptr) {
        for (const config::SwitchFunction& function : plant_->configuration.switches) {
            clear(function.row->number);
        }
    }
}

void RestOfPlant::finish() {
    if (plant_ == nullptr) {
        return;
    }
    for (const Device device : {Device::governor, Device::gateway}) {
        for (const auto& [number, assignment] : plant_->settings.of(device).all()) {
            if (!said_.contains({device, number}) && !to_.assign(device, number, assignment.value)) {
                to_.lost.push_back(fmt::format("{} {}, which only a catalogue file knows",
                                               parameter::to_text(device), number));
            }
        }
    }
}

std::vector<std::string> RestOfPlant::contradictions() const {
    std::vector<std::string> all;
    for (const auto& [key, text] : contradictions_) {
        all.push_back(text);
    }
    return all;
}

}  // namespace cgw::authoring
