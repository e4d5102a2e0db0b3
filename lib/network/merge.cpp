#include <algorithm>

#include "facts/identifiers.hpp"
#include "network/judge.hpp"
#include "network/sources.hpp"

namespace cgw::network {
namespace {

bool known_before_assumed(const Message& a, const Message& b) {
    return a.identifier != b.identifier ? a.identifier < b.identifier : a.assumed < b.assumed;
}

// What was assumed is stated: what the receiver demands of it stays. Of two statements the more demanding one
// counts.
void take_demands(Message& known, const Message& assumed) {
    const auto shorter = [](std::uint64_t& time, std::uint64_t other) {
        time = time == 0 || (other != 0 && other < time) ? other : time;
    };
    shorter(known.monitored_us, assumed.monitored_us);
    shorter(known.deadline_us, assumed.deadline_us);
    // In whatever order they come.
    if (known.assumed == assumed.assumed) {
        shorter(known.period_us, assumed.period_us);
        known.jitter_us = std::max(known.jitter_us, assumed.jitter_us);
    }
    if (known.assumed && known.receiver) {
        known.bytes = std::max(known.bytes, assumed.bytes);
        return;
    }
    known.received_bytes = std::max(known.received_bytes, assumed.receiver ? assumed.bytes : std::uint8_t{0});
}

// PDOs that go with the SYNC go as often as it is sent, whoever sends it.
void settle_synchronous(std::vector<Message>& messages) {
    std::uint64_t sync_us = 0;
    for (const Message& message : messages) {
        if (is_sync(message) && (sync_us == 0 || message.period_us < sync_us)) {
            sync_us = message.period_us;
        }
    }
    for (Message& message : messages) {
        if (message.sync_multiple != 0 && sync_us != 0) {
            message.period_us = message.deadline_us = sync_us * message.sync_multiple;
            message.assumed = false;
        }
    }
}

}  // namespace

bool is_sync(const Message& message) {
    return !message.receiver && (message.kind == Kind::sync || message.identifier == facts::cob::sync);
}

std::vector<Message> merged(std::vector<Message> messages) {
    messages.push_back({.identifier = facts::cob::nmt,
                        .bytes = 2,
                        .kind = Kind::nmt,
                        .release = Release::event,
                        .name = "NMT",
                        .period_us = assumed::nmt_us,
                        .assumed = true});
    settle_synchronous(messages);
    std::stable_sort(messages.begin(), messages.end(), known_before_assumed);
    std::vector<Message> kept;
    for (Message& message : messages) {
        const bool is_covered = !kept.empty() && kept.back().identifier == message.identifier &&
                                !are_in_conflict(kept.back(), message);
        if (!is_covered) {
            kept.push_back(std::move(message));
            continue;
        }
        take_demands(kept.back(), message);
    }
    return kept;
}

}  // namespace cgw::network
