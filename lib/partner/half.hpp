// What the partner of a gateway needs: the program of a PLC or host that reads the gateway's transmit PDOs
// and sends its receive PDOs. Plain data, from which every form of it is written.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "signals/frames.hpp"

namespace cgw::partner {

struct Half {
    std::string title;                        // UTF-8, as the parameter file has it; "" for none
    std::string configuration_id;             // 16 hexadecimal digits
    std::string tool_version;                 // "0.1.0"
    std::uint8_t node_id = 0;                 // of the gateway, 1..127
    std::uint8_t partner_node_id = 0;         // 428; 0: none
    std::optional<std::uint32_t> bit_rate{};  // of CAN2, bit/s; nothing where the parameter file tells none
    std::uint32_t heartbeat_us = 0;           // the gateway's; 0: it sends none
    std::uint32_t partner_heartbeat_us = 0;   // longest time between two of the partner's; 0: not monitored
    std::vector<signals::Frame> frames{};     // as signals::frames_of() makes them
};

// What everything of this gateway begins with, so that programs can hold the halves of several: "gw12".
std::string prefix(const Half& half);

// What each form writes, whole files. They take any Half: names are made into names of their language, texts
// into texts that end no comment and no string.
std::string c_header(const Half& half);
std::string points(const Half& half);
std::string python_canopen(const Half& half);
std::string structured_text(const Half& half);
std::string stx(const Half& half);

// What the bit of a switch function is when it is on, 0 or 1; nothing for other signals, and where functions
// that share the bit disagree.
std::optional<int> raw_of_on(const signals::Signal& signal);

}  // namespace cgw::partner
