// The partner's half for Python 3: tables, functions that need no library, and glue for the library canopen.
#include <fmt/format.h>

#include <span>

#include "partner/half.hpp"
#include "partner/python_code.hpp"
#include "partner/text.hpp"
#include "signals/codec.hpp"
#include "signals/comment.hpp"

namespace cgw::partner {
namespace {

using fmt::arg;

constexpr std::string_view head =
    "#!/usr/bin/env python3\n"
    "\"\"\"What the partner of gateway node {node} on the CANopen bus reads and sends.\n"
    "\n"
    "Written by cgw {version}; do not edit.\n"
    "title:            {title}\n"
    "configuration id: {id}\n"
    "\n"
    "decode() and encode() need no library. With the library canopen (and python-can) there are "
    "subscribe(),\n"
    "send_periodic(), send_heartbeat() and start(). On its own the file decodes frames and listens to a "
    "bus:\n"
    "    python3 FILE decode 181#0000000000000000\n"
    "    python3 FILE listen can0 socketcan\n"
    "\"\"\"\n"
    "import collections\n"
    "import sys\n"
    "\n"
    "CONFIGURATION_ID = \"{id}\"\n"
    "NODE_ID = {node}\n"
    "PARTNER_NODE_ID = {partner}  # 0: none\n"
    "BIT_RATE = {bit_rate}  # bit/s; None: set by hand and not known here\n"
    "HEARTBEAT_US = {heartbeat}  # time between two of the gateway; 0: it sends none\n"
    "PARTNER_HEARTBEAT_US = {partner_heartbeat}  # longest time between two of the partner's; 0: any\n"
    "\n"
    "# `read`: the gateway sends it. `time_us`: then the time between two frames, 0 on change; else the "
    "longest time\n"
    "# between two of the partner's, 0 any. `rest`: every switch function off, all else 0.\n"
    "Pdo = collections.namedtuple(\"Pdo\", \"name cob_id length read time_us rest signals\")\n"
    "# Physical value = raw * factor + offset, None where the scaling is not known. `on`: what a bit is when "
    "the switch\n"
    "# is on. Bit 0 is the lowest of byte 0; numbers stand low byte first.\n"
    "Signal = collections.namedtuple(\n"
    "    \"Signal\", \"name first_bit bits signed factor offset minimum maximum unit on scaled meaning\")\n"
    "\n"
    "PDOS = (\n";

std::string python_bool(bool value) {
    return value ? "True" : "False";
}

std::string scaling(const signals::Signal& signal) {
    return signal.scaled ? fmt::format("{}, {}, {}, {}", real(signal.factor), real(signal.offset),
                                       real(signal.minimum), real(signal.maximum))
                         : "None, None, None, None";
}

std::string signal_line(const signals::Signal& signal) {
    const std::optional<int> on = raw_of_on(signal);
    return fmt::format("        Signal({}, {}, {}, {}, {}, {}, {}, {},\n               {}),\n",
                       python_string(signal.name), signal.first_bit, signal.width,
                       python_bool(signal.is_signed), scaling(signal),
                       python_string(cut(signal.unit, longest_unit)), on ? fmt::format("{}", *on) : "None",
                       python_bool(signal.scaled), python_string(comment(signals::comment_of(signal))));
}

std::string pdo_lines(const signals::Frame& frame) {
    const signals::Data rest = signals::rest_data(frame);
    std::string text =
        fmt::format("    Pdo({}, 0x{:03X}, {}, {}, {}, bytes.fromhex(\"{:02X}\"), (\n",
                    python_string(frame.name), frame.identifier, frame.length, python_bool(frame.transmit()),
                    frame.transmit() ? frame.period_us : frame.monitoring_us,
                    fmt::join(std::span(rest).first(frame.length), ""));
    for (const signals::Signal& signal : frame.signals) {
        text += signal_line(signal);
    }
    return text + "    )),\n";
}

}  // namespace

std::string python_canopen(const Half& half) {
    std::string text =
        fmt::format(head, arg("node", half.node_id), arg("version", half.tool_version),
                    arg("title", half.title.empty() ? "none" : comment(half.title)),
                    arg("id", half.configuration_id), arg("partner", half.partner_node_id),
                    arg("bit_rate", half.bit_rate ? fmt::format("{}", *half.bit_rate) : "None"),
                    arg("heartbeat", half.heartbeat_us), arg("partner_heartbeat", half.partner_heartbeat_us));
    for (const signals::Frame& frame : half.frames) {
        text += pdo_lines(frame);
    }
    return text + ")\n" + std::string(python_code);
}

}  // namespace cgw::partner
