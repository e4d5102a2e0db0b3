#include <fmt/format.h>

#include <csignal>

#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"
#include "media/hub.hpp"

namespace cgw::cli {
namespace {

constexpr Option hub_options[] = {
    {.names = "--listen",
     .value = "HOST:PORT",
     .summary = "where clients connect to; port 0 takes a free one",
     .default_value = "127.0.0.1:29536"},
    {.names = "--bus",
     .value = "NAME",
     .summary = "a bus that clients may open; without it any name",
     .repeats = true},
    {.names = "--verbose", .summary = "say on standard error who comes and who goes"},
};

constexpr std::string_view hub_details =
    "Every client gets what the others send on the same bus, in the protocol of\n"
    "socketcand. python-can joins with\n"
    "  can.Bus(interface='socketcand', host='127.0.0.1', port=29536, channel='can0')\n"
    "The hub runs until it is interrupted (SIGINT) or terminated (SIGTERM) and then\n"
    "exits 0; it exits 3 when it cannot listen. Only programs on this machine can\n"
    "connect unless --listen says otherwise: nothing asks a client who it is.\n"
    "For a client that reads too slowly the newest frames are lost; the hub tells it\n"
    "how many, and lets it go when it takes nothing for 10 s. Nobody else waits.\n";

media::HubOptions options_of(const Arguments& arguments) {
    media::HubOptions options;
    options.buses = arguments.values("--bus");
    for (const std::string& bus : options.buses) {
        if (!media::is_bus_name(bus)) {
            throw UsageError(fmt::format("--bus {}: a name has 1..16 letters, digits, '.', '_' or '-'", bus));
        }
    }
    return options;
}

int run_hub(const Arguments& arguments) {
    const auto where = media::parse_host_port(arguments.value("--listen"));
    if (!where) {
        throw UsageError("--listen: " + where.error().message);
    }
    const media::HubOptions options = options_of(arguments);
    const bool single = options.buses.size() == 1;
    const std::string buses = options.buses.empty() ? "any bus"
                                                    : fmt::format("{} {}", single ? "bus" : "buses",
                                                                  fmt::join(options.buses, ", "));
    const bool verbose = arguments.given("--verbose");

    media::Loop loop;
    media::Signals signals({SIGINT, SIGTERM}, [&](int) { loop.stop(); });
    media::Hub hub(options, media::wall_clock_now, [&](std::string_view line) {
        if (verbose) {
            print_error(line);
        }
    });
    if (const auto listening = hub.listen(*where); !listening) {
        print_error(listening.error().message);
        return exit_environment;
    }
    if (!print(fmt::format("listening on {}, {}\n", hub.address(), buses))) {
        return exit_environment;
    }
    loop.add(signals);
    loop.add(hub);
    loop.run();
    if (hub.counters().lost != 0) {
        print_error(fmt::format("{} frames were lost for clients that read too slowly", hub.counters().lost));
    }
    return exit_fine;
}

}  // namespace

const Verb hub_verb = {"hub", "run a virtual CAN bus that programs join over TCP", hub_options, run_hub,
                       hub_details};

}  // namespace cgw::cli
