#include <map>

#include <fmt/format.h>

#include "base/files.hpp"
#include "catalogue/catalogue.hpp"
#include "diagnostic/rules/files.hpp"
#include "diagnostic/rules/keys.hpp"
#include "input/sections.hpp"

namespace cgw::input {
namespace {

namespace rules = diagnostic::rules;
using toml::Entry;
using toml::Kind;
using toml::Node;

void read_one_catalogue(Context& context, const Node& name, const CatalogueLoader& load) {
    const base::Result<std::string> text = load(name.text);
    if (!text) {
        context.report(rules::catalogue_unreadable, name.range, text.error().message);
        return;
    }
    // Findings point at the name seen from where the user is.
    const std::string path = base::beside(context.path, name.text);
    context.file.catalogues.push_back(name.text);
    context.file.sources[path] = *text;
    catalogue::read_catalogue(*text, path, context.catalogue, context.findings);
}

}  // namespace

void read_catalogues(Context& context, const CatalogueLoader& load) {
    if (context.postponed.catalogues == nullptr) {
        return;
    }
    std::map<std::string, diagnostic::Range> named;
    for (const Node& name : context.postponed.catalogues->value.elements) {
        if (!check_value(context, name, catalogue_name, catalogue_name.name)) {
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
