#include <fmt/format.h>

#include "base/json.hpp"
#include "base/sha256.hpp"
#include "inspect/annotation.hpp"

namespace cgw::inspect {
namespace {

using base::JsonWriter;

constexpr int format_version = 1;

void text_or_null(JsonWriter& json, std::string_view key, std::string_view text) {
    json.key(key);
    text.empty() ? json.null() : json.string(text);
}

void put_status(JsonWriter& json, std::string_view key, image::Status status) {
    json.key(key);
    if (status == image::Status::ok) {
        json.null();
        return;
    }
    json.begin_object();
    json.key("status").integer(static_cast<std::int64_t>(status));
    json.key("message").string(image::to_text(status));
    json.end_object();
}

void put_item(JsonWriter& json, const Item& item, std::span<const std::uint8_t> bytes) {
    json.begin_object();
    json.key("offset").integer(static_cast<std::int64_t>(item.offset));
    json.key("size").integer(static_cast<std::int64_t>(item.size));
    json.key("bytes").string(base::to_hex(bytes.subspan(item.offset, item.size)));
    json.key("type").string(name_of(item.type));
    json.key("name").string(item.name);
    text_or_null(json, "value", item.value);
    text_or_null(json, "meaning", item.meaning);
    text_or_null(json, "wrong", item.wrong);
    json.end_object();
}

void put_group(JsonWriter& json, const Group& group, std::span<const std::uint8_t> bytes) {
    json.begin_object();
    text_or_null(json, "section", group.section);
    json.key("record");
    group.record ? json.integer(static_cast<std::int64_t>(*group.record)) : json.null();
    json.key("title").string(group.title);
    text_or_null(json, "wrong", group.wrong);
    json.key("fields").begin_array();
    for (const Item& item : group.items) {
        put_item(json, item, bytes);
    }
    json.end_array();
    json.end_object();
}

}  // namespace

std::string annotation_json(const Annotation& annotation, std::span<const std::uint8_t> bytes,
                            const std::string& path) {
    JsonWriter json;
    json.begin_object();
    json.key("format_version").integer(format_version);
    json.key("path").string(path);
    json.key("size").integer(static_cast<std::int64_t>(bytes.size()));
    json.key("valid").boolean(annotation.status == image::Status::ok);
    put_status(json, "refusal", annotation.status);
    put_status(json, "refusal_beyond_crc", annotation.status_beyond_crc);
    json.key("records").begin_array();
    for (const Group& group : annotation.groups) {
        put_group(json, group, bytes);
    }
    json.end_array();
    json.end_object();
    return json.take();
}

}  // namespace cgw::inspect
