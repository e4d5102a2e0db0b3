// The plant whose frames are read: what its bus is expected to carry.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dictionary/dictionary.hpp"
#include "signals/frames.hpp"

namespace cgw::traffic {

struct Subject {
    std::vector<signals::Frame> frames;                  // active PDOs
    const dictionary::Dictionary* dictionary = nullptr;  // of the gateway, for names and types; may be null
    std::string configuration_id;                        // 16 hexadecimal digits
    std::uint8_t node_id = 0;                            // of the gateway
    std::uint8_t partner = 0;                            // 0: none
    std::uint32_t heartbeat_period_us = 0;               // of the gateway; 0: sends none
    std::uint32_t heartbeat_monitoring_us = 0;           // of the partner; 0: not monitored
    std::vector<std::uint8_t> other_nodes{};             // [network]
};

}  // namespace cgw::traffic
