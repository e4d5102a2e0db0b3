// JSON, a document on each line, so that a log of any size can be read while it grows:
// schemas/decoded-log.schema.json.
#include "base/json.hpp"
#include "diagnostic/rule.hpp"
#include "signals/codec.hpp"
#include "traffic/render_parts.hpp"

#include <fmt/format.h>

namespace cgw::traffic {
namespace {

constexpr int format_version = 1;

std::int64_t number(std::uint64_t value) {
    return static_cast<std::int64_t>(value);
}

void number_or_null(base::JsonWriter& json, std::string_view key, std::uint64_t value) {
    json.key(key);
    value == 0 ? json.null() : json.integer(number(value));
}

void add_signals(base::JsonWriter& json, const signals::Frame& pdo, std::span<const std::uint8_t> data) {
    json.key("signals").begin_array();
    for (const signals::Signal& signal : pdo.signals) {
        if (!signals::reaches(signal, data)) {
            continue;
        }
        const std::int32_t raw = signals::raw_value(signal, data);
        json.begin_object();
        json.key("name").string(signal.name);
        json.key("raw").integer(raw);
        json.key("physical").real(signals::physical_value(signal, raw));
        json.key("unit").string(signal.unit);
        json.key("text").string(signals::value_text(signal, raw));
        json.end_object();
    }
    json.end_array();
}

void add_watched(base::JsonWriter& json, const Watched& watched) {
    const Rhythm& rhythm = watched.rhythm;
    json.begin_object();
    json.key("name").string(watched.name);
    json.key("cob_id").integer(watched.identifier);
    json.key("count").integer(number(rhythm.frames()));
    number_or_null(json, "period_us", rhythm.period_us());
    number_or_null(json, "monitoring_us", rhythm.monitoring_us());
    json.key("gaps").integer(number(rhythm.gaps()));
    json.key("shortest_us").integer(number(rhythm.shortest_us()));
    json.key("mean_us").real(rhythm.mean_us());
    json.key("longest_us").integer(number(rhythm.longest_us()));
    json.end_object();
}

void add_finding(base::JsonWriter& json, const diagnostic::Diagnostic& finding) {
    json.begin_object();
    json.key("code").string(finding.rule->code);
    json.key("name").string(finding.rule->name);
    json.key("level").string(diagnostic::to_text(finding.level()));
    json.key("message").string(finding.message);
    number_or_null(json, "line", finding.where.range.start.line);
    json.end_object();
}

}  // namespace

std::string json_head(const Subject& subject) {
    base::JsonWriter json;
    json.begin_object();
    json.key("kind").string("log");
    json.key("format_version").integer(format_version);
    json.key("node_id").integer(subject.node_id);
    json.key("configuration_id").string(subject.configuration_id);
    json.end_object();
    return json.take();
}

std::string json_frame(const Told& told) {
    const frame::Frame& frame = told.logged.frame;
    const std::span<const std::uint8_t> data(frame.data.data(), frame.remote ? 0U : frame.length);
    base::JsonWriter json;
    json.begin_object();
    json.key("kind").string("frame");
    json.key("time_us");
    told.has_time ? json.integer(number(told.logged.time_us)) : json.null();
    json.key("interface").string(told.logged.interface_name);
    json.key("id").integer(frame.id);
    json.key("extended").boolean(frame.extended);
    json.key("remote").boolean(frame.remote);
    json.key("data").string(fmt::format("{:02X}", fmt::join(data, "")));
    json.key("service").string(to_text(told.meaning.owner.service));
    json.key("name").string(told.meaning.name);
    number_or_null(json, "node", told.meaning.owner.node);
    json.key("text").string(told.meaning.text);
    if (told.meaning.owner.frame != nullptr) {
        add_signals(json, *told.meaning.owner.frame, data);
    }
    json.end_object();
    return json.take();
}

std::string json_foot(const Audit& audit, std::span<const diagnostic::Diagnostic> findings) {
    base::JsonWriter json;
    json.begin_object();
    json.key("kind").string("audit");
    json.key("count").integer(number(audit.frames()));
    json.key("passed_over").integer(number(audit.passed_over()));
    json.key("faults").integer(number(audit.faults()));
    json.key("first_us").integer(number(audit.first_us()));
    json.key("last_us").integer(number(audit.last_us()));
    json.key("timed").boolean(audit.timed());
    json.key("operational").boolean(audit.was_operational());
    json.key("frames").begin_array();
    for (const Watched& watched : audit.watched()) {
        add_watched(json, watched);
    }
    json.end_array().key("findings").begin_array();
    for (const diagnostic::Diagnostic& finding : findings) {
        add_finding(json, finding);
    }
    json.end_array().end_object();
    return json.take();
}

}  // namespace cgw::traffic
