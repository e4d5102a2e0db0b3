// Lines for people: at most 80 columns, engineering units where the image knows them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "canopen/protocol.hpp"
#include "image/image.hpp"
#include "link/gateway_end.hpp"

namespace cgw::simulation {

inline constexpr std::size_t line_width = 80;

using device::to_text;  // of a GatewayState
std::string_view to_text(canopen::NmtState state);
// "start", "reset-node", …; "" for what is no command.
std::string_view to_text(canopen::NmtCommand command);

// At most `width` columns of UTF-8 text, cut off with "..." when there is more.
std::string clipped(std::string_view text, std::size_t width);

// `2000 Speed`, or the bare number.
std::string parameter_text(const image::Image& image, std::uint16_t number);
// `1500 1/min`; without scaling the part of the internal range.
std::string value_text(const image::Image& image, std::uint16_t number, std::uint16_t word);
// "1/min", "% of range" without scaling; "" where the image knows none. A sensor without a unit of its own
// has that of its measurement, as with its scaling.
std::string_view unit_text(const image::Image& image, std::uint16_t number);
// `TPDO4`, `RPDO1`.
std::string pdo_text(const image::Pdo& pdo);

// Why the gateway refused the governor's configuration: "main cycles of TPDO4: 2 at the governor, 1 at the
// gateway".
std::string refusal_text(const link::Refusal& refusal);

}  // namespace cgw::simulation
