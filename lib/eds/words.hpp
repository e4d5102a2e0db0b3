// Words and numbers that reader and writer share.
#pragma once

#include <array>

#include "dictionary/words.hpp"

namespace cgw::eds {

using dictionary::access_types;

// Keys of [DeviceInfo] that files of this and other makers have for others (D41).
struct MisspeltKey {
    std::string_view written;
    std::string_view meant;
};
inline constexpr std::array misspelt_device_keys{MisspeltKey{"SimpleBoot-upMaster", "SimpleBootUpMaster"},
                                                 MisspeltKey{"SimpleBoot-upSlave", "SimpleBootUpSlave"}};

// BaudRate_…, kbit/s.
inline constexpr std::array<unsigned, 8> bit_rate_keys{10, 20, 50, 125, 250, 500, 800, 1000};

}  // namespace cgw::eds
