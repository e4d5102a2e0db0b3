// The permanent error memory in a file: how often each of 3070..3094 has appeared, the sentinels 3170..3194
// (GWM 9.2). The file is text (docs/command-line.md, "The state file"):
//
//   canopen-gateway error memory 1
//   configuration 5f0c…                for people: which image ran last
//   3172 4                             a sentinel that is not 0, 1..255; ascending
//   end
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "base/result.hpp"
#include "device/gateway_errors.hpp"

namespace cgw::runtime {

using Sentinels = std::array<std::uint8_t, device::GatewayErrors::error_count>;

// The number of the sentinel at `position`.
constexpr std::uint16_t sentinel_number(std::size_t position) {
    constexpr std::uint16_t sentinel_of_error = 100;  // GWM 9.2: 3100 onward for 3000 onward
    return static_cast<std::uint16_t>(device::GatewayErrors::first_error + sentinel_of_error + position);
}

std::string error_memory_text(const Sentinels& sentinels, std::string_view configuration_id);
// The failure says what is wrong and where: "state.txt:3: …".
base::Result<Sentinels> parse_error_memory(std::string_view text, const std::string& name);

class ErrorMemory {
  public:
    static constexpr std::size_t largest_file = 4096;  // bytes; a full one has some 300

    // Reads the file; none there is a fresh start. The failure is a file that is none of ours, which is then
    // never written, or a directory that does not exist.
    static base::Result<ErrorMemory> open(const std::string& path, std::string configuration_id);

    const Sentinels& sentinels() const { return stored_; }
    const std::string& path() const { return path_; }

    // Writes the file, whole or not at all, unless it holds just that already.
    base::Result<void> keep(const Sentinels& sentinels);

  private:
    ErrorMemory(std::string path, std::string configuration_id)
        : path_(std::move(path)), configuration_id_(std::move(configuration_id)) {}

    std::string path_;
    std::string configuration_id_;
    Sentinels stored_{};
    bool written_ = false;  // the file is there and holds stored_
};

}  // namespace cgw::runtime
