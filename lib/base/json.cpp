#include "base/json.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/numbers.hpp"
#include "base/utf8.hpp"

namespace cgw::base {
namespace {

void append_escaped(std::string& text, std::uint8_t c) {
    switch (c) {
        case '"':
            text += "\\\"";
            break;
        case '\\':
            text += "\\\\";
            break;
        case '\n':
            text += "\\n";
            break;
        case '\r':
            text += "\\r";
            break;
        case '\t':
            text += "\\t";
            break;
        default:
            text +=
                c < 0x20 || c == 0x7F ? fmt::format("\\u{:04x}", c) : std::string(1, static_cast<char>(c));
    }
}

}  // namespace

std::string json_quote(std::string_view value) {
    std::string text = "\"";
    for (std::size_t i = 0; i < value.size();) {
        const std::size_t length = utf8_sequence_length(value.substr(i));
        if (length == 0) {
            text += "\xEF\xBF\xBD";
            ++i;
        } else if (length == 1) {
            append_escaped(text, static_cast<std::uint8_t>(value[i]));
            ++i;
        } else {
            text += value.substr(i, length);
            i += length;
        }
    }
    return text + '"';
}

void JsonWriter::separate() {
    if (after_key_) {
        after_key_ = false;
        return;
    }
    if (!has_items_.empty()) {
        if (has_items_.back()) {
            text_ += ',';
        }
        has_items_.back() = true;
    }
}

JsonWriter& JsonWriter::begin_object() {
    separate();
    text_ += '{';
    has_items_.push_back(false);
    return *this;
}

JsonWriter& JsonWriter::end_object() {
    text_ += '}';
    has_items_.pop_back();
    return *this;
}

JsonWriter& JsonWriter::begin_array() {
    separate();
    text_ += '[';
    has_items_.push_back(false);
    return *this;
}

JsonWriter& JsonWriter::end_array() {
    text_ += ']';
    has_items_.pop_back();
    return *this;
}

JsonWriter& JsonWriter::key(std::string_view name) {
    separate();
    text_ += json_quote(name);
    text_ += ':';
    after_key_ = true;
    return *this;
}

JsonWriter& JsonWriter::string(std::string_view value) {
    separate();
    text_ += json_quote(value);
    return *this;
}

JsonWriter& JsonWriter::integer(std::int64_t value) {
    separate();
    text_ += fmt::format("{}", value);
    return *this;
}

JsonWriter& JsonWriter::real(double value) {
    separate();
    text_ += std::isfinite(value) ? to_text(value) : "null";
    return *this;
}

JsonWriter& JsonWriter::boolean(bool value) {
    separate();
    text_ += value ? "true" : "false";
    return *this;
}

JsonWriter& JsonWriter::null() {
    separate();
    text_ += "null";
    return *this;
}

JsonWriter& JsonWriter::json(std::string_view value) {
    separate();
    text_ += value;
    return *this;
}

std::string JsonWriter::take() {
    text_ += '\n';
    return std::move(text_);
}

}  // namespace cgw::base
