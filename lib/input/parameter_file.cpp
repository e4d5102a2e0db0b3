#include "input/parameter_file.hpp"

#include <fmt/format.h>

#include <optional>

#include "catalogue/catalogue.hpp"
#include "diagnostic/rules/files.hpp"
#include "input/context.hpp"
#include "input/parameter_values.hpp"
#include "input/sections.hpp"
#include "toml/document.hpp"

namespace cgw::input {
namespace {

namespace rules = diagnostic::rules;

// False when the file is written in a format that this program does not read. A missing or mistyped format
// is a finding, here or when the sections are read, and the file is read as format 1.
bool check_format(Context& context, const toml::Node& document) {
    const toml::Entry* format = document.find("format");
    if (catalogue::is_catalogue(document)) {
        context.report(rules::format_missing, document.range,
                       "this is a catalogue file, not a parameter file",
                       "name it in a parameter file: catalogue = [\"FILE\"]");
        return false;
    }
    if (format == nullptr) {
        format = misspelt_at_top(document, "format");  // reported with the sections
    }
    if (format == nullptr) {
        context.report(rules::format_missing, document.range, "the file does not say its format",
                       fmt::format("begin it with format = {}", parameter_file_format));
        return true;
    }
    const toml::Node& value = format->value;
    if (value.kind != toml::Kind::integer || value.integer == parameter_file_format) {
        return true;
    }
    const bool is_newer = value.integer > parameter_file_format;
    context.report(rules::format_unsupported, value.range,
                   fmt::format("the file is written in format {}, and this cgw reads format {}", value.text,
                               parameter_file_format),
                   is_newer ? "use a newer cgw" : fmt::format("write format = {}", parameter_file_format));
    return false;
}

}  // namespace

ReadResult read_parameter_file(std::string_view text, const std::string& path,
                               parameter::Catalogue& catalogue, const CatalogueLoader& load,
                               diagnostic::Findings& findings) {
    const std::optional<toml::Node> document = toml::parse(text, path, findings);
    if (!document) {
        ReadResult nothing;
        nothing.file.settings.path = path;
        return nothing;
    }
    return read_parameter_file(*document, path, catalogue, load, findings);
}

ReadResult read_parameter_file(const toml::Node& document, const std::string& path,
                               parameter::Catalogue& catalogue, const CatalogueLoader& load,
                               diagnostic::Findings& findings) {
    ReadResult result;
    result.file.settings.path = path;
    Context context{path, catalogue, findings, result.file};
    if (!check_format(context, document)) {
        return result;
    }
    result.usable = true;
    read_sections(context, document);
    read_catalogues(context, load);
    read_declarations(context);
    result.file.settings.declarations = catalogue.added();
    read_parameters(context, parameter::Device::governor, context.postponed.governor_parameters);
    read_parameters(context, parameter::Device::gateway, context.postponed.gateway_parameters);
    // A key in one device's table may belong to the other.
    report_missing(context, parameter::Device::governor);
    report_missing(context, parameter::Device::gateway);
    return result;
}

}  // namespace cgw::input
