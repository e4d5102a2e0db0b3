// Frames and signals as JSON: schemas/frames.schema.json.
#include <algorithm>
#include <array>

#include "base/json.hpp"
#include "signals/layout.hpp"

namespace cgw::signals {
namespace {

constexpr int format_version = 1;
constexpr unsigned byte_bits = 8;

constexpr std::array formats = {
    Format{"text", "for people, in 80 columns", render_layout_text},
    Format{"md", "Markdown", render_layout_markdown},
    Format{"json", "one JSON document", render_layout_json},
};

void number_or_null(base::JsonWriter& json, std::string_view key, std::int64_t number) {
    json.key(key);
    number == 0 ? json.null() : json.integer(number);
}

void add_sources(base::JsonWriter& json, std::string_view key, const std::vector<Source>& sources) {
    json.key(key).begin_array();
    for (const Source& source : sources) {
        json.begin_object();
        json.key("device").string(parameter::to_text(source.device));
        json.key("number").integer(source.number);
        json.key("name").string(source.name);
        json.key("low_active").boolean(source.low_active);
        json.end_object();
    }
    json.end_array();
}

void add_place(base::JsonWriter& json, const Signal& signal) {
    json.key("name").string(signal.name);
    json.key("kind").string(to_text(signal.kind));
    json.key("first_byte").integer(signal.first_bit / byte_bits);
    json.key("first_bit").integer(signal.first_bit);
    json.key("bits").integer(signal.width);
    json.key("signed").boolean(signal.is_signed);
    json.key("index").integer(signal.index);
    json.key("sub_index").integer(signal.sub_index);
    json.key("object_bit");
    signal.is_bit() ? json.integer(signal.object_bit) : json.null();
    number_or_null(json, "channel", signal.channel);
    number_or_null(json, "parameter", signal.number);
    add_sources(json, "parameters", signal.sources);
    add_sources(json, "scaled_as", signal.scaled_as);
}

void add_scaling(base::JsonWriter& json, const Signal& signal) {
    json.key("scaled").boolean(signal.scaled);
    json.key("factor").real(signal.factor);
    json.key("offset").real(signal.offset);
    json.key("raw_minimum").integer(signal.raw_minimum);
    json.key("raw_maximum").integer(signal.raw_maximum);
    json.key("minimum").real(signal.minimum);
    json.key("maximum").real(signal.maximum);
    json.key("unit").string(signal.unit);
    json.key("values").begin_array();
    for (const NamedValue& value : signal.values) {
        json.begin_object().key("raw").integer(value.raw).key("text").string(value.text).end_object();
    }
    json.end_array();
    const Example example = example_of(signal);
    json.key("example").begin_object();
    json.key("value").string(example.asked);
    json.key("raw").integer(example.raw);
    json.key("bytes").string(example.bytes);
    json.key("shown").string(example.shown);
    json.end_object();
}

void add_frame(base::JsonWriter& json, const Frame& frame) {
    json.begin_object();
    json.key("name").string(frame.name);
    json.key("direction").string(frame.transmit() ? "transmit" : "receive");
    json.key("number").integer(frame.number);
    json.key("cob_id").integer(frame.identifier);
    json.key("length").integer(frame.length);
    number_or_null(json, "period_us", frame.period_us);
    number_or_null(json, "monitoring_us", frame.monitoring_us);
    json.key("communication").integer(frame.communication);
    json.key("mapping").integer(frame.mapping);
    json.key("words").begin_array();
    for (const Word& word : frame.words) {
        json.begin_object();
        json.key("index").integer(word.index).key("sub_index").integer(word.sub_index);
        json.end_object();
    }
    json.end_array();
    json.key("signals").begin_array();
    for (const Signal& signal : frame.signals) {
        json.begin_object();
        add_place(json, signal);
        add_scaling(json, signal);
        json.end_object();
    }
    json.end_array().end_object();
}

}  // namespace

std::span<const Format> layout_formats() {
    return formats;
}

std::string render_layout_json(const Sheet& sheet) {
    base::JsonWriter json;
    json.begin_object();
    json.key("format_version").integer(format_version);
    json.key("title").string(sheet.title);
    json.key("node_id").integer(sheet.node_id);
    json.key("configuration_id").string(sheet.configuration_id);
    json.key("frames").begin_array();
    for (const Frame& frame : sheet.frames) {
        add_frame(json, frame);
    }
    json.end_array().end_object();
    return json.take();
}

}  // namespace cgw::signals
