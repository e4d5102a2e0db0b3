// Why a verification could not be finished, and what to look at: for whoever stands before a silent bus.
#include <fmt/format.h>

#include "config/numbers.hpp"
#include "live/report.hpp"

namespace cgw::live {
namespace {

using Lines = std::vector<std::string>;

std::string bit_rate_text(const config::BusTiming& timing) {
    return timing.manual ? "set by hand (4426 = 1)" : fmt::format("{} kbit/s (426)", timing.bit_rate_kbit);
}

std::string nodes_text(const Heard& heard) {
    std::string text;
    for (std::size_t node = 1; node < heard.others.size(); ++node) {
        if (heard.others.test(node)) {
            text += fmt::format("{}{}", text.empty() ? "" : ", ", node);
        }
    }
    return text;
}

void nothing_heard(const Subject& subject, Lines& lines) {
    lines.push_back("nothing at all was heard on the bus");
    lines.push_back(fmt::format("is it the right bus, and is its bit rate {}?",
                                bit_rate_text(subject.configuration.can2)));
    lines.emplace_back("are CAN_H, CAN_L and ground connected, with 120 Ohm at both ends and nowhere else?");
    lines.emplace_back("have governor and gateway power? Without its governor a gateway stays silent");
}

void device_not_heard(const Subject& subject, const Heard& heard, Lines& lines) {
    lines.push_back(fmt::format("the bus is alive ({} frames heard), but node {} was not heard", heard.frames,
                                subject.configuration.node_id));
    if (heard.others.any()) {
        lines.push_back(fmt::format("heartbeats came from {}: does the gateway have another node-ID (427)?",
                                    nodes_text(heard)));
    } else {
        lines.emplace_back("does the gateway have another node-ID (427)?");
    }
    lines.emplace_back("is the governor on? Without its governor a gateway stays silent");
}

void device_heard(const Subject& subject, const Heard& heard, Lines& lines) {
    const unsigned node = subject.configuration.node_id;
    switch (*heard.state) {
        case canopen::NmtState::stopped:
            lines.push_back(fmt::format("node {} is Stopped: in this state it answers nothing", node));
            lines.push_back(fmt::format("let the master bring it to Pre-Operational (NMT 80 {:02X})", node));
            break;
        case canopen::NmtState::initialising:
            lines.push_back(fmt::format("node {} has just booted: try again", node));
            break;
        case canopen::NmtState::operational:
        case canopen::NmtState::pre_operational:
            lines.push_back(
                fmt::format("heartbeats of node {} came, but no answer to {:03X}h: does another device "
                            "use this node-ID?",
                            node, facts::cob::sdo_request + node));
            break;
    }
}

void silence(const Subject& subject, const Verification& verification, Lines& lines) {
    const Result& result = verification.result();
    const unsigned node = subject.configuration.node_id;
    if (result.answers == 0) {
        lines.push_back(fmt::format("node {} does not answer", node));
    } else {
        lines.push_back(
            fmt::format("node {} answered {} questions and then fell silent", node, result.answers));
    }
    if (result.heard.state) {
        device_heard(subject, result.heard, lines);
    } else if (result.heard.frames == 0) {
        nothing_heard(subject, lines);
    } else if (result.answers == 0) {
        device_not_heard(subject, result.heard, lines);
    } else {
        lines.emplace_back(
            "was it stopped by its master, reset, or switched off? Stopped it answers nothing");
    }
}

void unsendable(const Subject& subject, const Connection& connection, Lines& lines) {
    if (!connection.up) {
        lines.push_back(connection.reason.empty() ? subject.channel + ": there is no connection"
                                                  : "no connection: " + connection.reason);
        return;
    }
    lines.push_back(subject.channel + " takes no frames");
    lines.push_back(
        fmt::format("nobody may be there to acknowledge them: look at bit rate ({}), wiring and power",
                    bit_rate_text(subject.configuration.can2)));
}

void other_device(const Verification& verification, Lines& lines) {
    const Difference& difference = verification.result().differences.back();
    const Question& question = verification.plan()[difference.question];
    lines.push_back(fmt::format("this is another kind of device: nothing else was asked"));
    if (difference.kind == DifferenceKind::value) {
        lines.push_back(fmt::format("{} {}: {} in the file, {} in the device", question.object_text(),
                                    question.name, value_text(question.expected, question.length),
                                    value_text(*difference.value, difference.length)));
    } else {
        lines.push_back(fmt::format("{} {}: {}", question.object_text(), question.name,
                                    sentence_of(question, difference)));
    }
}

}  // namespace

std::vector<std::string> diagnosis(const Subject& subject, const Verification& verification,
                                   const Connection& connection) {
    Lines lines;
    switch (verification.result().ending) {
        case Ending::none:
        case Ending::complete:
            break;
        case Ending::other_device:
            other_device(verification, lines);
            break;
        case Ending::silent:
            silence(subject, verification, lines);
            break;
        case Ending::unsendable:
            unsendable(subject, connection, lines);
            break;
        case Ending::interrupted:
            lines.push_back(fmt::format("interrupted after {} of {} questions", verification.result().asked,
                                        verification.plan().size()));
            break;
    }
    if (verification.result().ending != Ending::unsendable && !connection.up && !connection.reason.empty()) {
        lines.push_back(connection.reason);
    }
    return lines;
}

}  // namespace cgw::live
