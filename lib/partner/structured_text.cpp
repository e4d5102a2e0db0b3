// The partner's half in Structured Text (IEC 61131-3): types, names of bits, functions between bytes and
// values.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "base/canopen_text.hpp"
#include "partner/identifiers.hpp"
#include "partner/structured_parts.hpp"
#include "partner/text.hpp"
#include "signals/codec.hpp"
#include "signals/comment.hpp"
#include "signals/layout.hpp"

namespace cgw::partner {
namespace {

using fmt::arg;

constexpr std::string_view head =
    "(* What the partner of gateway node {node} on the CANopen bus reads and sends. IEC 61131-3 Structured "
    "Text.\n"
    "   Written by cgw {version}; do not edit.\n"
    "   title:            {title}\n"
    "   configuration id: {id}\n"
    "\n"
    "   {prefix}_TPDO4_DECODE makes a structure of the bytes of a frame, {prefix}_RPDO2_ENCODE bytes of a "
    "structure.\n"
    "   Members are physical values in REAL (32 bits): within 4 parts in 16777216 of the sum of raw * factor "
    "and offset,\n"
    "   both taken without their signs. Where no scaling is known they are the raw number in DINT. A switch "
    "function is\n"
    "   TRUE when it is on, low-active ones as well; any other bit when it is 1. *)\n"
    "\n"
    "VAR_GLOBAL CONSTANT\n"
    "    {prefix}_NODE_ID : UINT := {node};\n"
    "    {prefix}_PARTNER_NODE_ID : UINT := {partner}; (* 0: none *)\n"
    "    {prefix}_BIT_RATE : UDINT := {bit_rate}; (* bit/s; 0: set by hand and not known here *)\n"
    "    {prefix}_HEARTBEAT_US : UDINT := {heartbeat}; (* time between two of the gateway; 0: it sends none "
    "*)\n"
    "    {prefix}_PARTNER_HEARTBEAT_US : UDINT := {partner_heartbeat}; (* longest time between two of the "
    "partner's;"
    " 0: any *)\n"
    "{frames}"
    "END_VAR\n"
    "\n"
    "TYPE\n"
    "    {prefix}_DATA : ARRAY [0..7] OF BYTE;\n"
    "END_TYPE\n"
    "\n";

// Nothing here depends on how a compiler rounds or converts what does not fit.
constexpr std::string_view helpers =
    "(* Two bytes as they stand on the bus, low byte first. *)\n"
    "FUNCTION {prefix}_WORD : DINT\n"
    "VAR_INPUT\n"
    "    low : BYTE;\n"
    "    high : BYTE;\n"
    "    is_signed : BOOL;\n"
    "END_VAR\n"
    "VAR\n"
    "    number : DINT;\n"
    "END_VAR\n"
    "number := BYTE_TO_DINT(low) + BYTE_TO_DINT(high) * DINT#256;\n"
    "IF is_signed AND (number > DINT#32767) THEN\n"
    "    number := number - DINT#65536;\n"
    "END_IF;\n"
    "{prefix}_WORD := number;\n"
    "END_FUNCTION\n"
    "\n"
    "FUNCTION {prefix}_LOW : BYTE\n"
    "VAR_INPUT\n"
    "    raw : DINT;\n"
    "END_VAR\n"
    "VAR\n"
    "    number : DINT;\n"
    "END_VAR\n"
    "number := raw;\n"
    "IF number < DINT#0 THEN\n"
    "    number := number + DINT#65536;\n"
    "END_IF;\n"
    "{prefix}_LOW := DINT_TO_BYTE(number MOD DINT#256);\n"
    "END_FUNCTION\n"
    "\n"
    "FUNCTION {prefix}_HIGH : BYTE\n"
    "VAR_INPUT\n"
    "    raw : DINT;\n"
    "END_VAR\n"
    "VAR\n"
    "    number : DINT;\n"
    "END_VAR\n"
    "number := raw;\n"
    "IF number < DINT#0 THEN\n"
    "    number := number + DINT#65536;\n"
    "END_IF;\n"
    "{prefix}_HIGH := DINT_TO_BYTE(number / DINT#256);\n"
    "END_FUNCTION\n"
    "\n"
    "(* The nearest number for a physical value; FALSE beyond its range. *)\n"
    "FUNCTION {prefix}_RAW : BOOL\n"
    "VAR_INPUT\n"
    "    value : REAL;\n"
    "    factor : REAL;\n"
    "    offset : REAL;\n"
    "    lowest : REAL;\n"
    "    highest : REAL;\n"
    "    is_signed : BOOL;\n"
    "END_VAR\n"
    "VAR_IN_OUT\n"
    "    raw : DINT;\n"
    "END_VAR\n"
    "VAR\n"
    "    slack : REAL;\n"
    "    steps : REAL;\n"
    "    number : DINT;\n"
    "END_VAR\n"
    "{prefix}_RAW := FALSE;\n"
    "slack := ABS(factor) / 2.0;\n"
    "IF NOT ((value >= lowest - slack) AND (value <= highest + slack)) THEN\n"
    "    RETURN;\n"
    "END_IF;\n"
    "steps := (LIMIT(lowest, value, highest) - offset) / factor;\n"
    "IF NOT (ABS(steps) < 65536.0) THEN\n"
    "    RETURN;\n"
    "END_IF;\n"
    "IF steps < 0.0 THEN\n"
    "    number := TRUNC(steps - 0.5);\n"
    "ELSE\n"
    "    number := TRUNC(steps + 0.5);\n"
    "END_IF;\n"
    "IF is_signed THEN\n"
    "    IF (number < DINT#-32768) OR (number > DINT#32767) THEN\n"
    "        RETURN;\n"
    "    END_IF;\n"
    "ELSIF (number < DINT#0) OR (number > DINT#65535) THEN\n"
    "    RETURN;\n"
    "END_IF;\n"
    "raw := number;\n"
    "{prefix}_RAW := TRUE;\n"
    "END_FUNCTION\n"
    "\n";

std::string constants(const StFrame& of) {
    const signals::Frame& frame = *of.frame;
    return fmt::format(
        "    {0}_COB_ID : UINT := 16#{1:03X};\n    {0}_LENGTH : UINT := {2};\n    {0}_{3} : UDINT := {4};\n",
        of.type, frame.identifier, frame.length, frame.transmit() ? "CYCLE_US" : "MONITORING_US",
        frame.transmit() ? frame.period_us : frame.monitoring_us);
}

std::string member_comment(const StMember& member) {
    const signals::Signal& signal = *member.signal;
    std::string text = comment(signals::comment_of(signal));
    if (member.real) {
        text += "; " + comment(signals::range_text(signal));
    } else if (!signal.is_bit()) {
        text += signal.scaled ? "; raw, REAL does not hold its scaling" : "; raw, scaling not known";
    }
    return text;
}

std::string type_of(const StMember& member) {
    return member.signal->is_bit() ? "BOOL" : member.real ? "REAL" : "DINT";
}

}  // namespace

std::string st_real(double value) {
    std::string text = fmt::format("{}", static_cast<float>(value));
    const std::size_t exponent = text.find('e');
    if (text.find('.') == std::string::npos) {
        text.insert(exponent == std::string::npos ? text.size() : exponent, ".0");
    }
    return upper(text);
}

bool fits_real(const signals::Signal& signal) {
    constexpr double highest = std::numeric_limits<float>::max() / 2;
    constexpr double lowest = 1e-30;  // far above the denormal numbers: quotients are not tiny either
    for (const double value : {signal.factor, signal.offset, signal.minimum, signal.maximum}) {
        if (!(std::abs(value) < highest)) {
            return false;
        }
    }
    return std::abs(signal.factor) > lowest;
}

StFrame st_frame(const Half& half, const signals::Frame& frame) {
    const std::string prefix_text = upper(prefix(half));
    StFrame of{&frame, prefix_text, prefix_text + "_" + frame.name, {}};
    Identifiers names(structured_text_words());
    for (const signals::Signal& signal : frame.signals) {
        of.members.push_back({&signal, names.take(signal.name), signal.scaled && fits_real(signal)});
    }
    return of;
}

std::string st_type(const StFrame& of) {
    const signals::Frame& frame = *of.frame;
    std::string text = fmt::format(
        "(* {} ({}, {}), {}: COB-ID {}, {} bytes, {} *)\nTYPE\n{} : STRUCT\n", frame.name,
        base::object_text(frame.communication), base::object_text(frame.mapping),
        frame.transmit() ? "from the gateway" : "to the gateway", base::identifier_text(frame.identifier),
        frame.length, signals::time_text(frame), of.type);
    for (const StMember& member : of.members) {
        text += fmt::format("    {} : {}; (* {} *)\n", member.name, type_of(member), member_comment(member));
    }
    // A structure has members: a PDO of dummies alone too.
    text += of.members.empty() ? "    Nothing : BOOL; (* the PDO carries dummies alone *)\n" : "";
    return text + "END_STRUCT;\nEND_TYPE\n\n";
}

std::string st_helpers(const std::string& prefix_text) {
    return fmt::format(helpers, arg("prefix", prefix_text));
}

std::string structured_text(const Half& half) {
    const std::string prefix_text = upper(prefix(half));
    std::string frame_constants;
    std::string body = st_helpers(prefix_text);
    for (const signals::Frame& frame : half.frames) {
        const StFrame of = st_frame(half, frame);
        frame_constants += constants(of);
        body += st_type(of) + st_functions(of);
    }
    return fmt::format(head, arg("node", half.node_id), arg("version", half.tool_version),
                       arg("title", half.title.empty() ? "none" : comment(half.title)),
                       arg("id", half.configuration_id), arg("prefix", prefix_text),
                       arg("partner", half.partner_node_id), arg("bit_rate", half.bit_rate.value_or(0)),
                       arg("heartbeat", half.heartbeat_us),
                       arg("partner_heartbeat", half.partner_heartbeat_us), arg("frames", frame_constants)) +
           body;
}

}  // namespace cgw::partner
