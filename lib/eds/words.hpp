// Words and numbers that reader and writer share.
#pragma once

#include <array>
#include <string_view>

#include "object/vocabulary.hpp"

namespace cgw::eds {

// Spelling of object::Access, in the order of its values.
inline constexpr std::array<std::string_view, 6> access_types{"ro", "wo", "rw", "rwr", "rww", "const"};

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
