#include "authoring/from_data_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "authoring/image_draft.hpp"
#include "base/canopen_text.hpp"
#include "base/utf8.hpp"
#include "config/monitoring_time.hpp"
#include "config/numbers.hpp"
#include "dictionary/ascii.hpp"
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
    explicit Reading(const DataSheetSource& source) : source_(source) {}

    FileFromDataSheet run(const std::vector<std::string>& remarks, const std::string& title) {
        to_.draft.remarks = remarks;
        to_.draft.title = title;
        to_.set(Device::governor, governor::gateway_communication, 1);
        to_.set(Device::gateway, gateway::governor_communication, 1);
        read_node();
        read_identity();
        read_heartbeat();
        read_binary_tpdos();
        read_tpdos();
        read_rpdos();
        read_inputs();
        for (const std::string_view always : not_in_data_sheets) {
            miss(std::string(always));
        }
        return {to_.text(), std::move(undetermined_)};
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
            to_.set(Device::gateway, gateway::node_id, *node_id_);
        } else {
            miss("node-ID (427): --node-id says it");
        }
        if (node != nullptr && node->bit_rate_kbit) {
            to_.set(Device::gateway, gateway::canopen_bit_rate, *node->bit_rate_kbit);
        } else {
            miss("bit rate of CAN2 (426)");
        }
    }

    void read_identity() {
        const std::uint32_t serial = number(object::identity, object::serial_number_sub);
        to_.draft.identity = {number(object::identity, 3), serial >> 16U, serial & 0xFFFFU};  // D32
    }

    void read_heartbeat() {
        const std::uint32_t consumer = number(object::consumer_heartbeat, 1);
        to_.set(Device::gateway, gateway::heartbeat_producer, number(object::producer_heartbeat, 0));
        to_.set(Device::gateway, gateway::heartbeat_consumer, consumer & 0xFFFFU);
        to_.set(Device::gateway, gateway::partner_node_id, consumer >> 16U & 0x7FU);
        if (consumer == 0) {
            miss("partner of the heartbeat (428), which is not monitored");
        }
    }

    bool is_sent(int tpdo) const {
        const std::optional<Value> identifier = value(communication_of(tpdo), object::cob_id_sub);
        return identifier && (identifier->number & facts::pdo_not_valid) == 0;
    }

    static unsigned communication_of(int tpdo) {
        return static_cast<unsigned>(object::tpdo_communication + tpdo - 1);
    }

    void read_binary_tpdos() {
        to_.set(Device::governor, governor::send_errors, is_sent(1) || is_sent(2) ? 1 : 0);
        to_.set(Device::governor, governor::send_status, is_sent(3) ? 1 : 0);
    }

    // The shortest time that becomes as many main cycles as the object's floored one came from (D31).
    static double asked_ms(std::uint32_t effective_ms) {
        constexpr std::uint64_t cycle = facts::usual_governor_main_cycle_us;
        const std::uint64_t cycles = (std::uint64_t{effective_ms} * 1000 + cycle - 1) / cycle;
        return static_cast<double>(config::milliseconds_for(cycles, cycle));
    }

    void read_tpdos() {
        for (int tpdo = config::first_analogue_tpdo; tpdo <= config::tpdo_count; ++tpdo) {
            const unsigned communication = communication_of(tpdo);
            const std::optional<Value> identifier = value(communication, object::cob_id_sub);
            if (tpdo >= gateway::first_tpdo_of_own_identifier && identifier) {
                to_.set(Device::gateway, gateway::tpdo_identifier_of(tpdo),
                        static_cast<double>(identifier->resolve(node_id_.value_or(0)) & identifier_mask));
            }
            to_.set(Device::governor, governor::tpdo_cycle_of(tpdo),
                    asked_ms(number(communication, object::event_timer_sub)));
            read_words(tpdo);
        }
    }

    void read_words(int tpdo) {
        const auto mapping = static_cast<unsigned>(object::tpdo_mapping + tpdo - 1);
        const std::uint32_t words = std::min<std::uint32_t>(number(mapping, 0), facts::words_per_pdo);
        for (std::uint8_t word = 1; word <= words; ++word) {
            const std::uint32_t entry = number(mapping, word);
            const Variable* const mapped = find(entry >> 16U, static_cast<std::uint8_t>(entry >> 8U));
            const Row* const row = mapped != nullptr ? row_named(mapped->name, "Parameter ") : nullptr;
            if (row != nullptr) {
                to_.set(Device::governor, governor::tpdo_assignment_of(tpdo, word), row->number);
            } else {
                miss(fmt::format("word {} of {}: {}{} is the name of no parameter that can be sent", word,
                                 base::pdo_name(true, static_cast<unsigned>(tpdo)),
                                 base::object_text(entry >> 16U, entry >> 8U & 0xFFU),
                                 mapped != nullptr ? " " + base::printable(mapped->name) : ""));
            }
        }
    }

    // "Speed", "Speed 2" where two objects have the same parameter, "Sensor 902" for a row without a name.
    const Row* row_named(std::string_view name, std::string_view number_prefix) const {
        if (name.starts_with(number_prefix)) {
            return row_numbered(name.substr(number_prefix.size()));
        }
        if (const Row* const row = row_of_ascii(name)) {
            return row;
        }
        const std::size_t blank = name.find_last_of(' ');
        return blank != std::string_view::npos ? row_of_ascii(name.substr(0, blank)) : nullptr;
    }

    const Row* row_numbered(std::string_view digits) const {
        std::uint16_t found = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), found);
        return error == std::errc() && end != digits.data() ? to_.catalogue().find(Device::governor, found)
                                                            : nullptr;
    }

    const Row* row_of_ascii(std::string_view name) const {
        const std::vector<const Row*>& rows = to_.catalogue().rows(Device::governor);
        const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row* row) {
            return !row->name.empty() && dictionary::to_ascii(row->name) == name;
        });
        return found != rows.end() ? *found : nullptr;
    }

    void read_rpdos() {
        for (int rpdo = 1; rpdo <= config::rpdo_count; ++rpdo) {
            const auto communication = static_cast<unsigned>(object::rpdo_communication + rpdo - 1);
            to_.set(Device::governor, governor::rpdo_monitoring_of(rpdo),
                    asked_ms(number(communication, object::event_timer_sub)));
        }
    }

    void read_inputs() {
        if (number(object::binary_inputs, 0) != 0) {
            miss("which switch functions come in which bits of RPDO1 (8nn, 48nn)");
        }
        const std::uint32_t channels = number(object::sensors, 0);
        for (std::uint8_t channel = 1; channel <= std::min<std::uint32_t>(channels, facts::sensor_channels);
             ++channel) {
            read_channel(channel);
        }
        if (channels != 0) {
            miss("further sensors on a channel that several share (9nn)");
        }
    }

    void read_channel(std::uint8_t channel) {
        const Variable* const entry = find(object::sensors, channel);
        const Row* const row = entry != nullptr ? row_named(entry->name, "Sensor ") : nullptr;
        if (row != nullptr && facts::is_sensor(row->number)) {
            to_.set(Device::governor, row->number, channel);
            to_.set(Device::governor, governor::type_of(row->number), governor::canopen_type);
        } else if (entry != nullptr && !entry->name.starts_with("Unused")) {
            miss(fmt::format("the sensor of channel {}: {} is the name of none", channel,
                             base::printable(entry->name)));
        }
    }

    const DataSheetSource& source_;
    ImageDraft to_;
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
