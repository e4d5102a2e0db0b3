// The partner's half for a Jetter controller: calls of the CANopen STX API. Only what its manual prints is
// used; what it does not tell is said in the file (D78, D80).
#include <fmt/format.h>

#include <algorithm>

#include "base/canopen_text.hpp"
#include "partner/half.hpp"
#include "partner/identifiers.hpp"
#include "partner/text.hpp"
#include "signals/codec.hpp"
#include "signals/comment.hpp"
#include "signals/layout.hpp"

namespace cgw::partner {
namespace {

using fmt::arg;

constexpr unsigned word_bits = 16;
constexpr std::uint32_t ms = 1000;  // us
constexpr std::uint32_t no_time_ms = 1000;
constexpr std::uint32_t sent_per_monitoring = 4;
constexpr std::uint32_t own_heartbeat_us = 1'000'000;  // what CanOpenInit() makes the controller send

constexpr std::string_view head =
    "// What the partner of gateway node {node} on the CANopen bus reads and sends: Jetter CANopen STX API.\n"
    "// Written by cgw {version}; do not edit.\n"
    "// title:            {title}\n"
    "// configuration id: {id}\n"
    "//\n"
    "// The manual of the API (60881083) does not print, and cgw does not know:\n"
    "// - how long names may be, and which words the language keeps for itself beside those of IEC 61131-3;\n"
    "// - what EventTime means for received asynchronous PDOs. It must be above InhibitTime: the time "
    "between two\n"
    "//   frames stands there, {no_time} where they come on change;\n"
    "// - how many bytes a sent frame has. The gateway takes no RPDO that is shorter than the length beside "
    "its calls;\n"
    "// - how registers are declared: their numbers are below.\n"
    "// INTEGER16 arrives in a Word: 65536 is to be taken off a number above 32767 where that is said.\n"
    "// Physical value = raw * FACTOR + OFFSET.\n"
    "\n";

constexpr std::string_view constants =
    "#Define {macro}_CAN_NO 0\n"
    "#Define {macro}_NODE_ID {node}\n"
    "{partner}"
    "\n"
    "// Registers of CAN line 0; line x has 1000 * x more.\n"
    "#Define {macro}_REG_HEARTBEAT_CHANGED 400100\n"
    "#Define {macro}_REG_STATE {state}\n"
    "#Define {macro}_REG_TIMEOUT {timeout}\n"
    "{heartbeat}"
    "// The gateway sends no emergency messages, its errors are bits of TPDO1 and TPDO2: "
    "CanOpenAddEmergencyRx has\n"
    "// nothing to receive. The controller itself sends one, 0x8130, when the gateway's heartbeat is "
    "missed.\n"
    "\n";

// A word of a PDO: a global variable of the program.
struct StxWord {
    std::string variable;
    unsigned byte = 0;
    bool is_signed = false;
    std::vector<const signals::Signal*> signals;
};

struct StxFrame {
    const signals::Frame* frame = nullptr;
    std::string macro;  // "GW12_TPDO4"
    std::vector<StxWord> words;
    std::vector<std::string> names;  // of the frame's signals, in their order
};

StxFrame stx_frame(const Half& half, const signals::Frame& frame) {
    const std::string lower_prefix = prefix(half);
    StxFrame of{&frame, upper(lower_prefix) + "_" + frame.name, {}, {}};
    Identifiers names(structured_text_words());
    for (const signals::Signal& signal : frame.signals) {
        of.names.push_back(names.take(signal.name));
    }
    for (std::size_t i = 0; i < frame.words.size(); ++i) {
        if (frame.words[i].kind == config::WordKind::dummy) {
            continue;  // nothing to receive, and unused bytes are sent as 0
        }
        StxWord word;
        word.byte = static_cast<unsigned>(2 * i);
        for (std::size_t n = 0; n < frame.signals.size(); ++n) {
            const signals::Signal& signal = frame.signals[n];
            if (signal.first_bit / word_bits == i) {
                word.signals.push_back(&signal);
                word.is_signed = signal.is_signed;
                word.variable = signal.is_bit() ? "" : of.names[n];
            }
        }
        if (word.variable.empty()) {
            word.variable = names.take(fmt::format("Word{}", i + 1));
        }
        word.variable = fmt::format("{}_{}_RAW_{}", lower_prefix, frame.name, word.variable);
        of.words.push_back(std::move(word));
    }
    return of;
}

std::string partner_lines(const Half& half, const std::string& macro) {
    if (half.partner_node_id == 0) {
        return "// The gateway knows no partner (428 = 0): the controller's node-ID is to be chosen.\n";
    }
    std::string text = fmt::format("#Define {}_PARTNER_NODE_ID {}\n", macro, half.partner_node_id);
    if (half.partner_heartbeat_us != 0) {
        text += fmt::format("// The gateway wants the controller's heartbeat at least every {}.\n",
                            base::milliseconds_text(half.partner_heartbeat_us));
    }
    if (half.partner_heartbeat_us != 0 && half.partner_heartbeat_us <= own_heartbeat_us) {
        text +=
            "// That is not more than the second in which CanOpenInit() sends it: object 1017h of the "
            "controller\n"
            "// must be set to less.\n";
    }
    return text;
}

std::string heartbeat_lines(const Half& half, const std::string& macro) {
    if (half.heartbeat_us == 0) {
        return "// The gateway sends no heartbeat: leave the timeout at 0.\n";
    }
    constexpr std::uint32_t longest_ms = 65535;
    const std::uint32_t wanted = std::min(longest_ms, 2 * ((half.heartbeat_us + ms - 1) / ms));
    return fmt::format(
        "// The gateway's heartbeat comes every {}; twice that, to be written into the timeout register:\n"
        "#Define {}_TIMEOUT_MS {}\n",
        base::milliseconds_text(half.heartbeat_us), macro, wanted);
}

std::string signal_lines(const StxFrame& of, std::size_t number) {
    const signals::Signal& signal = of.frame->signals[number];
    const std::string& name = of.names[number];
    const std::string what = comment(signals::comment_of(signal));
    if (signal.is_bit()) {
        return fmt::format("// word {}; {}\n#Define {}_BIT_{} {}\n", signal.first_bit / word_bits + 1, what,
                           of.macro, name, signal.first_bit % word_bits);
    }
    if (!signal.scaled) {
        return fmt::format("// {}: {}; scaling not known\n", name, what);
    }
    return fmt::format(
        "// {3}; {4}\n"
        "#Define {0}_FACTOR_{1} {2}\n"
        "#Define {0}_OFFSET_{1} {5}\n",
        of.macro, name, real(signal.factor), what, comment(signals::scaling_text(signal)),
        real(signal.offset));
}

std::string frame_lines(const StxFrame& of) {
    const signals::Frame& frame = *of.frame;
    std::string text =
        fmt::format("// {} ({}, {}), {}: {} bytes, {}\n#Define {}_COB_ID 0x{:03X}\n", frame.name,
                    base::object_text(frame.communication), base::object_text(frame.mapping),
                    frame.transmit() ? "from the gateway" : "to the gateway", frame.length,
                    signals::time_text(frame), of.macro, frame.identifier);
    for (std::size_t i = 0; i < frame.signals.size(); ++i) {
        text += signal_lines(of, i);
    }
    return text + "\n";
}

std::string variables(const StxFrame& of) {
    std::string text;
    for (const StxWord& word : of.words) {
        text += fmt::format("    {} : Word;{}\n", word.variable, word.is_signed ? " // signed" : "");
    }
    return text;
}

std::uint32_t event_time_ms(const signals::Frame& frame) {
    const std::uint32_t time =
        frame.transmit() ? frame.period_us / ms : frame.monitoring_us / ms / sent_per_monitoring;
    const bool none = frame.transmit() ? frame.period_us == 0 : frame.monitoring_us == 0;
    return none ? no_time_ms : std::max<std::uint32_t>(time, 1);
}

// What is sent until the program sets it.
std::string rest_lines(const StxFrame& of) {
    const signals::Data rest = signals::rest_data(*of.frame);
    std::string text = "// Until the program sets them: every switch function off, all else 0\n";
    for (const StxWord& word : of.words) {
        text += fmt::format("{} := {};\n", word.variable, rest[word.byte] | rest[word.byte + 1U] << 8U);
    }
    return text;
}

std::string calls(const StxFrame& of, const std::string& result) {
    std::string text = fmt::format("// {}, {} bytes\n", of.frame->name, of.frame->length);
    text += of.frame->transmit() ? "" : rest_lines(of);
    for (const StxWord& word : of.words) {
        text += fmt::format(
            "{result} := {result} + CanOpenAddPDO{way}({prefix}_CAN_NO, {macro}_COB_ID, {byte}, "
            "CANOPEN_{type}16,\n"
            "    sizeof({variable}), {variable}, {time}, 0, CANOPEN_ASYNCPDO);\n",
            arg("result", result), arg("way", of.frame->transmit() ? "Rx" : "Tx"),
            arg("prefix", of.macro.substr(0, of.macro.find('_'))), arg("macro", of.macro),
            arg("byte", word.byte), arg("type", word.is_signed ? "INTEGER" : "UNSIGNED"),
            arg("variable", word.variable), arg("time", event_time_ms(*of.frame)));
    }
    return text;
}

std::string start_lines(const Half& half, const std::string& macro, const std::string& result) {
    std::string text =
        fmt::format("// Once, in a task of the program. {} stays 0 when every call was right.\n{} := 0;\n",
                    result, result);
    if (half.partner_node_id != 0) {
        text +=
            fmt::format("{0} := {0} + CanOpenInit({1}_CAN_NO, {1}_PARTNER_NODE_ID, 'configuration {2}');\n",
                        result, macro, half.configuration_id);
    }
    return text;
}

std::string operational_lines(const std::string& macro, const std::string& result) {
    return fmt::format(
        "// The controller, and then the gateway, become Operational. The gateway must have booted: it "
        "forgets this\n"
        "// with every reset, and must be started again.\n"
        "{0} := {0} + CanOpenSetCommand({1}_CAN_NO, CAN_CMD_HEARTBEAT, CAN_HEARTBEAT_OPERATIONAL);\n"
        "{0} := {0} + CanOpenSetCommand({1}_CAN_NO, CAN_CMD_NMT,\n"
        "    CAN_CMD_NMT_Value({1}_NODE_ID, CAN_NMT_OPERATIONAL));\n",
        result, macro);
}

}  // namespace

std::string stx(const Half& half) {
    constexpr unsigned state_of_node_0 = 400100;
    constexpr unsigned timeout_of_node_0 = 400228;
    const std::string macro = upper(prefix(half));
    const std::string result = prefix(half) + "_Result";
    std::string defines;
    std::string variable_lines = fmt::format("    {} : Int;\n", result);
    std::string call_lines = start_lines(half, macro, result);
    for (const signals::Frame& frame : half.frames) {
        const StxFrame of = stx_frame(half, frame);
        defines += frame_lines(of);
        variable_lines += variables(of);
        call_lines += calls(of, result);
    }
    return fmt::format(head, arg("node", half.node_id), arg("version", half.tool_version),
                       arg("title", half.title.empty() ? "none" : comment(half.title)),
                       arg("id", half.configuration_id), arg("no_time", no_time_ms)) +
           fmt::format(constants, arg("macro", macro), arg("node", half.node_id),
                       arg("partner", partner_lines(half, macro)),
                       arg("state", state_of_node_0 + half.node_id),
                       arg("timeout", timeout_of_node_0 + half.node_id),
                       arg("heartbeat", heartbeat_lines(half, macro))) +
           defines + "Var\n" + variable_lines + "End_Var;\n\n" + call_lines +
           operational_lines(macro, result);
}

}  // namespace cgw::partner
