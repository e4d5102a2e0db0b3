#include "authoring/from_data_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "authoring/entry_names.hpp"
#include "authoring/image_draft.hpp"
#include "authoring/rest_of_plant.hpp"
#include "base/canopen_text.hpp"
#include "base/utf8.hpp"
#include "config/monitoring_time.hpp"
#include "config/numbers.hpp"
#include "facts/communication.hpp"

namespace cgw::authoring {
namespace {

using dictionary::Value;
using dictionary::Variable;
using parameter::Device;
using parameter::Row;
namespace governor = config::governor;
namespace gateway = config::gateway;
namespace object = facts::object;

constexpr std::uint32_t identifier_mask = 0x1FFFFFFF;

class Reading {
  public:
    explicit Reading(const DataSheetSource& source) : source_(source), rest_(to_, source.plant) {}

    FileFromDataSheet run(const std::vector<std::string>& remarks, const std::string& title) {
        to_.draft.remarks = remarks;
        to_.draft.title = title;
        rest_.say(Device::governor, governor::gateway_communication, 1);
        rest_.say(Device::gateway, gateway::governor_communication, 1);
        read_node();
        read_identity();
        read_heartbeat();
        read_binary_tpdos();
        read_tpdos();
        read_rpdos();
        read_inputs();
        if (rest_.plant() == nullptr) {
            for (const std::string_view always : not_in_data_sheets) {
                miss(std::string(always));
            }
        }
        rest_.finish();
        for (std::string& each : to_.lost) {
            miss(std::move(each));
        }
        return {to_.text(), std::move(undetermined_), rest_.contradictions()};
    }

  private:
    static constexpr std::string_view not_in_data_sheets[] = {
        "nodes and bit rate of CAN1 (governor 401, 403, 416; gateway 401, 402, 416)",
        "main cycle of the governor: cycle times are taken for one of 15.625 ms",
        "start-up delays (400)",
        "words of TPDOs that are not sent, and gaps between words that closed up",
        "switches and sensors that do not come over CANopen",
    };

    void miss(std::string what) { undetermined_.push_back(std::move(what)); }

    const Variable* find(unsigned index, std::uint8_t sub_index) const {
        return source_.dictionary.find(static_cast<std::uint16_t>(index), sub_index);
    }

    // What the device starts with; nothing where the file does not say.
    std::optional<Value> value(unsigned index, std::uint8_t sub_index) const {
        const Variable* const variable = find(index, sub_index);
        if (variable == nullptr || (variable->no_default && !variable->parameter_value)) {
            return std::nullopt;
        }
        return variable->parameter_value.value_or(variable->default_value);
    }
    std::uint32_t number(unsigned index, std::uint8_t sub_index) const {
        const std::optional<Value> found = value(index, sub_index);
        return found ? static_cast<std::uint32_t>(found->resolve(node_id_.value_or(0))) : 0;
    }

    void read_node() {
        const dictionary::Commissioning* const node = source_.commissioning;
        node_id_ = source_.node_id;
        if (!node_id_ && node != nullptr) {
            node_id_ = node->node_id;
        }
        const std::optional<Value> request = value(object::sdo_server, 1);
        if (!node_id_ && request && !request->node_id_relative) {
            node_id_ = static_cast<std::uint8_t>(request->number & facts::cob::node_mask);
        }
        if (node_id_) {
            rest_.say(Device::gateway, gateway::node_id, *node_id_);
        } else if (rest_.plant() != nullptr) {
            node_id_ = rest_.plant()->configuration.node_id;
        } else {
            miss("node-ID (427): --node-id says it");
        }
        if (node != nullptr && node->bit_rate_kbit) {
            rest_.say_bit_rate(*node->bit_rate_kbit);
        } else if (rest_.plant() == nullptr) {
            miss("bit rate of CAN2 (426)");
        }
    }

    void read_identity() {
        const std::uint32_t serial = number(object::identity, object::serial_number_sub);
        to_.draft.identity = {number(object::identity, 3), serial >> 16U, serial & 0xFFFFU};  // D32
    }

