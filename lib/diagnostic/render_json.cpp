#include <algorithm>

#include "base/json.hpp"
#include "diagnostic/renderers.hpp"

namespace cgw::diagnostic {
namespace {

void write_position(base::JsonWriter& json, std::string_view key, const Position& position) {
    json.key(key).begin_object();
    // A finding about the file as a whole stands at its beginning.
    json.key("line")
        .integer(std::max(position.line, 1U))
        .key("column")
        .integer(std::max(position.column, 1U));
    json.end_object();
}

void write_range(base::JsonWriter& json, const Range& range) {
    json.key("range").begin_object();
    write_position(json, "start", range.start);
    write_position(json, "end", range.end);
    json.end_object();
}

void write_finding(base::JsonWriter& json, const Diagnostic& finding) {
    json.begin_object();
    json.key("code").string(finding.rule->code).key("name").string(finding.rule->name);
    json.key("level").string(to_text(finding.level())).key("message").string(finding.message);
    write_range(json, finding.where.range);
    json.key("related").begin_array();
    for (const Related& related : finding.related) {
        json.begin_object().key("path").string(related.where.path);
        write_range(json, related.where.range);
        json.key("message").string(related.message).end_object();
    }
    json.end_array();
    json.key("help").string(finding.help);
    json.end_object();
}

bool has_error(const FileReport& file) {
    return std::any_of(file.findings.begin(), file.findings.end(),
                       [](const Diagnostic& finding) { return finding.level() == Level::error; });
}

}  // namespace

std::string render_json(const RenderInput& input) {
    base::JsonWriter json;
    json.begin_object().key("format_version").integer(1);
    json.key("valid").boolean(std::none_of(input.files.begin(), input.files.end(), has_error));
    json.key("files").begin_array();
    for (const FileReport& file : input.files) {
        json.begin_object().key("path").string(file.path).key("diagnostics").begin_array();
        for (const Diagnostic& finding : file.findings) {
            write_finding(json, finding);
        }
        json.end_array().key("not_verified").begin_array();
        for (const std::string& line : file.not_verified) {
            json.string(line);
        }
        json.end_array().end_object();
    }
    json.end_array().end_object();
    return json.take();
}

}  // namespace cgw::diagnostic
