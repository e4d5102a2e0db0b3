// Reads a CAN database as a bus monitor does, and decodes and encodes frames with its numbers. It shares no
// code with the program that wrote the database.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "frame/frame.hpp"

namespace cgw::test {

struct DbcSignal {
    unsigned start = 0;
    unsigned length = 0;
    bool is_signed = false;
    double factor = 1;
    double offset = 0;
    double minimum = 0;
    double maximum = 0;
    std::string unit;
    std::map<unsigned, std::string> values;

    double decode(const frame::Frame& frame) const;
    void encode(double physical, frame::Frame& frame) const;
};

struct DbcMessage {
    std::uint32_t id = 0;
    std::uint8_t length = 0;
    std::map<std::string, DbcSignal> signals;

    // The signal that begins at this bit; fails the test when there is none.
    const DbcSignal& at(unsigned start) const;
};

// By name.
std::map<std::string, DbcMessage> read_dbc(const std::string& text);

}  // namespace cgw::test
