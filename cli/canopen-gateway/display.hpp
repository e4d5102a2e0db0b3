// Lines for people: at most 80 columns, engineering units where the image knows them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "canopen/protocol.hpp"
#include "device/governor_link.hpp"
#include "image/image.hpp"

namespace cgw::gateway_cli {

inline constexpr std::size_t line_width = 80;

std::string_view to_text(canopen::NmtState state);
std::string_view to_text(device::GatewayState state);
// "abort 0x06010002, read-only object", …
std::string abort_text(std::uint32_t code);

// At most `width` columns of UTF-8 text, cut off with "..." when there is more.
std::string clipped(std::string_view text, std::size_t width);

// `2000 Speed`, or the bare number.
std::string parameter_text(const image::Image& image, std::uint16_t number);
// `1500 1/min`; without scaling the part of the internal range.
std::string value_text(const image::Image& image, std::uint16_t number, std::uint16_t word);
// `TPDO4`, `RPDO1`.
std::string pdo_text(const image::Pdo& pdo);

}  // namespace cgw::gateway_cli
