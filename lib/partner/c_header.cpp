// The partner's half for C99 and C++: one header that needs no library and depends on no byte order or
// packing.
#include <fmt/format.h>

#include <span>

#include "base/canopen_text.hpp"
#include "facts/identifiers.hpp"
#include "partner/c_parts.hpp"
#include "partner/text.hpp"
#include "signals/codec.hpp"
#include "signals/layout.hpp"

namespace cgw::partner {
namespace {

using fmt::arg;

constexpr std::string_view head =
    "/* What the partner of gateway node {node} on the CANopen bus reads and sends. For C99 and C++.\n"
    "   Written by cgw {version}; do not edit.\n"
    "   title:            {title}\n"
    "   configuration id: {id}\n"
    "\n"
    "   A PDO is a struct of its bytes as they stand on the bus, low byte first: the same on every "
    "processor.\n"
    "   Of a signal X of TPDO4 there are:\n"
    "     {prefix}_tpdo4_raw_X      the number on the bus\n"
    "     {prefix}_tpdo4_value_X    the physical value, raw * FACTOR + OFFSET, in double\n"
    "     {macro}_TPDO4_BIT_X   the place of a single bit, for {prefix}_tpdo4_bit\n"
    "   and of a signal of RPDO2 also:\n"
    "     {prefix}_rpdo2_setraw_X   the number\n"
    "     {prefix}_rpdo2_set_X      the physical value; 0, and nothing is written, beyond MIN and MAX\n"
    "     {prefix}_rpdo1_turn_X     a switch function on or off, low-active ones as well\n"
    "   Begin with {prefix}_rpdo1 x = {macro}_RPDO1_REST: a struct of zeros turns low-active functions on.\n"
    "   A raw value beyond RAWMIN and RAWMAX has no meaning. The compiler must not fuse multiplication and\n"
    "   addition (ISO modes do not) where the last bit of a value matters. */\n";

constexpr std::string_view opening =
    "#ifndef CGW_{macro}_PARTNER_H\n"
    "#define CGW_{macro}_PARTNER_H\n"
    "\n"
    "#include <stdint.h>\n"
    "\n"
    "#define {macro}_CONFIGURATION_ID \"{id}\"\n"
    "#define {macro}_NODE_ID {node}u\n"
    "#define {macro}_PARTNER_NODE_ID {partner}u    /* 0: none */\n"
    "{bit_rate}"
    "#define {macro}_HEARTBEAT_COB_ID 0x{heartbeat:03X}u\n"
    "#define {macro}_HEARTBEAT_US {heartbeat_us}u            /* time between two; 0: the gateway sends none "
    "*/\n"
    "#define {macro}_PARTNER_HEARTBEAT_US {partner_us}u    /* longest time between two of the partner's; 0: "
    "any */\n"
    "#define {macro}_SDO_REQUEST_COB_ID 0x{request:03X}u\n"
    "#define {macro}_SDO_ANSWER_COB_ID 0x{answer:03X}u\n";

// raw: the nearest number, halves away from 0, as everywhere in cgw.
constexpr std::string_view helpers =
    "\n"
    "static inline int32_t {prefix}_word(const uint8_t *at)\n"
    "{{\n"
    "    return (int32_t)at[0] + (int32_t)at[1] * 256;\n"
    "}}\n"
    "static inline int32_t {prefix}_word_signed(const uint8_t *at)\n"
    "{{\n"
    "    int32_t word = {prefix}_word(at);\n"
    "    return word < 32768 ? word : word - 65536;\n"
    "}}\n"
    "static inline void {prefix}_putword(uint8_t *at, int32_t raw)\n"
    "{{\n"
    "    at[0] = (uint8_t)((uint32_t)raw & 255u);\n"
    "    at[1] = (uint8_t)((uint32_t)raw >> 8 & 255u);\n"
    "}}\n"
    "static inline int {prefix}_putvalue(uint8_t *at, double value, double factor, double offset, double "
    "lowest,\n"
    "                               double highest, int is_signed)\n"
    "{{\n"
    "    double slack = factor < 0 ? factor / -2 : factor / 2;\n"
    "    double steps;\n"
    "    int32_t raw;\n"
    "    if (!(value >= lowest - slack && value <= highest + slack)) {{\n"
    "        return 0;\n"
    "    }}\n"
    "    value = value < lowest ? lowest : value > highest ? highest : value;\n"
    "    steps = (value - offset) / factor;\n"
    "    if (!(steps > -65536.0 && steps < 65536.0)) {{\n"
    "        return 0;\n"
    "    }}\n"
    "    raw = (int32_t)steps;\n"
    "    raw += steps - raw >= 0.5 ? 1 : steps - raw <= -0.5 ? -1 : 0;\n"
    "    if (raw < (is_signed ? -32768 : 0) || raw > (is_signed ? 32767 : 65535)) {{\n"
    "        return 0;\n"
    "    }}\n"
    "    {prefix}_putword(at, raw);\n"
    "    return 1;\n"
    "}}\n";

constexpr std::string_view frame_head =
    "\n"
    "/* {name} ({communication}, {mapping}), {way}: {length} bytes, {time} */\n"
    "#define {macro}_COB_ID 0x{identifier:03X}u\n"
    "#define {macro}_LENGTH {length}u\n"
    "#define {macro}_{period} {period_us}u\n"
    "\n"
    "typedef struct {{ uint8_t bytes[{length}]; }} {type};\n"
    "typedef char {type}_is_packed[sizeof({type}) == {length}u ? 1 : -1];\n";

constexpr std::string_view rest_line =
    "/* Every switch function off, all else 0. */\n"
    "#define {}_REST {{ {{ {:#04x} }} }}\n";

// What a frame of the bus brings: shorter ones are none of the gateway's.
constexpr std::string_view taking =
    "static inline int {type}_take({type} *pdo, uint32_t cob_id, const uint8_t *data, unsigned length)\n"
    "{{\n"
    "    unsigned i;\n"
    "    if (cob_id != {macro}_COB_ID || length < {macro}_LENGTH) {{\n"
    "        return 0;\n"
    "    }}\n"
    "    for (i = 0; i < {macro}_LENGTH; ++i) {{\n"
    "        pdo->bytes[i] = data[i];\n"
    "    }}\n"
    "    return 1;\n"
    "}}\n";

std::string bit_rate(const Half& half, const std::string& macro) {
    return half.bit_rate ? fmt::format("#define {}_BIT_RATE {}u\n", macro, *half.bit_rate)
                         : "/* The bit rate is set by hand and not known here. */\n";
}

std::string frame_text(const CFrame& of) {
    const signals::Frame& frame = of.frame;
    const bool transmit = frame.transmit();
    const signals::Data rest = signals::rest_data(frame);
    std::string text =
        fmt::format(frame_head, arg("name", frame.name), arg("macro", of.macro), arg("type", of.type),
                    arg("communication", base::object_text(frame.communication)),
                    arg("mapping", base::object_text(frame.mapping)),
                    arg("way", transmit ? "from the gateway" : "to the gateway"), arg("length", frame.length),
                    arg("time", signals::time_text(frame)), arg("identifier", frame.identifier),
                    arg("period", transmit ? "CYCLE_US" : "MONITORING_US"),
                    arg("period_us", transmit ? frame.period_us : frame.monitoring_us)) +
        (transmit ? ""
                  : fmt::format(rest_line, of.macro, fmt::join(std::span(rest).first(frame.length), ", "))) +
        fmt::format(taking, arg("type", of.type), arg("macro", of.macro)) + c_bits(of);
    for (const signals::Signal& signal : frame.signals) {
        text += signal.is_bit() ? "" : c_word(of, signal);
    }
    return text;
}

}  // namespace

CFrame c_frame(const Half& half, const signals::Frame& frame) {
    const std::string type = prefix(half) + "_" + lower(frame.name);
    return {frame, prefix(half), type, upper(type)};
}

std::string c_header(const Half& half) {
    namespace cob = facts::cob;
    const std::string lower_case = prefix(half);
    const std::string macro = upper(lower_case);
    std::string text =
        fmt::format(head, arg("node", half.node_id), arg("version", half.tool_version),
                    arg("title", half.title.empty() ? "none" : comment(half.title)),
                    arg("id", half.configuration_id), arg("prefix", lower_case), arg("macro", macro));
    text += fmt::format(
        opening, arg("macro", macro), arg("id", half.configuration_id), arg("node", half.node_id),
        arg("partner", half.partner_node_id), arg("bit_rate", bit_rate(half, macro)),
        arg("heartbeat", cob::heartbeat + half.node_id), arg("heartbeat_us", half.heartbeat_us),
        arg("partner_us", half.partner_heartbeat_us), arg("request", cob::sdo_request + half.node_id),
        arg("answer", cob::sdo_answer + half.node_id));
    text += fmt::format(helpers, arg("prefix", lower_case));
    for (const signals::Frame& frame : half.frames) {
        text += frame_text(c_frame(half, frame));
    }
    return text + "\n#endif\n";
}

}  // namespace cgw::partner
