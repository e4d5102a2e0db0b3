#include "base/json.hpp"
#include "base/sha256.hpp"
#include "cli/cgw/image_report.hpp"

#include <fmt/format.h>

namespace cgw::cli {
namespace {

using base::JsonWriter;

void integer(JsonWriter& json, std::string_view key, std::int64_t value) {
    json.key(key).integer(value);
}

void text(JsonWriter& json, std::string_view key, std::string_view value) {
    json.key(key).string(value);
}

void text_or_null(JsonWriter& json, std::string_view key, std::string_view value) {
    value.empty() ? json.key(key).null() : json.key(key).string(value);
}

template <std::size_t count>
void registers(JsonWriter& json, const std::array<std::uint8_t, count>& values) {
    json.key("registers").begin_array();
    for (const std::uint8_t value : values) {
        json.integer(value);
    }
    json.end_array();
}

void header(JsonWriter& json, const std::string& path, const image::Image& image) {
    integer(json, "format_version", 1);
    text(json, "path", path);
    json.key("format").begin_object();
    integer(json, "major", image.format_major());
    integer(json, "minor", image.format_minor());
    json.end_object();
    integer(json, "size", static_cast<std::int64_t>(image.bytes().size()));
    integer(json, "crc", image.crc());
    text(json, "configuration_id", base::short_id(image.configuration_id()));
    text(json, "configuration_sha256", base::to_hex(image.configuration_id()));
    text(json, "tool_version", tool_version_text(image));
    text(json, "title", title_of(image));
}

void identity(JsonWriter& json, const image::Identity& identity) {
    json.key("identity").begin_object();
    integer(json, "vendor", identity.vendor);
    integer(json, "product", identity.product);
    integer(json, "revision", identity.revision);
    integer(json, "serial", identity.serial);
    json.end_object();
}

void bus(JsonWriter& json, std::string_view key, const image::Bus& bus) {
    json.key(key).begin_object();
    integer(json, "node", bus.own_node);
    integer(json, "peer_node", bus.peer_node);
    json.key("manual_timing").boolean(bus.manual_timing);
    integer(json, "bit_rate_kbit", bus.bit_rate_kbit);
    registers(json, bus.registers);
    integer(json, "start_up_delay_ms", bus.start_up_delay_ms);
    json.end_object();
}

void governor(JsonWriter& json, const image::Governor& governor) {
    json.key("governor").begin_object();
    integer(json, "node", governor.own_node);
    integer(json, "gateway_node", governor.gateway_node);
    json.key("manual_timing").boolean(governor.manual_timing);
    integer(json, "bit_rate_kbit", governor.bit_rate_kbit);
    registers(json, governor.registers);
    integer(json, "start_up_delay_ms", governor.start_up_delay_ms);
    integer(json, "main_cycle_us", governor.main_cycle_us);
    json.key("send_errors").boolean(governor.send_errors);
    json.key("send_status").boolean(governor.send_status);
    json.end_object();
}

void heartbeat(JsonWriter& json, const image::Heartbeat& heartbeat) {
    json.key("heartbeat").begin_object();
    integer(json, "producer_us", heartbeat.producer_us);
    integer(json, "consumer_us", heartbeat.consumer_us);
    integer(json, "consumer_node", heartbeat.consumer_node);
    json.end_object();
}

void mapped_object(JsonWriter& json, const image::Image& image, const image::MappedObject& mapped) {
    json.begin_object();
    integer(json, "index", mapped.index);
    integer(json, "sub_index", mapped.sub_index);
    integer(json, "bits", mapped.bits);
    if (mapped.parameter == 0) {
        json.key("parameter").null();
        json.key("name").null();
    } else {
        integer(json, "parameter", mapped.parameter);
        text_or_null(json, "name", name_of(image, mapped.parameter));
    }
    json.end_object();
}

// The keys of the PDO table's JSON; active PDOs only.
void pdos(JsonWriter& json, const image::Image& image) {
    json.key("pdos").begin_array();
    for (std::size_t i = 0; i < image::pdo::count; ++i) {
        const image::Pdo pdo = image.pdo(i);
        if (!pdo.active) {
            continue;
        }
        json.begin_object();
        text(json, "name", pdo_name(pdo));
        text(json, "direction", pdo.receive ? "receive" : "transmit");
        integer(json, "number", pdo.number);
        integer(json, "cob_id", pdo.cob_id);
        text(json, "cob_id_source", pdo.cob_id_from_parameter ? "parameter" : "predefined");
        integer(json, "length", 2 * pdo.word_count);
        integer(json, "transmission_type", pdo.transmission_type);
        integer(json, "time_ms", pdo.asked_ms);
        integer(json, "effective_time_us", pdo.effective_us);
        json.key("mapping").begin_array();
        for (std::size_t word = 0; word < pdo.word_count; ++word) {
            mapped_object(json, image, pdo.mapping[word]);
        }
        json.end_array();
        json.end_object();
    }
    json.end_array();
}

void inputs(JsonWriter& json, const image::Image& image) {
    json.key("switches").begin_array();
    for (std::size_t i = 0; i < image.switch_count(); ++i) {
        const image::SwitchFunction function = image.switch_function(i);
        json.begin_object();
        integer(json, "parameter", function.number);
        text_or_null(json, "name", name_of(image, function.number));
        integer(json, "bit", function.bit);
        json.key("low_active").boolean(function.low_active);
        json.end_object();
    }
    json.end_array();
    json.key("sensors").begin_array();
    for (std::size_t i = 0; i < image.sensor_count(); ++i) {
        const image::Sensor sensor = image.sensor(i);
        json.begin_object();
        integer(json, "parameter", sensor.number);
        text_or_null(json, "name", name_of(image, sensor.number));
        integer(json, "channel", sensor.channel);
        json.end_object();
    }
    json.end_array();
}

void labels(JsonWriter& json, const image::Image& image) {
    json.key("labels").begin_array();
    for (std::size_t i = 0; i < image.label_count(); ++i) {
        const image::Label label = image.label(i);
        json.begin_object();
        integer(json, "number", label.number);
        text(json, "name", label.name);
        text(json, "unit", label.unit);
        json.key("external");
        if (label.has_scaling) {
            json.begin_array().real(label.external_minimum).real(label.external_maximum).end_array();
        } else {
            json.null();
        }
        json.end_object();
    }
    json.end_array();
}

}  // namespace

std::string image_as_json(const std::string& path, const image::Image& image) {
    JsonWriter json;
    json.begin_object();
    header(json, path, image);
    identity(json, image.identity());
    json.key("buses").begin_object();
    bus(json, "can1", image.can1());
    bus(json, "can2", image.can2());
    json.end_object();
    governor(json, image.governor());
    heartbeat(json, image.heartbeat());
    pdos(json, image);
    inputs(json, image);
    integer(json, "object_count", static_cast<std::int64_t>(image.objects().size()));
    integer(json, "value_bytes", static_cast<std::int64_t>(image.initial_values().size()));
    labels(json, image);
    json.end_object();
    return json.take();
}

}  // namespace cgw::cli
