#include <array>

#include "base/json.hpp"
#include "facts/communication.hpp"
#include "live/report.hpp"
#include "live/sources.hpp"

namespace cgw::live {
namespace {

using base::JsonWriter;

constexpr int format_version = 1;

void number_or_null(JsonWriter& json, std::string_view key, bool known, std::uint32_t value) {
    json.key(key);
    known ? json.integer(value) : json.null();
}

void parameters(JsonWriter& json, const Sources& sources) {
    json.key("parameters").begin_array();
    for (const Sources::Parameter& parameter : sources.parameters) {
        json.begin_object();
        json.key("device").string(parameter::to_text(parameter.row->device));
        json.key("number").integer(parameter.row->number);
        json.key("name").string(parameter.row->name);
        json.key("value").real(parameter.value);
        json.end_object();
    }
    json.end_array();
}

void difference(JsonWriter& json, const Subject& subject, const Question& question,
                const Difference& difference) {
    const bool of_value = difference.kind == DifferenceKind::value;
    const Sources sources =
        sources_of(question.index, question.sub_index, subject.settings, subject.catalogue);
    json.begin_object();
    json.key("kind").string(to_text(difference.kind));
    json.key("index").integer(question.index);
    json.key("sub_index").integer(question.sub_index);
    json.key("name").string(question.name);
    number_or_null(json, "file", of_value, question.expected);
    number_or_null(json, "device", difference.value.has_value(), difference.value.value_or(0));
    number_or_null(json, "abort_code", difference.abort != object::AbortCode::none,
                   static_cast<std::uint32_t>(difference.abort));
    json.key("message").string(of_value ? "the device has another value" : sentence_of(question, difference));
    json.key("source").string(sources.text);
    parameters(json, sources);
    json.end_object();
}

// What 1000h and 1018h say, null for what was not read.
void device(JsonWriter& json, const Verification& verification) {
    struct Key {
        std::string_view key;
        std::uint16_t index;
        std::uint8_t sub_index;
    };
    constexpr std::array keys{
        Key{"device_type", facts::object::device_type, 0}, Key{"vendor", facts::object::identity, 1},
        Key{"product", facts::object::identity, 2},        Key{"revision", facts::object::identity, 3},
        Key{"serial", facts::object::identity, 4},
    };
    json.key("device").begin_object();
    for (const Key& key : keys) {
        std::optional<std::uint32_t> value;
        for (std::size_t i = 0; i < verification.plan().size() && !value; ++i) {
            const Question& question = verification.plan()[i];
            if (question.index == key.index && question.sub_index == key.sub_index) {
                value = verification.result().values[i];
            }
        }
        number_or_null(json, key.key, value.has_value(), value.value_or(0));
    }
    json.end_object();
}

}  // namespace

std::string render_json(const Subject& subject, const Verification& verification,
                        const Connection& connection) {
    const Result& result = verification.result();
    JsonWriter json;
    json.begin_object();
    json.key("format_version").integer(format_version);
    json.key("same").boolean(result.same());
    json.key("path").string(subject.path);
    json.key("configuration_id").string(subject.configuration_id);
    json.key("channel").string(subject.channel);
    json.key("node_id").integer(subject.configuration.node_id);
    json.key("ending").string(to_text(result.ending));
    json.key("diagnosis").begin_array();
    for (const std::string& line : diagnosis(subject, verification, connection)) {
        json.string(line);
    }
    json.end_array();
    device(json, verification);
    json.key("questions").integer(static_cast<std::int64_t>(verification.plan().size()));
    json.key("asked").integer(static_cast<std::int64_t>(result.asked));
    json.key("wrote").boolean(subject.wrote);
    json.key("other_client").boolean(result.heard.other_client);
    json.key("differences").begin_array();
    for (const Difference& found : result.differences) {
        difference(json, subject, verification.plan()[found.question], found);
    }
    json.end_array();
    json.end_object();
    return json.take();
}

std::span<const Format> formats() {
    static constexpr Format rows[] = {
        {"human", "for people", render_text},
        {"json", "one JSON document", render_json},
    };
    return rows;
}

}  // namespace cgw::live