    void read_heartbeat() {
        const std::uint32_t consumer = number(object::consumer_heartbeat, 1);
        say_heartbeat(gateway::heartbeat_producer, number(object::producer_heartbeat, 0) & 0xFFFFU,
                      &config::Configuration::heartbeat_producer);
        say_heartbeat(gateway::heartbeat_consumer, consumer & 0xFFFFU,
                      &config::Configuration::heartbeat_consumer);
        if (consumer != 0) {
            rest_.say(Device::gateway, gateway::partner_node_id, consumer >> 16U & 0x7FU);
        } else if (rest_.plant() == nullptr) {
            miss("partner of the heartbeat (428), which is not monitored");
        }
    }

    void say_heartbeat(std::uint16_t number, std::uint32_t effective_ms,
                       config::CyclicTime config::Configuration::*time) {
        const PlantSource* const plant = rest_.plant();
        rest_.say_time(Device::gateway, number, effective_ms, effective_ms,
                       plant != nullptr ? &(plant->configuration.*time) : nullptr);
    }

    bool is_valid(unsigned communication) const {
        const std::optional<Value> identifier = value(communication, object::cob_id_sub);
        return identifier && (identifier->number & facts::pdo_not_valid) == 0;
    }
    bool is_sent(int tpdo) const { return is_valid(communication_of(tpdo)); }

    static unsigned communication_of(int tpdo) {
        return static_cast<unsigned>(object::tpdo_communication + tpdo - 1);
    }

    void read_binary_tpdos() {
        rest_.say(Device::governor, governor::send_errors, is_sent(1) || is_sent(2) ? 1 : 0);
        rest_.say(Device::governor, governor::send_status, is_sent(3) ? 1 : 0);
    }

    // The shortest time that becomes as many main cycles as the object's floored one came from (D31).
    double asked_ms(std::uint32_t effective_ms) const {
        const std::uint32_t cycle = rest_.main_cycle_us();
        const std::uint64_t cycles = (std::uint64_t{effective_ms} * 1000 + cycle - 1) / cycle;
        return static_cast<double>(config::milliseconds_for(cycles, cycle));
    }

    void read_tpdos() {
        for (int tpdo = config::first_analogue_tpdo; tpdo <= config::tpdo_count; ++tpdo) {
            const std::optional<Value> identifier = value(communication_of(tpdo), object::cob_id_sub);
            if (tpdo >= gateway::first_tpdo_of_own_identifier && identifier) {
                rest_.say(Device::gateway, gateway::tpdo_identifier_of(tpdo),
                          static_cast<double>(identifier->resolve(node_id_.value_or(0)) & identifier_mask));
            }
            read_cycle(tpdo);
            read_words(tpdo);
        }
    }

    // Of a TPDO that is not sent the data sheet tells neither time nor words.
    void read_cycle(int tpdo) {
        const std::uint32_t timer = number(communication_of(tpdo), object::event_timer_sub);
        const PlantSource* const plant = rest_.plant();
        if (plant == nullptr || is_sent(tpdo)) {
            rest_.say_time(Device::governor, governor::tpdo_cycle_of(tpdo), timer, asked_ms(timer),
                           plant != nullptr ? &plant->configuration.tpdo(tpdo).time : nullptr);
        } else if (plant->configuration.tpdo(tpdo).active) {
            rest_.say(Device::governor, governor::tpdo_cycle_of(tpdo), 0);
        }
    }

    void read_words(int tpdo) {
        const auto mapping = static_cast<unsigned>(object::tpdo_mapping + tpdo - 1);
        const std::uint32_t count = std::min<std::uint32_t>(number(mapping, 0), facts::words_per_pdo);
        std::vector<const Row*> words;
        for (std::uint8_t word = 1; word <= count; ++word) {
            const std::uint32_t entry = number(mapping, word);
            const Variable* const mapped = find(entry >> 16U, static_cast<std::uint8_t>(entry >> 8U));
            words.push_back(mapped != nullptr ? row_of_entry(to_.catalogue(), mapped->name, "Parameter ")
                                              : nullptr);
        }
        if (rest_.sends(tpdo, words) || (rest_.plant() != nullptr && !is_sent(tpdo))) {
            return;
        }
        for (std::uint8_t word = 1; word <= facts::words_per_pdo; ++word) {
            if (word > count || words[word - 1U] != nullptr) {
                rest_.say(Device::governor, governor::tpdo_assignment_of(tpdo, word),
                          word <= count ? words[word - 1U]->number : 0);
            } else {
                miss_word(tpdo, word, number(mapping, word));
            }
        }
    }

