// The command line of canopen-gateway.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace cgw::gateway_cli {

inline constexpr int exit_fine = 0;
inline constexpr int exit_refused = 1;  // the embedded configuration, or the gateway did not behave
inline constexpr int exit_usage = 2;
inline constexpr int exit_environment = 3;  // cannot write
inline constexpr int exit_internal = 70;

struct Options {
    bool help = false;
    bool version = false;
    bool master = false;
    std::string log;                         // empty: no log
    std::uint64_t duration_us = 10'000'000;  // simulated
};

// False: `error` says what is wrong with the command line, in one line.
bool parse_options(std::span<const char* const> arguments, Options& options, std::string& error);

std::string help_text();

}  // namespace cgw::gateway_cli
