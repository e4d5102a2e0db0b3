#include "input/device_sections.hpp"

#include <fmt/format.h>

#include <optional>

#include "diagnostic/rules/keys.hpp"

namespace cgw::input {
namespace {

namespace rules = diagnostic::rules;
using bit_timing::controller_names;
using parameter::BitTiming;
using toml::Entry;
using toml::Kind;

constexpr std::string_view profiles[] = {"digital-governor"};

using enum Presence;

// --- [governor] ---

void read_profile(Context& context, const Entry& entry) {
    if (entry.value.text != profiles[0]) {
        context.report(rules::key_value, entry.value.range,
                       fmt::format("unknown profile {}", toml::quoted(entry.value.text)),
                       fmt::format("the profile is \"{}\"", profiles[0]));
    }
}

constexpr Key governor_keys[] = {
    {.name = "profile",
     .kind = Kind::string,
     .read = read_profile,
     .text = "kind of governor",
     .preset = "\"digital-governor\"",
     .words = profiles},
    {"main_cycle_us", Kind::integer, optional, Limit::value, 1000, 1'000'000,
     [](Context& context, const Entry& entry) { context.settings().main_cycle_us = unsigned_of(entry); },
     "main cycle of the governor in microseconds; its times are whole numbers of it (D8)", "15625"},
    {.name = "parameters",
     .kind = Kind::table,
     .read = keep_governor_parameters,
     .text = "parameters of the governor, by number, by name, or by both as DcDesk 2000 prints them"},
    {.name = "declare",
     .kind = Kind::array,
     .read = [](Context& context, const Entry& entry) { context.postponed.declarations.push_back(&entry); },
     .text = "measurements, switches and sensors of this governor that the shipped catalogue does not know "
             "(D13)"},
};

// --- [gateway] ---

constexpr Key identity_keys[] = {
    {"software_version", Kind::integer, optional, Limit::value, 0, 65535,
     [](Context& context, const Entry& entry) {
         context.settings().identity.software_version = unsigned_of(entry);
     },
     "software version of the gateway, 3842, for 1018h:3 (D32)", "0"},
    {"serial_date", Kind::integer, optional, Limit::value, 0, 9912,
     [](Context& context, const Entry& entry) {
         context.settings().identity.serial_date = unsigned_of(entry);
     },
     "serial date of the gateway, 3844, for 1018h:4 (D32)", "0"},
    {"serial_number", Kind::integer, optional, Limit::value, 0, 65535,
     [](Context& context, const Entry& entry) {
         context.settings().identity.serial_number = unsigned_of(entry);
     },
     "serial number of the gateway, 3845, for 1018h:4 (D32)", "0"},
};
constexpr Table identity_table{"gateway.identity", identity_keys};

void read_family(Context& context, const Entry& entry) {
    if (bit_timing::find_controller(entry.value.text) != nullptr) {
        return;
    }
    std::string help = did_you_mean(entry.value.text, controller_names);
    context.report(rules::key_value, entry.value.range,
                   fmt::format("unknown controller family {}", toml::quoted(entry.value.text)),
                   help.empty() ? fmt::format(R"(the families are "{}" and "{}")", controller_names[0],
                                              controller_names[1])
                                : std::move(help));
}

// Values are taken by read_controller(), when the table as a whole is in order.
constexpr Key controller_keys[] = {
    {.name = "clock_hz",
     .kind = Kind::integer,
     .presence = required,
     .limit = Limit::value,
     .minimum = 1,
     .maximum = 1'000'000'000,
     .text = "clock of the CAN controller in Hz"},
    {.name = "family",
     .kind = Kind::string,
     .presence = required,
     .read = read_family,
     .text = "family of the CAN controller: it decides how bit timing registers become a bit rate (D7)",
     .words = controller_names},
};

std::optional<BitTiming> read_controller(Context& context, const Entry& entry, const Table& table) {
    const std::size_t before = context.findings.all().size();
    read_table(context, entry.value, table);
    if (context.findings.all().size() != before) {
        return std::nullopt;
    }
    BitTiming timing;
    timing.clock_hz = unsigned_of(*entry.value.find("clock_hz"));
    timing.controller = bit_timing::find_controller(entry.value.find("family")->value.text);
    timing.where = context.at(entry.value.range);
    return timing;
}

constexpr Table can1_table{"gateway.bit_timing.can1", controller_keys};
constexpr Table can2_table{"gateway.bit_timing.can2", controller_keys};

constexpr Key bit_timing_keys[] = {
    {.name = "can1",
     .kind = Kind::table,
     .read =
         [](Context& context, const Entry& entry) {
             context.settings().can1_bit_timing = read_controller(context, entry, can1_table);
         },
     .text = "controller of CAN1, the HEINZMANN side",
     .below = &can1_table},
    {.name = "can2",
     .kind = Kind::table,
     .read =
         [](Context& context, const Entry& entry) {
             context.settings().can2_bit_timing = read_controller(context, entry, can2_table);
         },
     .text = "controller of CAN2, the CANopen side",
     .below = &can2_table},
};
constexpr Table bit_timing_table{"gateway.bit_timing", bit_timing_keys};

constexpr Key gateway_keys[] = {
    {.name = "identity",
     .kind = Kind::table,
     .text = "what 1018h shows of the gateway at hand",
     .below = &identity_table},
    {.name = "bit_timing",
     .kind = Kind::table,
     .text = "the CAN controllers; they serve only to verify bit timing set by hand (D7)",
     .below = &bit_timing_table},
    {.name = "parameters",
     .kind = Kind::table,
     .read = keep_gateway_parameters,
     .text = "parameters of the gateway, by number, by name, or by both as DcDesk 2000 prints them"},
};

}  // namespace

constinit const Table governor_table{"governor", governor_keys, parameter::Device::governor};
constinit const Table gateway_table{"gateway", gateway_keys, parameter::Device::gateway};

void keep_governor_parameters(Context& context, const toml::Entry& entry) {
    context.postponed.governor_parameters.push_back(&entry);
}

void keep_gateway_parameters(Context& context, const toml::Entry& entry) {
    context.postponed.gateway_parameters.push_back(&entry);
}

}  // namespace cgw::input
