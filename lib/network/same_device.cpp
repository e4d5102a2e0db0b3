#include "network/same_device.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/canopen_text.hpp"
#include "base/numbers.hpp"

namespace cgw::network {
namespace {

std::string text_of(const Message& message) {
    return fmt::format("{} {}", base::identifier_text(message.identifier), message.label());
}

const Message* find_same(std::span<const Message> messages, const Message& wanted) {
    const auto found = std::find_if(messages.begin(), messages.end(), [&](const Message& message) {
        return message.identifier == wanted.identifier && message.label() == wanted.label();
    });
    return found == messages.end() ? nullptr : &*found;
}

// Nobody need know how often a message of events is sent.
bool have_same_times(const Message& plant, const Message& node) {
    const auto same = [](std::uint64_t a, std::uint64_t b) { return a / 1000 == b / 1000; };
    const bool not_known = plant.release == Release::event && (plant.assumed || node.assumed);
    return plant.release == node.release && same(plant.monitored_us, node.monitored_us) &&
           (not_known || same(plant.period_us, node.period_us));
}

std::string times_text(const Message& message) {
    return message.receiver && message.monitored_us != 0
               ? fmt::format("monitored for {}", base::milliseconds_text(message.monitored_us))
           : message.release == Release::event ? "at events"
                                               : "every " + base::milliseconds_text(message.period_us);
}

}  // namespace

std::string difference_between(std::span<const Message> plant, std::span<const Message> node,
                               std::uint8_t node_id) {
    for (const Message& message : node) {
        const Message* own = find_same(plant, message);
        if (own == nullptr) {
            return fmt::format("the plant has no {}", text_of(message));
        }
        if (own->bytes != message.bytes) {
            return fmt::format("{} has {} bytes, and the plant's {}", text_of(message), message.bytes,
                               own->bytes);
        }
        if (!have_same_times(*own, message)) {
            return fmt::format("{} is {}, and the plant's {}", text_of(message), times_text(message),
                               times_text(*own));
        }
    }
    const std::string sender = fmt::format("node {}", node_id);
    for (const Message& message : plant) {
        if ((message.sender == sender || message.receiver) && find_same(node, message) == nullptr) {
            return fmt::format("it has no {}", text_of(message));
        }
    }
    return {};
}

}  // namespace cgw::network
