// Frames for the halves of a plant, as lines, and what they mean by lib/signals.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/bytes.hpp"
#include "partner/half.hpp"

namespace cgw::test {

struct PdoFrame {
    const signals::Frame* frame = nullptr;
    std::vector<std::uint8_t> data;
};

// What a simulated plant with a PLC put on its bus while engine, sensors and switches went through changes,
// each content once, and `random` frames of any content for each PDO.
std::vector<PdoFrame> record(const partner::Half& half, const base::Bytes& image, unsigned random);

// "48C 00112233", a line each.
std::string frame_lines(const std::vector<PdoFrame>& frames);

// A line for each signal: "TPDO4 Speed 24000 1500", raw and physical value, "TPDO4 X 7" where the scaling is
// not known, "RPDO1 X 1" for a bit, "RPDO1 X 0 on" for a switch function. 17 digits: every double is told
// apart.
std::string decoded_lines(const std::vector<PdoFrame>& frames);

// Frames to put together: a line of the PDO and a number for each of its signals, physical values where the
// scaling is known, 1 for a switch function that is on.
struct Encoding {
    std::string lines;     // "RPDO2 50.5 120 0 3"
    std::string expected;  // "RPDO2 0011223344556677 1101": the bytes, and which of the values could be put
};
Encoding encodings(const partner::Half& half, unsigned count);

}  // namespace cgw::test
