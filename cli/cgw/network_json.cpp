#include "base/json.hpp"
#include "cli/cgw/network_report.hpp"

namespace cgw::cli {
namespace {

using base::JsonWriter;
using network::Analysis;
using network::MessageResult;

constexpr double us_per_ms = 1000;

void write_time(JsonWriter& json, std::string_view key, std::uint64_t us) {
    json.key(key);
    us == 0 ? json.null() : json.real(static_cast<double>(us) / us_per_ms);
}

void write_text(JsonWriter& json, std::string_view key, const std::string& text) {
    json.key(key);
    text.empty() ? json.null() : json.string(text);
}

std::string_view bound_text(network::Bound bound) {
    constexpr std::string_view names[] = {"found", "none", "not-found"};
    return names[static_cast<std::size_t>(bound)];
}

void write_message(JsonWriter& json, const MessageResult& result) {
    const network::Message& message = result.message;
    json.begin_object().key("identifier").integer(message.identifier).key("name").string(message.name);
    write_text(json, "sender", message.sender);
    json.key("bytes").integer(message.bytes).key("worst_bits").integer(result.worst_bits);
    json.key("release").string(message.release == network::Release::cyclic ? "cyclic" : "event");
    json.key("assumed").boolean(message.assumed);
    write_time(json, "period_ms", message.period_us);
    json.key("jitter_ms").real(static_cast<double>(message.jitter_us) / us_per_ms);
    write_time(json, "deadline_ms", message.deadline_us);
    json.key("average_load").real(result.load.average).key("worst_load").real(result.load.worst);
    json.key("bound").string(bound_text(result.bound));
    write_time(json, "response_ms", result.bounded() ? result.response_us : 0);
    json.key("in_time").boolean(result.in_time()).end_object();
}

void write_analysis(JsonWriter& json, const Analysis& analysis, const network::Bands& bands, bool fails) {
    json.begin_object().key("works").boolean(!fails);
    json.key("bit_rate").integer(analysis.bus.bit_rate);
    json.key("errors_per_second").real(analysis.bus.errors_per_second);
    json.key("average_load").real(analysis.load.average).key("worst_load").real(analysis.load.worst);
    json.key("band").string(to_text(network::band_of(analysis.load.worst, bands)));
    json.key("messages").begin_array();
    for (const MessageResult& result : analysis.messages) {
        write_message(json, result);
    }
    json.end_array().end_object();
}

void write_texts(JsonWriter& json, std::string_view key, const std::vector<std::string>& texts) {
    json.key(key).begin_array();
    for (const std::string& text : texts) {
        json.string(text);
    }
    json.end_array();
}

}  // namespace

std::string network_json(const NetworkReport& report) {
    JsonWriter json;
    json.begin_object().key("format_version").integer(1).key("works").boolean(!report.fails);
    json.key("plants").begin_array();
    for (const network::Member& member : report.members) {
        json.begin_object().key("path").string(member.path);
        json.key("node_id").integer(member.node_id).end_object();
    }
    json.end_array();
    json.key("bands").begin_object().key("comfortable").real(report.bands.comfortable);
    json.key("ok").real(report.bands.ok).key("fail").real(report.bands.fail).end_object();
    write_texts(json, "what_if", report.changes);
    json.key("result");
    write_analysis(json, report.analysis, report.bands, report.fails);
    json.key("before");
    if (report.before) {
        write_analysis(json, *report.before, report.bands, report.fails_before);
    } else {
        json.null();
    }
    json.key("identifiers").begin_array();
    for (const network::IdentifierRange& range : report.map) {
        json.begin_object().key("first").integer(range.first).key("last").integer(range.last);
        json.key("use").string(to_text(range.use));
        write_texts(json, "owners", range.owners);
        json.end_object();
    }
    json.end_array();
    write_texts(json, "not_counted", report.left_out);
    diagnostic::RenderInput findings;
    findings.files = report.findings;
    json.key("findings").json(diagnostic::render_json(findings));
    return json.end_object().take();
}

}  // namespace cgw::cli
