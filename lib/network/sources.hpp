// Where the messages of a bus come from: plants, descriptions of other nodes, rows of parameter files.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "config/configuration.hpp"
#include "diagnostic/diagnostic.hpp"
#include "dictionary/dictionary.hpp"
#include "network/message.hpp"
#include "parameter/settings.hpp"

namespace cgw::network {

// What the gateway of a plant sends and what it is to receive (PDOs, SDO, heartbeat), the heartbeats of its
// partner and of the listed nodes, and the messages that the file states. TPDO1..3 go at events, at most once
// in a main cycle of the governor. `plant` is kept in each message.
std::vector<Message> messages_of(const parameter::Settings& settings,
                                 const config::Configuration& configuration, int plant);

struct ForeignNode {
    std::vector<Message> messages;
    std::vector<diagnostic::Related> left_out;  // what cannot be counted
};

// Where a description says what a sub-object holds.
using Places = std::function<diagnostic::Location(std::uint16_t index, std::uint8_t sub_index)>;

// What a node sends and receives by its objects: 1005h, 1006h (SYNC), 1014h, 1015h (EMCY), 1017h (heartbeat),
// 1400h.., 1800h.. with 1600h.. and 1A00h.. (PDOs), SDO. Values of the one node (DCF) count before defaults.
// `whole` is where the description as such stands.
ForeignNode messages_of(const dictionary::Dictionary& dictionary, std::uint8_t node_id,
                        const diagnostic::Location& whole, const Places& places);

// All messages of a bus from those of its members, by identifier. What is assumed goes where somebody states
// it; the NMT commands of a master come in.
std::vector<Message> merged(std::vector<Message> messages);

}  // namespace cgw::network