    void miss_word(int tpdo, std::uint8_t word, std::uint32_t entry) {
        const Variable* const mapped = find(entry >> 16U, static_cast<std::uint8_t>(entry >> 8U));
        miss(fmt::format("word {} of {}: {}{} is the name of no parameter that can be sent", word,
                         base::pdo_name(true, static_cast<unsigned>(tpdo)),
                         base::object_text(entry >> 16U, entry >> 8U & 0xFFU),
                         mapped != nullptr ? " " + base::printable(mapped->name) : ""));
    }

    // Of an RPDO that is not used the data sheet tells no time.
    void read_rpdos() {
        const PlantSource* const plant = rest_.plant();
        for (int rpdo = 1; rpdo <= config::rpdo_count; ++rpdo) {
            const auto communication = static_cast<unsigned>(object::rpdo_communication + rpdo - 1);
            const std::uint32_t timer = number(communication, object::event_timer_sub);
            if (plant == nullptr || is_valid(communication)) {
                rest_.say_time(Device::governor, governor::rpdo_monitoring_of(rpdo), timer, asked_ms(timer),
                               plant != nullptr ? &plant->configuration.rpdo(rpdo).time : nullptr);
            }
        }
    }

    void read_inputs() {
        read_switches();
        const std::uint32_t channels = number(object::sensors, 0);
        for (std::uint8_t channel = 1; channel <= facts::sensor_channels; ++channel) {
            read_channel(channel, channel <= channels);
        }
        if (channels != 0 && rest_.plant() == nullptr) {
            miss("further sensors on a channel that several share (9nn)");
        }
    }

    void read_switches() {
        const PlantSource* const plant = rest_.plant();
        const bool has_switches = find(object::binary_inputs, object::switches_sub) != nullptr;
        if (!has_switches) {
            rest_.clear_switches();
        }
        if (plant == nullptr ? number(object::binary_inputs, 0) != 0
                             : has_switches && plant->configuration.switches.empty()) {
            miss("which switch functions come in which bits of RPDO1 (8nn, 48nn)");
        }
    }

    void read_channel(std::uint8_t channel, bool exists) {
        const Variable* const entry = exists ? find(object::sensors, channel) : nullptr;
        const Row* const row =
            entry != nullptr ? row_of_entry(to_.catalogue(), entry->name, "Sensor ") : nullptr;
        const bool is_sensor = row != nullptr && facts::is_sensor(row->number);
        if (!is_sensor && entry != nullptr && !entry->name.starts_with("Unused")) {
            miss(fmt::format("the sensor of channel {}: {} is the name of none", channel,
                             base::printable(entry->name)));
            return;
        }
        if (rest_.clear_channel(channel, is_sensor ? row : nullptr) && is_sensor) {
            rest_.say(Device::governor, row->number, channel);
            rest_.say(Device::governor, governor::type_of(row->number), governor::canopen_type);
        }
    }

    const DataSheetSource& source_;
    ImageDraft to_;
    RestOfPlant rest_;
    std::optional<std::uint8_t> node_id_;
    std::vector<std::string> undetermined_;
};

}  // namespace

bool describes_gateway(const dictionary::Dictionary& dictionary) {
    const Variable* const vendor = dictionary.find(object::identity, 1);
    const Variable* const product = dictionary.find(object::identity, 2);
    return vendor != nullptr && product != nullptr && vendor->default_value.number == facts::vendor_number &&
           product->default_value.number == facts::product_number;
}

FileFromDataSheet file_from_data_sheet(const DataSheetSource& source, const std::vector<std::string>& remarks,
                                       const std::string& title) {
    return Reading(source).run(remarks, title);
}

}  // namespace cgw::authoring
