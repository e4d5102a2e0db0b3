#include "input/sections.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <optional>

#include "base/numbers.hpp"
#include "catalogue/catalogue.hpp"
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
    {"created", Kind::local_date, optional, Limit::none, 0, 0, read_created},
    // 245: CreatedBy of an EDS (CiA 306).
    {"author", Kind::string, optional, Limit::bytes, 0, 245,
     [](Context& context, const Entry& entry) { context.settings().document.author = entry.value.text; }},
    {"revision", Kind::integer, optional, Limit::value, 0, 255,
     [](Context& context, const Entry& entry) { context.settings().document.revision = unsigned_of(entry); }},
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
    {"profile", Kind::string, optional, Limit::none, 0, 0, read_profile},
    {"main_cycle_us", Kind::integer, optional, Limit::value, 1000, 1'000'000,
     [](Context& context, const Entry& entry) { context.settings().main_cycle_us = unsigned_of(entry); }},
    {"parameters", Kind::table, optional, Limit::none, 0, 0, keep_governor_parameters},
    {"declare", Kind::array, optional, Limit::none, 0, 0,
     [](Context& context, const Entry& entry) { context.postponed.declarations.push_back(&entry); }},
};
constexpr Table governor_table{"governor", governor_keys, parameter::Device::governor};

// --- [gateway] ---

constexpr Key identity_keys[] = {
    {"software_version", Kind::integer, optional, Limit::value, 0, 65535,
     [](Context& context, const Entry& entry) {
         context.settings().identity.software_version = unsigned_of(entry);
     }},
    {"serial_date", Kind::integer, optional, Limit::value, 0, 9912,
     [](Context& context, const Entry& entry) {
         context.settings().identity.serial_date = unsigned_of(entry);
     }},
    {"serial_number", Kind::integer, optional, Limit::value, 0, 65535,
     [](Context& context, const Entry& entry) {
         context.settings().identity.serial_number = unsigned_of(entry);
     }},
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
void leave_it(Context& /*context*/, const Entry& /*entry*/) {}

constexpr Key controller_keys[] = {
    {"clock_hz", Kind::integer, required, Limit::value, 1, 1'000'000'000, leave_it},
    {"family", Kind::string, required, Limit::none, 0, 0, read_family},
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
    {"can1", Kind::table, optional, Limit::none, 0, 0,
     [](Context& context, const Entry& entry) {
         context.settings().can1_bit_timing = read_controller(context, entry, can1_table);
     }},
    {"can2", Kind::table, optional, Limit::none, 0, 0,
     [](Context& context, const Entry& entry) {
         context.settings().can2_bit_timing = read_controller(context, entry, can2_table);
     }},
};
constexpr Table bit_timing_table{"gateway.bit_timing", bit_timing_keys};

void keep_gateway_parameters(Context& context, const Entry& entry) {
    context.postponed.gateway_parameters.push_back(&entry);
}

constexpr Key gateway_keys[] = {
    {"identity", Kind::table, optional, Limit::none, 0, 0,
     [](Context& context, const Entry& entry) { read_table(context, entry.value, identity_table); }},
    {"bit_timing", Kind::table, optional, Limit::none, 0, 0,
     [](Context& context, const Entry& entry) { read_table(context, entry.value, bit_timing_table); }},
    {"parameters", Kind::table, optional, Limit::none, 0, 0, keep_gateway_parameters},
};
constexpr Table gateway_table{"gateway", gateway_keys, parameter::Device::gateway};

// --- [network] ---

void read_nodes(Context& context, const Entry& entry) {
    std::map<std::int64_t, diagnostic::Range> listed;
    for (const Node& element : entry.value.elements) {
        if (!check_type(context, element, Kind::integer, "a node id") ||
            !check_integer(context, element, 1, 127, "a node id")) {
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

constexpr Key network_keys[] = {{"nodes", Kind::array, optional, Limit::none, 0, 0, read_nodes}};
constexpr Table network_table{"network", network_keys};

// --- the top of the file ---

constexpr Key document_top_keys[] = {
    {"format", Kind::integer, optional, Limit::none, 0, 0, leave_it},  // judged before anything else is read
    // 200: with room for what an EDS adds in its Description of 243 bytes.
    {"title", Kind::string, optional, Limit::bytes, 1, 200,
     [](Context& context, const Entry& entry) { context.settings().title = entry.value.text; }},
    {"catalogue", Kind::array, optional, Limit::elements, 0, 16,
     [](Context& context, const Entry& entry) { context.postponed.catalogues = &entry; }},
    {"document", Kind::table, split, Limit::none, 0, 0,
     [](Context& context, const Entry& entry) { read_table(context, entry.value, document_table); }},
    {"governor", Kind::table, split, Limit::none, 0, 0,
     [](Context& context, const Entry& entry) { read_table(context, entry.value, governor_table); }},
    {"gateway", Kind::table, split, Limit::none, 0, 0,
     [](Context& context, const Entry& entry) { read_table(context, entry.value, gateway_table); }},
    {"network", Kind::table, split, Limit::none, 0, 0,
     [](Context& context, const Entry& entry) { read_table(context, entry.value, network_table); }},
};

constexpr Key joined_keys[] = {
    {"governor.parameters", Kind::table, optional, Limit::none, 0, 0, keep_governor_parameters},
    {"gateway.parameters", Kind::table, optional, Limit::none, 0, 0, keep_gateway_parameters},
};
constexpr Table top_table{"", document_top_keys, std::nullopt, joined_keys};

// Where a catalogue's findings point: its name seen from where the user is.
std::string beside(const std::string& file, const std::string& name) {
    return file == "-" ? name : (std::filesystem::path(file).parent_path() / name).string();
}

void read_one_catalogue(Context& context, const Node& name, const CatalogueLoader& load) {
    const base::Result<std::string> text = load(name.text);
    if (!text) {
        context.report(rules::catalogue_unreadable, name.range, text.error().message);
        return;
    }
    const std::string path = beside(context.path, name.text);
    context.file.catalogues.push_back(name.text);
    context.file.sources[path] = *text;
    catalogue::read_catalogue(*text, path, context.catalogue, context.findings);
}

}  // namespace

const toml::Entry* misspelt_at_top(const Node& document, std::string_view name) {
    return misspelt(document, top_table, name);
}

void read_sections(Context& context, const Node& document) {
    read_table(context, document, top_table);
}

void read_catalogues(Context& context, const CatalogueLoader& load) {
    if (context.postponed.catalogues == nullptr) {
        return;
    }
    constexpr std::int64_t longest_path = 4096;
    std::map<std::string, diagnostic::Range> named;
    for (const Node& name : context.postponed.catalogues->value.elements) {
        if (!check_type(context, name, Kind::string, "a catalogue's name") ||
            !check_text(context, name, 1, longest_path, "a catalogue's name")) {
            continue;
        }
        const auto [first, is_new] = named.try_emplace(name.text, name.range);
        if (is_new) {
            read_one_catalogue(context, name, load);
            continue;
        }
        context.findings.report({&rules::key_value,
                                 fmt::format("catalogue {} is named twice", toml::quoted(name.text)),
                                 context.at(name.range),
                                 {{context.at(first->second), "first named here"}}});
    }
}

void read_declarations(Context& context) {
    for (const Entry* declarations : context.postponed.declarations) {
        for (const Node& table : declarations->value.elements) {
            if (check_type(context, table, Kind::table, "a declaration")) {
                catalogue::read_declaration(table, context.path, context.catalogue, context.findings);
            }
        }
    }
}

}  // namespace cgw::input
