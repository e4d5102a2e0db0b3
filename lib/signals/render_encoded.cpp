#include <fmt/format.h>

#include <algorithm>

#include "base/canopen_text.hpp"
#include "base/json.hpp"
#include "base/text_cells.hpp"
#include "base/wrap.hpp"
#include "signals/encode.hpp"
#include "signals/layout.hpp"

namespace cgw::signals {
namespace {

constexpr int format_version = 1;
constexpr std::size_t columns = 80;
constexpr unsigned byte_bits = 8;

const Given* find_given(const Encoded& encoded, const Signal& signal) {
    const auto found = std::find_if(encoded.given.begin(), encoded.given.end(),
                                    [&](const Given& given) { return given.signal == &signal; });
    return found == encoded.given.end() ? nullptr : &*found;
}

std::string place_of(const Signal& signal) {
    const unsigned byte = signal.first_bit / byte_bits;
    return signal.is_bit() ? fmt::format("{}.{}", byte, signal.first_bit % byte_bits)
                           : fmt::format("{}..{}", byte, byte + 1);
}

std::string bytes_of(const Encoded& encoded, const Signal& signal) {
    const std::size_t byte = signal.first_bit / byte_bits;
    return fmt::format("{:02X} {:02X}", encoded.data[byte], encoded.data[byte + 1]);
}

std::string explanation(const Encoded& encoded, const Signal& signal) {
    const Given* const given = find_given(encoded, signal);
    const std::int32_t raw = raw_value(signal, encoded.data);  // a switch that is off may be a 1
    const std::string shown = value_text(signal, raw);
    std::string text = meaning_of(signal) + ": ";
    if (signal.is_bit()) {
        text += shown == fmt::format("{}", raw) ? shown : fmt::format("{} -> {}", shown, raw);
    } else {
        text += given != nullptr && given->asked != shown ? given->asked + " -> " : "";
        text += fmt::format("{} -> {} -> {}", raw, bytes_of(encoded, signal), shown);
    }
    text += given == nullptr ? ", not given" : "";
    return text + (in_range(signal, raw) ? "" : ", beyond " + range_text(signal));
}

// Errors that are not given are too many to be told.
bool is_told(const Encoded& encoded, const Signal& signal) {
    return signal.kind != Kind::error || find_given(encoded, signal) != nullptr;
}

}  // namespace

std::string render_encoded_text(const Encoded& encoded) {
    const Frame& frame = *encoded.frame;
    std::string text =
        fmt::format("{}\n\n{}  {}  {} bytes  {}\n", cansend_text(frame, encoded.data), frame.name,
                    base::identifier_text(frame.identifier), frame.length, time_text(frame));
    for (const Signal& signal : frame.signals) {
        if (!is_told(encoded, signal)) {
            continue;
        }
        std::string head = fmt::format("{:<6} ", place_of(signal));
        for (const std::string& line :
             base::wrap(base::one_line(explanation(encoded, signal)), columns - head.size())) {
            text += head + line + '\n';
            head.assign(head.size(), ' ');
        }
    }
    return text;
}

std::string render_encoded_json(const Encoded& encoded) {
    const Frame& frame = *encoded.frame;
    base::JsonWriter json;
    json.begin_object();
    json.key("format_version").integer(format_version);
    json.key("frame").string(frame.name);
    json.key("cob_id").integer(frame.identifier);
    json.key("length").integer(frame.length);
    json.key("cansend").string(cansend_text(frame, encoded.data));
    json.key("data").begin_array();
    for (unsigned byte = 0; byte < frame.length; ++byte) {
        json.integer(encoded.data[byte]);
    }
    json.end_array().key("signals").begin_array();
    for (const Signal& signal : frame.signals) {
        const Given* const given = find_given(encoded, signal);
        const std::int32_t raw = raw_value(signal, encoded.data);
        json.begin_object();
        json.key("name").string(signal.name);
        json.key("given").boolean(given != nullptr);
        json.key("raw").integer(raw);
        json.key("physical").real(physical_value(signal, raw));
        json.key("unit").string(signal.unit);
        json.key("text").string(value_text(signal, raw));
        json.end_object();
    }
    json.end_array().end_object();
    return json.take();
}

}  // namespace cgw::signals
