// SARIF 2.1.0 (OASIS): one run, every rule with its explanation, every finding with its place.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "base/json.hpp"
#include "diagnostic/renderers.hpp"
#include "diagnostic/rules.hpp"
#include "diagnostic/source_lines.hpp"

namespace cgw::diagnostic {
namespace {

using base::JsonWriter;

constexpr std::string_view schema_uri =
    "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json";

// An absolute path becomes a file: URI, any other a relative reference. Colons are encoded too, they would
// make a scheme of what stands before them.
std::string uri_of(const std::string& path) {
    std::string uri = path.starts_with('/') ? "file://" : "";
    for (const char c : path) {
        const auto byte = static_cast<unsigned char>(c);
        const bool plain = byte < 0x80 && (std::isalnum(byte) != 0 ||
                                           std::string_view("-._~/").find(c) != std::string_view::npos);
        uri += plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
    }
    return uri;
}

void write_text(JsonWriter& json, std::string_view key, std::string_view text) {
    json.key(key).begin_object().key("text").string(text).end_object();
}

void write_artifact_location(JsonWriter& json, std::string_view key, const std::string& path) {
    json.key(key).begin_object().key("uri").string(uri_of(path));
    if (path == "-") {
        write_text(json, "description", "standard input");
    }
    json.end_object();
}

void write_physical_location(JsonWriter& json, const Location& where, Utf16Columns& columns) {
    json.key("physicalLocation").begin_object();
    write_artifact_location(json, "artifactLocation", where.path);
    if (where.range.start.line != 0) {
        const Range range = columns.convert(where);
        json.key("region").begin_object();
        json.key("startLine").integer(range.start.line).key("startColumn").integer(range.start.column);
        json.key("endLine").integer(range.end.line).key("endColumn").integer(range.end.column);
        json.end_object();
    }
    json.end_object();
}

void write_help(JsonWriter& json, const Rule& rule) {
    const std::string source = rule.reference.empty() ? "" : fmt::format("Source: {}\n", rule.reference);
    if (rule.example == Example::none) {
        if (!source.empty()) {
            write_text(json, "help", source);
        }
        return;
    }
    json.key("help").begin_object();
    json.key("text").string(fmt::format("Wrong:\n{}\nRight:\n{}\n{}", rule.bad, rule.good, source));
    json.key("markdown")
        .string(fmt::format("Wrong:\n\n```{0}\n{1}```\n\nRight:\n\n```{0}\n{2}```\n\n{3}",
                            language_of(rule.example), rule.bad, rule.good, source));
    json.end_object();
}

void write_rule(JsonWriter& json, const Rule& rule) {
    json.begin_object();
    json.key("id").string(rule.code).key("name").string(rule.name);
    write_text(json, "shortDescription", rule.summary);
    write_text(json, "fullDescription", rule.why);
    write_help(json, rule);
    json.key("defaultConfiguration").begin_object().key("level").string(to_text(rule.level)).end_object();
    json.end_object();
}

void write_driver(JsonWriter& json, const std::string& version) {
    json.key("tool").begin_object().key("driver").begin_object();
    json.key("name").string("cgw");
    if (!version.empty()) {
        json.key("semanticVersion").string(version);
    }
    json.key("rules").begin_array();
    for (const Rule* rule : all_rules()) {
        write_rule(json, *rule);
    }
    json.end_array().end_object().end_object();
}

struct Columns {
    Utf16Columns of_findings;
    Utf16Columns of_related;
};

void write_related(JsonWriter& json, const std::vector<Related>& related, Utf16Columns& columns) {
    json.key("relatedLocations").begin_array();
    for (const Related& place : related) {
        json.begin_object();
        write_physical_location(json, place.where, columns);
        write_text(json, "message", place.message);
        json.end_object();
    }
    json.end_array();
}

void write_result(JsonWriter& json, const Diagnostic& finding, Columns& columns) {
    const auto rules = all_rules();
    json.begin_object();
    json.key("ruleId").string(finding.rule->code);
    json.key("ruleIndex").integer(std::find(rules.begin(), rules.end(), finding.rule) - rules.begin());
    json.key("level").string(to_text(finding.level()));
    write_text(json, "message",
               finding.help.empty() ? finding.message : finding.message + "\nhelp: " + finding.help);
    json.key("locations").begin_array().begin_object();
    write_physical_location(json, finding.where, columns.of_findings);
    json.end_object().end_array();
    if (!finding.related.empty()) {
        write_related(json, finding.related, columns.of_related);
    }
    json.end_object();
}

}  // namespace

std::string render_sarif(const RenderInput& input) {
    SourceLines lines(input.sources);
    Columns columns{Utf16Columns(lines), Utf16Columns(lines)};
    JsonWriter json;
    json.begin_object().key("$schema").string(schema_uri).key("version").string("2.1.0");
    json.key("runs").begin_array().begin_object();
    write_driver(json, input.tool_version);
    json.key("columnKind").string("utf16CodeUnits");
    json.key("artifacts").begin_array();
    for (const FileReport& file : input.files) {
        json.begin_object();
        write_artifact_location(json, "location", file.path);
        json.end_object();
    }
    json.end_array().key("results").begin_array();
    for (const FileReport& file : input.files) {
        for (const Diagnostic& finding : file.findings) {
            write_result(json, finding, columns);
        }
    }
    json.end_array().end_object().end_array().end_object();
    return json.take();
}

}  // namespace cgw::diagnostic
