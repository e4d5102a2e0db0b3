// A CAN database (DBC) as plain data: nodes, messages and signals, printed for tools that decode a bus. It
// knows the format and its limits, not what a message means.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cgw::dbc {

// Names everywhere: identifiers as names.hpp makes them. Texts may be any UTF-8; they are printed as ASCII.

struct Node {
    std::string name;
    std::string comment;
};

struct NamedValue {
    std::uint32_t value = 0;
    std::string text;
};

struct Signal {
    std::string name;          // unique in its message
    std::string multiplexing;  // "M", "m0", …; "" for a signal that is in every frame
    unsigned start_bit = 0;    // of the least significant bit; bit 0 is the lowest of the first byte
    bool big_endian = false;   // then of the most significant one; nothing in CANopen is
    unsigned length = 16;      // bits
    bool is_signed = false;
    double factor = 1;  // physical value = raw value * factor + offset
    double offset = 0;
    double minimum = 0;  // physical; both 0: not stated
    double maximum = 0;
    std::string unit;
    std::vector<std::string> receivers;  // nodes; none: not known
    std::string comment;
    std::vector<NamedValue> values;
};

// The first three are what is printed; `other` is any other word that a file has.
enum class SendType : std::uint8_t { cyclic, spontaneous, not_stated, other };

struct Message {
    std::uint16_t identifier = 0;  // 11 bits, unique in the database
    std::string name;              // unique in the database
    std::uint8_t length = 8;       // bytes
    std::string sender;            // a node
    std::vector<Signal> signals;
    std::string comment;
    SendType send_type = SendType::not_stated;
    std::optional<std::uint32_t> cycle_ms;  // 1..65535; none: not stated
    bool standard_format = true;            // 11 bits, as VFrameFormat has it
};

struct Database {
    std::string version;
    std::string comment;
    std::vector<Node> nodes;
    std::vector<Message> messages;
};

// CRLF. Sections in the order that strict readers want; numbers as short as they read back the same.
std::string print(const Database& database);

}  // namespace cgw::dbc
