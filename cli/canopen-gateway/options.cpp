#include "cli/canopen-gateway/options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "media/open_channel.hpp"

namespace cgw::gateway_cli {
namespace {

constexpr double longest_duration = 86400;  // seconds

// `inside` is the word for what is inside the program.
bool set_bus(std::string& bus, std::string_view value, std::string_view inside) {
    const auto kinds = media::channel_kinds();
    const std::string_view kind = value.substr(0, value.find(':'));
    bus = value == inside ? std::string() : std::string(value);
    return value == inside ||
           (kind != value && std::ranges::find(kinds, kind, &media::ChannelKind::name) != kinds.end());
}
bool set_can1(Options& options, std::string_view value) {
    return set_bus(options.can1, value, "simulated");
}
bool set_can2(Options& options, std::string_view value) {
    return set_bus(options.can2, value, "virtual");
}

bool set_state(Options& options, std::string_view value) {
    options.state = value;
    return !value.empty() && value != "-";
}
bool set_status(Options& options, std::string_view /*value*/) {
    return options.status = true;
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
    return *options.duration_us > 0;
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
    Option{"--can1", "BUS", set_can1, "simulated or a CAN bus, --help says how it is written",
           "governor side: simulated (default), or a CAN bus"},
    Option{"--can2", "BUS", set_can2, "virtual or a CAN bus, --help says how it is written",
           "CANopen side: virtual (default), or a CAN bus"},
    Option{"--log", "FILE", set_log, "a file name", "log of all frames: candump -L, or pcap (.pcap, .cap)"},
    Option{"--state", "FILE", set_state, "a file name", "keep the permanent error memory in that file"},
    Option{"--status", "", set_status, "", "print all measurements at the end"},
    Option{"--duration", "SECONDS", set_duration, "a number above 0, up to 86400",
           "time to run (simulated: default 10)"},
    Option{"--master", "", set_master, "", "simulated: run a CANopen master and show what it sees"},
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

// Options that do not go together; empty: they do.
std::string contradiction(const Options& options) {
    if (options.real_time() && options.master) {
        return "--master is for simulated time; on a real bus the master is another program";
    }
    if (!options.real_time() && (options.status || !options.state.empty())) {
        return fmt::format("{} is for real time: give --can1 or --can2 a CAN bus",
                           options.status ? "--status" : "--state");
    }
    return {};
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
    error = options.help || options.version ? std::string() : contradiction(options);
    return error.empty();
}

std::string help_text() {
    std::string text =
        "usage: canopen-gateway [options]\n\n"
        "Runs the CANopen gateway with its embedded configuration: in real time when a\n"
        "CAN bus is named, until SIGINT or SIGTERM; else both buses are inside the\n"
        "program, and time is simulated.\n\n";
    for (const Option& option : table) {
        text += fmt::format("  {:<20} {}\n", fmt::format("{} {}", option.name, option.value), option.text);
    }
    text += "\na CAN bus is one of\n";
    for (const media::ChannelKind& kind : media::channel_kinds()) {
        text += fmt::format("  {:<20} {}\n", kind.form, kind.summary);
    }
    text +=
        "\nIn real time SIGUSR1 shows all measurements on standard error, SIGUSR2 clears\n"
        "errors as a service tool does.\n"
        "\nexit: 0 fine; 1 the embedded configuration is refused, or the gateway did not\n"
        "answer the master as it should in that time; 2 usage; 3 an interface is\n"
        "missing, or a file cannot be read or written\n";
    return text;
}

}  // namespace cgw::gateway_cli
