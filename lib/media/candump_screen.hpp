// Frames as candump shows them on a screen, with its options for times and directions:
//   (1436509052.249713)  can0  044   [8]  2A 36 6A C7 EF E4 00 5B
//   (2015-07-10 08:17:32.249713)  can0  TX - -  044   [2]  2A 36   '*6'
//   can0  705   [0]  remote request
#pragma once

#include <string_view>

#include "media/candump.hpp"

namespace cgw::media {

struct ScreenLine {
    ReadLine line{};
    bool has_time = false;  // without -t candump shows none
};

// Error frames and CAN FD frames are passed over. A date is taken as UTC.
ScreenLine read_screen_line(std::string_view text);

}  // namespace cgw::media
