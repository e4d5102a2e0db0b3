// Who has which node id and which identifier.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/numbers.hpp"
#include "diagnostic/rules/network.hpp"
#include "facts/identifiers.hpp"
#include "network/judge_parts.hpp"
#include "network/same_device.hpp"

namespace cgw::network {
namespace {

namespace rules = diagnostic::rules;
using base::identifier_text;
using base::milliseconds_text;
using diagnostic::Findings;

// A message of which only the time is assumed has a sender all the same.
bool has_owner(const Message& message) {
    return !message.receiver && (!message.assumed || !message.sender.empty());
}

bool is_told_twice(const Message& a, const Message& b) {
    return a.label() == b.label() && a.bytes == b.bytes && a.plant != b.plant;
}

std::span<const Message> messages_of(std::span<const Message> messages, int device) {
    const auto is_of = [&](const Message& message) { return message.plant == device; };
    const auto first = std::find_if(messages.begin(), messages.end(), is_of);
    return {first, std::find_if_not(first, messages.end(), is_of)};
}

// Node ids that two have.
class Nodes {
  public:
    Nodes(std::span<const Member> members, std::span<const Message> messages, Findings& findings)
        : members_(members), messages_(messages), findings_(findings) {}

    // False after a finding.
    bool judge() {
        for (std::size_t plant = 0; plant < members_.size(); ++plant) {
            const Member& member = members_[plant];
            const auto [first, is_new] = plants_.try_emplace(member.node_id, static_cast<int>(plant));
            if (!is_new) {
                report(fmt::format("two plants have node id {}", member.node_id), member.node_where,
                       first->second);
            }
        }
        for (const Message& message : messages_) {
            // Each node answers SDO requests: there is one such message of each.
            if (message.plant < 0 && message.kind == Kind::sdo && !message.sender.empty()) {
                judge_described(message);
            }
        }
        return unique_;
    }

  private:
    void report(std::string text, const diagnostic::Location& where, int plant) {
        unique_ = false;
        diagnostic::Diagnostic finding{
            .rule = &rules::node_shared, .message = std::move(text), .where = where};
        if (plant >= 0) {
            finding.related.push_back({members_[static_cast<std::size_t>(plant)].node_where, "also here"});
        }
        findings_.report(std::move(finding));
    }

    void judge_described(const Message& sdo) {
        const auto node_id = static_cast<std::uint8_t>(sdo.identifier - facts::cob::sdo_answer);
        if (const auto plant = plants_.find(node_id); plant != plants_.end()) {
            const std::string difference = difference_between(messages_of(messages_, plant->second),
                                                              messages_of(messages_, sdo.plant), node_id);
            if (!difference.empty()) {
                report(fmt::format("a plant has node id {} as well, and is another device: {}", node_id,
                                   difference),
                       sdo.where, plant->second);
            }
        } else if (!described_.try_emplace(node_id, sdo.plant).second) {
            report(fmt::format("two other nodes have node id {}", node_id), sdo.where, -1);
        }
    }

    std::span<const Member> members_;
    std::span<const Message> messages_;
    Findings& findings_;
    std::map<std::uint8_t, int> plants_;     // by node id
    std::map<std::uint8_t, int> described_;  // of those that are no plants
    bool unique_ = true;
};

}  // namespace

bool are_in_conflict(const Message& a, const Message& b) {
    const bool two_senders = !a.sender.empty() && !b.sender.empty() && a.sender != b.sender;
    return a.identifier == b.identifier && has_owner(a) && has_owner(b) && !is_told_twice(a, b) &&
           (two_senders || (!a.assumed && !b.assumed));
}

void judge_owners(std::span<const Member> members, std::span<const Message> messages, Findings& findings) {
    const bool shared = !Nodes(members, messages, findings).judge();
    std::map<std::uint32_t, const Message*> owners;
    Listed conflicts(findings, rules::identifier_conflict);
    Listed differences(findings, rules::message_told_twice);
    for (const Message& message : messages) {
        if (!has_owner(message)) {
            continue;
        }
        const auto [first, is_new] = owners.try_emplace(message.identifier, &message);
        const Message& other = *first->second;
        // What follows from a node id that two have is one finding.
        if (is_new || (shared && !message.sender.empty() && message.sender == other.sender)) {
            continue;
        }
        if (are_in_conflict(message, other)) {
            const std::string identifier = identifier_text(message.identifier);
            conflicts.report(
                message.where,
                message.label() == other.label()
                    ? fmt::format("{} is sent as two messages of {} and {} bytes, each called {}", identifier,
                                  other.bytes, message.bytes, message.label())
                    : fmt::format("{} is sent as {} and as {}", identifier, other.label(), message.label()));
            conflicts.relate(other.where, other.label());
        } else if (!message.assumed && !other.assumed && message.period_us != other.period_us) {
            differences.report(message.where,
                               fmt::format("{} comes every {}, and elsewhere every {}: the shorter counts",
                                           label_of(message), milliseconds_text(message.period_us),
                                           milliseconds_text(other.period_us)));
            differences.relate(other.where, milliseconds_text(other.period_us));
        }
    }
}

}  // namespace cgw::network
