#include "traffic/words.hpp"

#include <array>

#include "canopen/words.hpp"

namespace cgw::traffic {
namespace {

struct Code {
    std::uint16_t code;
    std::uint16_t mask;
    std::string_view text;
};

// CiA 301, table of emergency error codes; the narrower rows first.
constexpr std::array codes{
    Code{0x8110, 0xFFFF, "CAN overrun"},
    Code{0x8120, 0xFFFF, "CAN in error passive"},
    Code{0x8130, 0xFFFF, "life guard or heartbeat error"},
    Code{0x8140, 0xFFFF, "recovered from bus off"},
    Code{0x8150, 0xFFFF, "CAN-ID collision"},
    Code{0x8210, 0xFFFF, "PDO not processed, too short"},
    Code{0x8220, 0xFFFF, "PDO too long"},
    Code{0x0000, 0xFF00, "no error, or error reset"},
    Code{0x1000, 0xFF00, "generic error"},
    Code{0x2100, 0xFF00, "current, input side"},
    Code{0x2200, 0xFF00, "current inside the device"},
    Code{0x2300, 0xFF00, "current, output side"},
    Code{0x2000, 0xF000, "current"},
    Code{0x3100, 0xFF00, "mains voltage"},
    Code{0x3200, 0xFF00, "voltage inside the device"},
    Code{0x3300, 0xFF00, "output voltage"},
    Code{0x3000, 0xF000, "voltage"},
    Code{0x4100, 0xFF00, "ambient temperature"},
    Code{0x4200, 0xFF00, "device temperature"},
    Code{0x4000, 0xF000, "temperature"},
    Code{0x5000, 0xF000, "device hardware"},
    Code{0x6100, 0xFF00, "internal software"},
    Code{0x6200, 0xFF00, "user software"},
    Code{0x6300, 0xFF00, "data set"},
    Code{0x6000, 0xF000, "device software"},
    Code{0x7000, 0xF000, "additional modules"},
    Code{0x8100, 0xFF00, "communication"},
    Code{0x8200, 0xFF00, "protocol error"},
    Code{0x8000, 0xF000, "monitoring"},
    Code{0x9000, 0xF000, "external error"},
    Code{0xF000, 0xFF00, "additional functions"},
    Code{0xFF00, 0xFF00, "device-specific"},
};

}  // namespace

std::string_view nmt_command_text(std::uint8_t command) {
    for (const canopen::NmtCommandWords& row : canopen::nmt_commands) {
        if (static_cast<std::uint8_t>(row.command) == command) {
            return row.text;
        }
    }
    return {};
}

std::string_view nmt_state_text(std::uint8_t state) {
    for (const canopen::NmtStateText& row : canopen::nmt_states) {
        if (static_cast<std::uint8_t>(row.state) == state) {
            return row.text;
        }
    }
    return {};
}

std::string_view emergency_text(std::uint16_t code) {
    for (const Code& row : codes) {
        if ((code & row.mask) == row.code) {
            return row.text;
        }
    }
    return "no code of CiA 301";
}

}  // namespace cgw::traffic
