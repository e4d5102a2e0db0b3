// Frames drawn and explained: which byte and bit carries what, its scaling, and a value worked out both ways.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "signals/frames.hpp"

namespace cgw::signals {

// What is drawn, and for which plant.
struct Sheet {
    std::string title;             // of the plant, any text
    std::string configuration_id;  // 16 hexadecimal digits
    std::uint8_t node_id = 0;
    std::vector<Frame> frames;
};

// A value of a signal on its way to the bus and back: at three quarters of the range; a bit is set.
struct Example {
    std::string asked;  // "3000 1/min"
    std::int32_t raw = 0;
    std::string bytes;  // "FF BF"
    std::string shown;  // what the bytes say: "2999.98 1/min"
};
Example example_of(const Signal& signal);

// "sent every 15.625 ms", "sent when a bit changes", "monitored for 93.75 ms", "not monitored"
std::string time_text(const Frame& frame);

// "2000 Speed", "900 AssignIn_Setp1Ext, 901 …"; an error without a name "error 3001"; "engine state bit 1"
std::string meaning_of(const Signal& signal);

// Where in the object dictionary: "2000h:1"; of a bit "2003h:1 bit 3", 1 being the lowest (D23).
std::string object_place(const Signal& signal);

// What the two values of a bit say: "1: present", "0: on, 1: off"; "" of a word, and where nobody says.
std::string bit_values_text(const Signal& signal);

// Bytes from left to right for a frame of words, bits below each other for one of bits; lines of at most 80
// columns, each ended by LF.
std::string diagram_of(const Frame& frame);

struct Format {
    std::string_view name;
    std::string_view summary;
    std::string (*render)(const Sheet& sheet);
};

// text, md, json
std::span<const Format> layout_formats();

std::string render_layout_text(const Sheet& sheet);
std::string render_layout_markdown(const Sheet& sheet);
std::string render_layout_json(const Sheet& sheet);

}  // namespace cgw::signals
