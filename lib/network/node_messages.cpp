#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/canopen_text.hpp"
#include "facts/communication.hpp"
#include "facts/identifiers.hpp"
#include "network/source_parts.hpp"
#include "network/sources.hpp"

namespace cgw::network {
namespace {

using dictionary::Dictionary;
using dictionary::Variable;
namespace cob = facts::cob;

constexpr std::uint16_t first_receive_pdo = 0x1400;
constexpr std::uint16_t first_transmit_pdo = 0x1800;
constexpr std::uint16_t mapping_offset = 0x200;
constexpr std::uint16_t pdo_numbers = 0x200;
constexpr std::uint32_t invalid_bit = 1U << 31U;  // of a COB-ID
constexpr std::uint32_t producer_bit = 1U << 30U;
constexpr std::uint32_t extended_bit = 1U << 29U;

constexpr std::uint64_t us_per_ms = 1'000;
constexpr std::uint64_t us_per_inhibit_step = 100;

class Node {
  public:
    Node(const Dictionary& dictionary, std::uint8_t node_id, const Places& places)
        : dictionary_(dictionary), node_id_(node_id), places_(places) {}

    ForeignNode read(const diagnostic::Location& whole) {
        add_sync();
        add_emergency();
        add_heartbeat();
        add_sdo(found_.messages, node_id_, whole);
        for (const dictionary::Object& object : dictionary_.objects) {
            if (object.index >= first_receive_pdo && object.index < first_receive_pdo + pdo_numbers) {
                add_pdo(object.index, false);
            } else if (object.index >= first_transmit_pdo &&
                       object.index < first_transmit_pdo + pdo_numbers) {
                add_pdo(object.index, true);
            }
        }
        return std::move(found_);
    }

  private:
    std::optional<std::uint64_t> value(std::uint16_t index, std::uint8_t sub_index) const {
        const Variable* variable = dictionary_.find(index, sub_index);
        if (variable == nullptr || (variable->no_default && !variable->parameter_value)) {
            return std::nullopt;
        }
        return variable->parameter_value.value_or(variable->default_value)
            .resolve(static_cast<std::uint8_t>(node_id_));
    }
    std::uint64_t value_or_0(std::uint16_t index, std::uint8_t sub_index) const {
        return value(index, sub_index).value_or(0);
    }

    std::string own() const { return fmt::format("node {}", node_id_); }

    // The identifier; nothing after a text where it cannot be counted.
    std::optional<std::uint32_t> identifier(std::uint64_t cob_id, const std::string& name,
                                            const diagnostic::Location& where) {
        const auto low = static_cast<std::uint32_t>(cob_id);
        if ((low & extended_bit) != 0 || (low & ~(invalid_bit | producer_bit)) > cob::highest) {
            found_.left_out.push_back(
                {where, fmt::format("{} of {}: its identifier has 29 bits", name, own())});
            return std::nullopt;
        }
        return low & cob::highest;
    }

    void add_sync() {
        const std::uint64_t cob_id = value_or_0(0x1005, 0);
        const std::uint64_t period_us = value_or_0(0x1006, 0);
        if ((cob_id & producer_bit) == 0 || period_us == 0) {
            return;
        }
        if (const auto found = identifier(cob_id, "SYNC", places_(0x1005, 0))) {
            add({.identifier = *found, .kind = Kind::sync, .name = "SYNC", .period_us = period_us}, 0x1006);
        }
    }

    void add_emergency() {
        const std::optional<std::uint64_t> cob_id = value(0x1014, 0);
        if (!cob_id || (*cob_id & invalid_bit) != 0) {
            return;
        }
        const std::uint64_t inhibit_us = value_or_0(0x1015, 0) * us_per_inhibit_step;
        if (const auto found = identifier(*cob_id, "EMCY", places_(0x1014, 0))) {
            add({.identifier = *found,
                 .bytes = 8,
                 .kind = Kind::emergency,
                 .release = Release::event,
                 .name = "EMCY",
                 .period_us = inhibit_us != 0 ? inhibit_us : assumed::emergency_us,
                 .assumed = inhibit_us == 0},
                0x1014);
        }
    }

