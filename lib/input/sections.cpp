#include "input/sections.hpp"

#include "base/numbers.hpp"
#include "diagnostic/rules/keys.hpp"
#include "input/device_sections.hpp"
#include "input/network_section.hpp"
#include "input/table_reader.hpp"

namespace cgw::input {
namespace {

namespace rules = diagnostic::rules;
using toml::Entry;
using toml::Kind;
using toml::Node;

using enum Presence;

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

// --- the top of the file ---

constexpr Key document_top_keys[] = {
    // Judged before anything else is read.
    {.name = "format",
     .kind = Kind::integer,
     .limit = Limit::value,
     .minimum = parameter_file_format,
     .maximum = parameter_file_format,
     .text = "version of this file format"},
    {"title", Kind::string, optional, Limit::bytes, 1, parameter::longest_title,
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
