// At which bit rate an interface of the kernel runs, asked over rtnetlink as `ip -details link` does.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace cgw::media {

// Bits per second. Nothing for virtual interfaces, and when the kernel does not say.
std::optional<std::uint32_t> can_bit_rate(const std::string& interface_name);

// The same from the kernel's answer, one netlink message.
std::optional<std::uint32_t> bit_rate_in(std::span<const std::uint8_t> message);

}  // namespace cgw::media
