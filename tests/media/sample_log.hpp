// One frame of every kind that a log has to keep.
#pragma once

#include <vector>

#include "media/logged_frame.hpp"
#include "support/recording_port.hpp"

namespace cgw::test {

inline std::vector<media::LoggedFrame> sample_log() {
    frame::Frame extended = make_frame(0x1ABCDEF0, {1, 2, 3});
    extended.extended = true;
    frame::Frame low_extended = make_frame(0x123, {});
    low_extended.extended = true;
    frame::Frame remote;
    remote.id = 0x705;
    remote.remote = true;
    remote.length = 2;
    return {{0, "can0", make_frame(0, {1, 5})},
            {1, "can0", make_frame(0x7FF, {1, 2, 3, 4, 5, 6, 7, 8})},
            {999'999, "can0", make_frame(0x80, {})},
            {1'700'000'000'123'456, "can0", extended},
            {1'700'000'000'123'457, "can0", low_extended},
            {4'294'967'295'999'999, "can0", remote}};
}

}  // namespace cgw::test
