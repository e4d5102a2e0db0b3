#include "traffic/decoder.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "traffic/words.hpp"
#include "wire/little_endian.hpp"

namespace cgw::traffic {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::size_t nmt_length = 2;
constexpr std::size_t emergency_length = 8;
constexpr std::uint8_t state_mask = 0x7F;
constexpr std::uint8_t toggle_bit = 0x80;

std::string unreadable(Bytes data) {
    return data.empty() ? "no data" : bytes_text(data);
}

std::string nmt_text(Bytes data) {
    if (data.size() != nmt_length) {
        return unreadable(data) + ", no command: it has two bytes";
    }
    const std::string_view known = nmt_command_text(data[0]);
    const std::string command =
        known.empty() ? fmt::format("unknown command {:02X}h", data[0]) : std::string(known);
    return data[1] == 0 ? command + ", all nodes" : fmt::format("{}, node {}", command, data[1]);
}

std::string sync_text(Bytes data) {
    return data.empty() ? "" : data.size() == 1 ? fmt::format("counter {}", data[0]) : unreadable(data);
}

// Six bytes: milliseconds since midnight in 28 bits, days since 1984.
std::string time_text(Bytes data) {
    constexpr std::size_t time_length = 6;
    constexpr std::uint32_t day_ms = 86'400'000;
    if (data.size() != time_length) {
        return unreadable(data);
    }
    const std::uint32_t ms = wire::load_u32(data.data()) & 0x0FFF'FFFFU;
    const unsigned days = wire::load_u16(data.data() + 4);
    if (ms >= day_ms) {
        return unreadable(data);
    }
    return fmt::format("day {} since 1984-01-01, {:02}:{:02}:{:02}.{:03}", days, ms / 3'600'000,
                       ms / 60'000 % 60, ms / 1000 % 60, ms % 1000);
}

std::string emergency_text_of(std::uint8_t node, Bytes data) {
    if (data.size() != emergency_length) {
        return fmt::format("node {}: {}, no emergency: it has eight bytes", node, unreadable(data));
    }
    const std::uint16_t code = wire::load_u16(data.data());
    return fmt::format("node {}: {:04X}h {}, error register {:02X}h, {}", node, code, emergency_text(code),
                       data[2], bytes_text(data.subspan(3)));
}

std::string heartbeat_text(std::uint8_t node, const frame::Frame& frame, Bytes data) {
    if (frame.remote) {
        return fmt::format("node {} is asked for its state (node guarding)", node);
    }
    if (data.size() != 1) {
        return fmt::format("node {}: {}, no heartbeat: it has one byte", node, unreadable(data));
    }
    const auto state = static_cast<std::uint8_t>(data[0] & state_mask);
    const std::string_view known = nmt_state_text(state);
    const std::string text = known.empty() ? fmt::format("unknown state {:02X}h", state) : std::string(known);
    return fmt::format("node {} {}{}", node, text,
                       (data[0] & toggle_bit) != 0 ? ", toggle bit set (node guarding)" : "");
}

}  // namespace

std::string Decoder::text_of(const Owner& owner, const frame::Frame& frame, Bytes data) {
    switch (owner.service) {
        case Service::nmt:
            return nmt_text(data);
        case Service::sync:
            return sync_text(data);
        case Service::time:
            return time_text(data);
        case Service::emergency:
            return emergency_text_of(owner.node, data);
        case Service::pdo:
            return pdo_text(*owner.frame, data);
        case Service::sdo_request:
        case Service::sdo_answer:
            return sdo_.listen(owner.node, owner.service == Service::sdo_request, data);
        case Service::heartbeat:
            return heartbeat_text(owner.node, frame, data);
        case Service::other_pdo:
            return fmt::format("{}: {}", default_use(frame.id), unreadable(data));
        case Service::lss:
        case Service::unknown:
            break;
    }
    return unreadable(data);
}

Meaning Decoder::decode(const frame::Frame& frame) {
    const Bytes data(frame.data.data(), frame.remote ? 0 : std::min<std::size_t>(frame.length, 8));
    Meaning meaning;
    if (frame.extended) {
        meaning.name = name_of(meaning.owner);
        meaning.text = "29-bit identifier: " + (frame.remote ? "remote frame" : unreadable(data));
        return meaning;
    }
    meaning.owner = owners_.of(frame.id);
    const Owner& owner = meaning.owner;
    meaning.name = name_of(owner);
    if (frame.remote && owner.service != Service::heartbeat) {
        meaning.text = "remote frame";
        return meaning;
    }
    meaning.text = text_of(owner, frame, data);
    return meaning;
}

}  // namespace cgw::traffic
