#include "cli/canopen-gateway/options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>

#include "base/wrap.hpp"
#include "media/open_channel.hpp"

namespace cgw::gateway_cli {
namespace {

constexpr double longest_duration = 86400;  // seconds

// `inside` is the word for what is inside the program.
bool set_bus(std::string& bus, std::string_view value, std::string_view inside) {
    bus = value == inside ? std::string() : std::string(value);
    return value == inside || media::channel_mistake(value).empty();
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

std::vector<cli::Word> can1_words() {
    return {{"simulated", "a simulated governor inside the program"}};
}
std::vector<cli::Word> can2_words() {
    return {{"virtual", "a bus inside the program"}};
}

// The option is what help, man page and completion show; the rest is how it is read.
struct Reading {
    bool (*set)(Options&, std::string_view);
    std::string_view expected{};  // for the error message
};

constexpr std::array option_rows = {
    cli::Option{.names = "--can1",
                .value = "BUS",
                .summary = "governor side: a simulated governor, or a CAN bus",
                .default_value = "simulated",
                .words = can1_words,
                .only_words = false},
    cli::Option{.names = "--can2",
                .value = "BUS",
                .summary = "CANopen side: inside the program, or a CAN bus",
                .default_value = "virtual",
                .words = can2_words,
                .only_words = false},
    cli::Option{.names = "--log",
                .value = "FILE",
                .summary = "log of all frames: candump -L, or pcap (.pcap, .cap)",
                .completes = cli::Completes::files},
    cli::Option{.names = "--state",
                .value = "FILE",
                .summary = "keep the permanent error memory in that file",
                .completes = cli::Completes::files},
    cli::Option{.names = "--status", .summary = "print all measurements at the end"},
    cli::Option{.names = "--duration", .value = "SECONDS", .summary = "time to run (simulated: default 10)"},
    cli::Option{.names = "--master", .summary = "simulated: run a CANopen master and show what it sees"},
    cli::Option{.names = "--version", .summary = "print the version"},
    cli::Option{.names = "--help", .summary = "print this help"},
};

constexpr std::array<Reading, option_rows.size()> readings = {{
    {set_can1, "simulated or a CAN bus, --help says how it is written"},
    {set_can2, "virtual or a CAN bus, --help says how it is written"},
    {set_log, "a file name"},
    {set_state, "a file name"},
    {set_status},
    {set_duration, "a number above 0, up to 86400"},
    {set_master},
    {set_version},
    {set_help},
}};

constexpr cli::ExitCodeText exit_codes[] = {
    {exit_fine, "fine, also when ended by a signal"},
    {exit_refused,
     "the embedded configuration is refused, or the gateway did not answer the master as it should in that "
     "time"},
    {exit_usage, "wrong usage"},
    {exit_environment, "a CAN bus is missing, or a file cannot be read or written"},
    {exit_internal, "internal error"},
};

// A table of two columns, the right one wrapped.
std::string entry(std::string_view left, std::string_view right) {
    constexpr std::size_t column = 24;
    constexpr std::size_t columns = 80;
    std::string text;
    std::string begin = fmt::format("  {:<{}}", left, column - 2);
    for (const std::string& line : base::wrap(right, columns - column)) {
        text += fmt::format("{}{}\n", begin, line);
        begin = std::string(column, ' ');
    }
    return text;
}

// Its place in the table; the table's size when there is none.
std::size_t find(std::string_view name) {
    const auto* const row = std::ranges::find(option_rows, name, &cli::Option::names);
    return static_cast<std::size_t>(row - option_rows.begin());
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
    if (media::same_bus(options.can1, options.can2)) {
        return fmt::format("--can1 and --can2 are the same bus, {}; a gateway joins two", options.can1);
    }
    namespace fs = std::filesystem;
    std::error_code ignored;
    if (!options.state.empty() && !options.log.empty() &&
        fs::weakly_canonical(fs::absolute(options.state, ignored), ignored) ==
            fs::weakly_canonical(fs::absolute(options.log, ignored), ignored)) {
        return "--log and --state are the same file";
    }
    return {};
}

}  // namespace

bool parse_options(std::span<const char* const> arguments, Options& options, std::string& error) {
    std::array<std::optional<std::string_view>, option_rows.size()> given{};
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string_view argument = arguments[i];
        const std::size_t equals =
            argument.substr(0, 2) == "--" ? argument.find('=') : std::string_view::npos;
        const std::string_view name = argument.substr(0, equals);
        const std::size_t row = find(name);
        if (row == option_rows.size()) {
            error = fmt::format("unknown option '{}', --help lists them", name);
            return false;
        }
        const bool flag = option_rows[row].flag();
        std::string_view value;
        if (equals != std::string_view::npos) {
            value = argument.substr(equals + 1);
        } else if (!flag && i + 1 < arguments.size()) {
            value = arguments[++i];
        }
        if (flag && equals != std::string_view::npos) {
            error = fmt::format("{} takes no value", name);
            return false;
        }
        if (!flag && given[row]) {
            error = fmt::format("{} is given twice: {} and {}", name, *given[row], value);
            return false;
        }
        given[row] = value;
        if (!readings[row].set(options, value)) {
            error = fmt::format("{} '{}': expected {}", name, value, readings[row].expected);
            return false;
        }
    }
    error = options.help || options.version ? std::string() : contradiction(options);
    return error.empty();
}

const cli::Verb& command() {
    static const std::string details = [] {
        std::string text =
            "Runs the CANopen gateway with its embedded configuration: in real time when a\n"
            "CAN bus is named, until SIGINT or SIGTERM; else both buses are inside the\n"
            "program, and time is simulated. In real time SIGUSR1 shows all measurements on\n"
            "standard error, and SIGUSR2 clears errors as a service tool does. A CAN bus is\n"
            "one of\n";
        for (const media::ChannelKind& kind : media::channel_kinds()) {
            text += entry(kind.form, kind.summary);
        }
        return text;
    }();
    static const cli::Verb verb = {"canopen-gateway",
                                   "CANopen gateway between a governor and a CANopen network", option_rows,
                                   nullptr, details};
    return verb;
}

std::span<const cli::ExitCodeText> exit_code_texts() {
    return exit_codes;
}

std::string help_text() {
    std::string text = fmt::format("usage: canopen-gateway [options]\n\n{}\n", command().details);
    for (const cli::Option& option : option_rows) {
        const std::string left =
            option.flag() ? std::string(option.names) : fmt::format("{} {}", option.names, option.value);
        const std::string more =
            option.default_value.empty() ? "" : fmt::format(" (default {})", option.default_value);
        text += entry(left, fmt::format("{}{}", option.summary, more));
    }
    text += "\nexit codes:\n";
    for (const cli::ExitCodeText& row : exit_codes) {
        text += entry(fmt::format("{}", row.code), row.meaning);
    }
    return text;
}

}  // namespace cgw::gateway_cli
