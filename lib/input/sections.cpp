#include "input/sections.hpp"

#include <fmt/format.h>

#include <map>
#include <optional>

#include "base/numbers.hpp"
#include "facts/identifiers.hpp"
#include "input/table_reader.hpp"

namespace cgw::input {
namespace {

namespace rules = diagnostic::rules;
using parameter::BitTiming;
using parameter::ControllerFamily;
using toml::Entry;
using toml::Kind;
using toml::Node;

constexpr std::string_view profiles[] = {"digital-governor"};

struct Family {
    std::string_view name;
    ControllerFamily family;
};
constexpr Family families[] = {{"mcp2515", ControllerFamily::mcp2515},
                               {"at90can", ControllerFamily::at90can}};
constexpr std::string_view family_names[] = {families[0].name, families[1].name};

using enum Presence;

std::uint32_t unsigned_of(const Entry& entry) {
    return static_cast<std::uint32_t>(entry.value.integer);
}

// --- [document] ---

void read_created(Context& context, const Entry& entry) {
    const std::string_view text = entry.value.text;  // YYYY-MM-DD
    const auto number = [&](std::size_t begin, std::size_t length) {
        return static_cast<int>(base::parse_integer(text.substr(begin, length)).value_or(0));
    };
    context.settings().document.created = parameter::Date{number(0, 4), number(5, 2), number(8, 2)};
}

constexpr Key document_keys[] = {
    {.name = "created",
     .kind = Kind::local_date,
     .read = read_created,
     .text = "date of the artefacts; without it SOURCE_DATE_EPOCH, and without that 2004-05-19"},
    // 245: CreatedBy of an EDS (CiA 306).
    {"author", Kind::string, optional, Limit::bytes, 0, 245,
     [](Context& context, const Entry& entry) { context.settings().document.author = entry.value.text; },
     "author of the file, for the EDS"},
    {"revision", Kind::integer, optional, Limit::value, 0, 255,
     [](Context& context, const Entry& entry) { context.settings().document.revision = unsigned_of(entry); },
     "revision of the file: FileRevision of the EDS", "0"},
};
constexpr Table document_table{"document", document_keys};

// --- [governor] ---

void read_profile(Context& context, const Entry& entry) {
    if (entry.value.text != profiles[0]) {
        context.report(rules::key_value, entry.value.range,
                       fmt::format("unknown profile {}", toml::quoted(entry.value.text)),
                       fmt::format("the profile is \"{}\"", profiles[0]));
    }
}

void keep_governor_parameters(Context& context, const Entry& entry) {
    context.postponed.governor_parameters.push_back(&entry);
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
constexpr Table governor_table{"governor", governor_keys, parameter::Device::governor};

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
    for (const Family& family : families) {
        if (family.name == entry.value.text) {
            return;
        }
    }
    std::string help = did_you_mean(entry.value.text, family_names);
    context.report(rules::key_value, entry.value.range,
                   fmt::format("unknown controller family {}", toml::quoted(entry.value.text)),
                   help.empty()
                       ? fmt::format(R"(the families are "{}" and "{}")", family_names[0], family_names[1])
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
     .words = family_names},
};

std::optional<BitTiming> read_controller(Context& context, const Entry& entry, const Table& table) {
    const std::size_t before = context.findings.all().size();
    read_table(context, entry.value, table);
    if (context.findings.all().size() != before) {
        return std::nullopt;
    }
    BitTiming timing;
    timing.clock_hz = unsigned_of(*entry.value.find("clock_hz"));
    for (const Family& family : families) {
        if (family.name == entry.value.find("family")->value.text) {
            timing.family = family.family;
        }
    }
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

void keep_gateway_parameters(Context& context, const Entry& entry) {
    context.postponed.gateway_parameters.push_back(&entry);
}

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
constexpr Table gateway_table{"gateway", gateway_keys, parameter::Device::gateway};

// --- [network] ---

constexpr Key node_id = {.name = "a node id",
                         .kind = Kind::integer,
                         .limit = Limit::value,
                         .minimum = 1,
                         .maximum = facts::maximum_node_id,
                         .text = "node id of another node"};

void read_nodes(Context& context, const Entry& entry) {
    std::map<std::int64_t, diagnostic::Range> listed;
    for (const Node& element : entry.value.elements) {
        if (!check_value(context, element, node_id, node_id.name)) {
            continue;
        }
        const auto [first, is_new] = listed.try_emplace(element.integer, element.range);
        if (is_new) {
            context.settings().network_nodes.push_back(
                {static_cast<std::uint8_t>(element.integer), context.at(element.range)});
            continue;
        }
        context.findings.report({&rules::network_node_duplicate,
                                 fmt::format("node {} is listed twice", element.integer),
                                 context.at(element.range),
                                 {{context.at(first->second), "first listed here"}}});
    }
}

constexpr Key network_keys[] = {
    {.name = "nodes",
     .kind = Kind::array,
     .read = read_nodes,
     .text = "node ids of the other nodes on the CANopen bus, against which identifiers are checked (D33)",
     .element = &node_id},
};
constexpr Table network_table{"network", network_keys};

// --- the top of the file ---

constexpr Key document_top_keys[] = {
    // Judged before anything else is read.
    {.name = "format",
     .kind = Kind::integer,
     .limit = Limit::value,
     .minimum = parameter_file_format,
     .maximum = parameter_file_format,
     .text = "version of this file format"},
    // 200: with room for what an EDS adds in its Description of 243 bytes.
    {"title", Kind::string, optional, Limit::bytes, 1, 200,
     [](Context& context, const Entry& entry) { context.settings().title = entry.value.text; },
     "name of the plant; it stands on every artefact"},
    {.name = "catalogue",
     .kind = Kind::array,
     .limit = Limit::elements,
     .maximum = 16,
     .read = [](Context& context, const Entry& entry) { context.postponed.catalogues = &entry; },
     .text = "catalogue files with parameters that cgw does not know; paths are relative to this file",
     .element = &catalogue_name},
    {.name = "document",
     .kind = Kind::table,
     .presence = split,
     .text = "what EDS and report say about the file itself",
     .below = &document_table},
    {.name = "governor",
     .kind = Kind::table,
     .presence = split,
     .text = "the digital governor",
     .below = &governor_table},
    {.name = "gateway",
     .kind = Kind::table,
     .presence = split,
     .text = "the CANopen gateway",
     .below = &gateway_table},
    {.name = "network",
     .kind = Kind::table,
     .presence = split,
     .text = "the rest of the CANopen network",
     .below = &network_table},
};

constexpr Key joined_keys[] = {
    {"governor.parameters", Kind::table, optional, Limit::none, 0, 0, keep_governor_parameters},
    {"gateway.parameters", Kind::table, optional, Limit::none, 0, 0, keep_gateway_parameters},
};
constexpr Table top_table{"", document_top_keys, std::nullopt, joined_keys};

}  // namespace

const Table& file_table() {
    return top_table;
}

const toml::Entry* misspelt_at_top(const Node& document, std::string_view name) {
    return misspelt(document, top_table, name);
}

void read_sections(Context& context, const Node& document) {
    read_table(context, document, top_table);
}

}  // namespace cgw::input
