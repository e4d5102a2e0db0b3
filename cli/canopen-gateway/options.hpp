// The command line of canopen-gateway.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "cli/cgw/command.hpp"
#include "cli/cgw/help.hpp"

namespace cgw::gateway_cli {

inline constexpr int exit_fine = 0;
inline constexpr int exit_refused = 1;  // the embedded configuration, or the gateway did not behave
inline constexpr int exit_usage = 2;
inline constexpr int exit_environment = 3;  // an interface is missing, a file cannot be read or written
inline constexpr int exit_internal = 70;

struct Options {
    bool help = false;
    bool version = false;
    bool master = false;
    bool status = false;
    std::string can1;   // a CAN bus as media::open_channel() reads it; empty: a simulated governor
    std::string can2;   // likewise; empty: a bus inside the program
    std::string log;    // empty: no log
    std::string state;  // empty: errors are forgotten at the end
    std::optional<std::uint64_t> duration_us;

    // With a real bus time is real, without one it is simulated.
    bool real_time() const { return !can1.empty() || !can2.empty(); }
};

inline constexpr std::uint64_t simulated_duration_us = 10'000'000;  // when --duration is not given

// False: `error` says what is wrong with the command line, in one line.
bool parse_options(std::span<const char* const> arguments, Options& options, std::string& error);

std::string help_text();

// The same for man page and completion.
const cli::Verb& command();
std::span<const cli::ExitCodeText> exit_code_texts();

}  // namespace cgw::gateway_cli