    void add_heartbeat() {
        const std::uint64_t period_us = value_or_0(0x1017, 0) * us_per_ms;
        if (period_us != 0) {
            add({.identifier = cob::heartbeat + node_id_,
                 .bytes = 1,
                 .kind = Kind::heartbeat,
                 .name = "heartbeat",
                 .period_us = period_us,
                 .deadline_us = period_us},
                0x1017);
        }
    }

    std::uint8_t length_of(std::uint16_t mapping) const {
        const std::uint64_t count = std::min<std::uint64_t>(value_or_0(mapping, 0), 64);
        std::uint64_t bits = 0;
        for (std::uint64_t entry = 1; entry <= count; ++entry) {
            bits += value_or_0(mapping, static_cast<std::uint8_t>(entry)) & 0xFF;
        }
        return static_cast<std::uint8_t>(std::min<std::uint64_t>((bits + 7) / 8, 8));
    }

    void add_pdo(std::uint16_t index, bool transmits) {
        const std::uint16_t first = transmits ? first_transmit_pdo : first_receive_pdo;
        const auto number = static_cast<unsigned>(index - first + 1);
        const std::string name = base::pdo_name(transmits, number);
        const std::optional<std::uint64_t> cob_id = value(index, 1);
        if (!cob_id || *cob_id == 0 || (*cob_id & invalid_bit) != 0) {
            return;
        }
        const auto found = identifier(*cob_id, name, places_(index, 1));
        if (!found) {
            return;
        }
        Message message{.identifier = *found,
                        .bytes = length_of(static_cast<std::uint16_t>(index + mapping_offset)),
                        .kind = Kind::pdo,
                        .name = transmits ? name : fmt::format("{} of {}", name, own())};
        transmits ? time_transmitted(index, message) : time_received(index, message);
        message.where = places_(index, 1);
        message.sender = transmits ? own() : "";
        found_.messages.push_back(std::move(message));
    }

    // A PDO of events goes whenever it likes: at most once in its inhibit time. The event timer is the
    // longest time between two, not the shortest.
    void time_transmitted(std::uint16_t index, Message& message) {
        const std::uint64_t inhibit_us = value_or_0(index, 3) * us_per_inhibit_step;
        const std::uint64_t timer_us = value_or_0(index, 5) * us_per_ms;
        const std::uint64_t type = value_or_0(index, 2);
        constexpr std::uint64_t last_synchronous = 240;  // 0: with a SYNC, when there is something new
        if (type <= last_synchronous) {
            message.sync_multiple = static_cast<std::uint8_t>(std::max<std::uint64_t>(type, 1));
            message.release = type == 0 ? Release::event : Release::cyclic;
            message.period_us = value_or_0(0x1006, 0) * message.sync_multiple;
        } else if (inhibit_us != 0) {
            message.period_us = inhibit_us;
            message.release = Release::event;
        } else {
            message.period_us = timer_us;
            message.release = timer_us != 0 ? Release::cyclic : Release::event;
            message.assumed = true;
        }
        if (message.period_us == 0) {
            message.period_us = assumed::pdo_us;
            message.assumed = true;
        }
        // Of what goes at events nobody says when it must be there.
        message.deadline_us = message.release == Release::cyclic ? message.period_us : 0;
    }

    // Sub-index 5 is how long it waits for the next one.
    void time_received(std::uint16_t index, Message& message) {
        const std::uint64_t monitored_us = value_or_0(index, 5) * us_per_ms;
        message.monitored_us = monitored_us;
        message.deadline_us = monitored_us;
        message.period_us =
            monitored_us != 0 ? monitored_us / assumed::messages_in_monitored_time : assumed::pdo_us;
        message.assumed = true;
        message.receiver = true;
    }

    void add(Message message, std::uint16_t index) {
        message.sender = own();
        message.where = places_(index, 0);
        found_.messages.push_back(std::move(message));
    }

    const Dictionary& dictionary_;
    unsigned node_id_;
    const Places& places_;
    ForeignNode found_;
};

}  // namespace

ForeignNode messages_of(const Dictionary& dictionary, std::uint8_t node_id, const diagnostic::Location& whole,
                        const Places& places) {
    return Node(dictionary, node_id, places).read(whole);
}

}  // namespace cgw::network
