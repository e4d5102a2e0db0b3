// Inside the room scenario: names of errors as the gateway's catalogue has them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace cgw::scenario {

// An error that shows on the CANopen bus: a bit of 2000h:1..6 or of 2005h.
bool is_error(std::uint16_t number);

// Ignores case.
std::optional<std::uint16_t> error_by_name(std::string_view name);
std::span<const std::string_view> error_names();

// `12413 CanOpTimeCtrlErr`, or the bare number.
std::string error_text(std::uint16_t number);

}  // namespace cgw::scenario
