// The list of points for a SCADA system or a logger: a line for each signal.
#include <fmt/format.h>

#include "base/canopen_text.hpp"
#include "base/columns.hpp"
#include "base/numbers.hpp"
#include "base/utf8.hpp"
#include "partner/half.hpp"
#include "partner/text.hpp"
#include "signals/comment.hpp"

namespace cgw::partner {
namespace {

constexpr unsigned byte_bits = 8;

struct Point {
    const Half& half;
    const signals::Frame& frame;
    const signals::Signal& signal;

    bool scaled() const { return signal.scaled; }
};

std::string decimal(std::int64_t value) {
    return fmt::format("{}", value);
}

std::string type_of(const Point& point) {
    return point.signal.is_bit() ? "BOOL" : point.signal.is_signed ? "INT16" : "UINT16";
}

std::string where_scaled(const Point& point, double value) {
    return point.scaled() ? base::to_text(value) : std::string();
}

std::string time_of(const Point& point) {
    const signals::Frame& frame = point.frame;
    return base::milliseconds(frame.transmit() ? frame.period_us : frame.monitoring_us);
}

std::string values_of(const Point& point) {
    std::string text;
    for (const signals::NamedValue& value : point.signal.values) {
        text += fmt::format("{}{}={}", text.empty() ? "" : "; ", value.raw, value.text);
    }
    return text;
}

constexpr base::Column<Point> columns[] = {
    {"tag",
     [](const Point& point) {
         return fmt::format("{}.{}.{}", upper(prefix(point.half)), point.frame.name, point.signal.name);
     }},
    {"direction", [](const Point& point) { return std::string(point.frame.transmit() ? "read" : "write"); }},
    {"pdo", [](const Point& point) { return point.frame.name; }},
    {"cob_id", [](const Point& point) { return fmt::format("0x{:03X}", point.frame.identifier); }},
    {"length", [](const Point& point) { return decimal(point.frame.length); }},
    {"byte", [](const Point& point) { return decimal(point.signal.first_bit / byte_bits); }},
    {"bit", [](const Point& point) { return decimal(point.signal.first_bit % byte_bits); }},
    {"bits", [](const Point& point) { return decimal(point.signal.width); }},
    {"type", type_of},
    {"factor", [](const Point& point) { return where_scaled(point, point.signal.factor); }},
    {"offset", [](const Point& point) { return where_scaled(point, point.signal.offset); }},
    {"unit", [](const Point& point) { return base::printable(point.signal.unit); }},
    {"minimum", [](const Point& point) { return where_scaled(point, point.signal.minimum); }},
    {"maximum", [](const Point& point) { return where_scaled(point, point.signal.maximum); }},
    {"raw_minimum", [](const Point& point) { return decimal(point.signal.raw_minimum); }},
    {"raw_maximum", [](const Point& point) { return decimal(point.signal.raw_maximum); }},
    {"cycle_ms", [](const Point& point) { return time_of(point); }},
    {"kind", [](const Point& point) { return std::string(signals::to_text(point.signal.kind)); }},
    {"object",
     [](const Point& point) { return base::object_text(point.signal.index, point.signal.sub_index); }},
    {"values", [](const Point& point) { return values_of(point); }},
    {"meaning", [](const Point& point) { return base::printable(signals::comment_of(point.signal)); }},
    {"configuration_id", [](const Point& point) { return point.half.configuration_id; }},
};

}  // namespace

// Lines end with LF. Byte and bit count from 0, the bit within its byte; words stand low byte first.
std::string points(const Half& half) {
    constexpr std::span<const base::Column<Point>> all = columns;
    std::string text = base::csv_heading(all);
    for (const signals::Frame& frame : half.frames) {
        for (const signals::Signal& signal : frame.signals) {
            text += base::csv_line(all, {half, frame, signal});
        }
    }
    return text;
}

}  // namespace cgw::partner
