#include "cli/canopen-gateway/options.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>

namespace cgw::gateway_cli {
namespace {

constexpr double longest_duration = 86400;  // seconds

bool set_can1(Options& /*options*/, std::string_view value) {
    return value == "simulated";
}
bool set_can2(Options& /*options*/, std::string_view value) {
    return value == "virtual";
}

bool set_log(Options& options, std::string_view value) {
    options.log = value;
    return !value.empty();
}

bool set_duration(Options& options, std::string_view value) {
    double seconds = 0;
    const char* const end = value.data() + value.size();
    const auto [stop, error] = std::from_chars(value.data(), end, seconds, std::chars_format::fixed);
    if (error != std::errc{} || stop != end || !(seconds > 0) || seconds > longest_duration) {
        return false;
    }
    options.duration_us = static_cast<std::uint64_t>(std::llround(seconds * 1e6));
    return options.duration_us > 0;
}

bool set_master(Options& options, std::string_view /*value*/) {
    return options.master = true;
}
bool set_version(Options& options, std::string_view /*value*/) {
    return options.version = true;
}
bool set_help(Options& options, std::string_view /*value*/) {
    return options.help = true;
}

struct Option {
    std::string_view name;
    std::string_view value;  // its name in the help; empty: takes none
    bool (*set)(Options&, std::string_view);
    std::string_view expected;  // for the error message
    std::string_view text;
};

constexpr std::array table = {
    Option{"--can1", "MEDIUM", set_can1, "simulated", "governor side: simulated (default)"},
    Option{"--can2", "MEDIUM", set_can2, "virtual", "CANopen side: virtual (default)"},
    Option{"--master", "", set_master, "", "run a CANopen master too and show what it sees"},
    Option{"--log", "FILE", set_log, "a file name", "write all CAN2 frames as a candump -L log"},
    Option{"--duration", "SECONDS", set_duration, "a number above 0, up to 86400",
           "simulated time to run (default 10)"},
    Option{"--version", "", set_version, "", "print the version"},
    Option{"--help", "", set_help, "", "print this help"},
};

const Option* find(std::string_view name) {
    for (const Option& option : table) {
        if (option.name == name) {
            return &option;
        }
    }
    return nullptr;
}

}  // namespace

bool parse_options(std::span<const char* const> arguments, Options& options, std::string& error) {
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string_view argument = arguments[i];
        const std::size_t equals =
            argument.substr(0, 2) == "--" ? argument.find('=') : std::string_view::npos;
        const std::string_view name = argument.substr(0, equals);
        const Option* const option = find(name);
        if (option == nullptr) {
            error = fmt::format("unknown option '{}', --help lists them", name);
            return false;
        }
        std::string_view value;
        if (equals != std::string_view::npos) {
            value = argument.substr(equals + 1);
        } else if (!option->value.empty() && i + 1 < arguments.size()) {
            value = arguments[++i];
        }
        if (option->value.empty() && equals != std::string_view::npos) {
            error = fmt::format("{} takes no value", name);
            return false;
        }
        if (!option->set(options, value)) {
            error = fmt::format("{} '{}': expected {}", name, value, option->expected);
            return false;
        }
    }
    return true;
}

std::string help_text() {
    std::string text =
        "usage: canopen-gateway [options]\n\n"
        "Runs the CANopen gateway with its embedded configuration, in simulated time.\n\n";
    for (const Option& option : table) {
        text += fmt::format("  {:<20} {}\n", fmt::format("{} {}", option.name, option.value), option.text);
    }
    text +=
        "\nexit: 0 fine; 1 the embedded configuration is refused, or the gateway did not\n"
        "answer the master as it should in that time; 2 usage; 3 cannot write\n";
    return text;
}

}  // namespace cgw::gateway_cli
