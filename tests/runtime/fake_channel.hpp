// A channel whose other end is the test, and the events of a gateway as lines.
#pragma once

#include <fmt/format.h>

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "media/candump.hpp"
#include "runtime/event_lines.hpp"
#include "runtime/events.hpp"

namespace cgw::runtime::test {

class FakeChannel final : public media::Channel {
  public:
    bool send(const frame::Frame& frame) override {
        if (!up || room == 0) {
            return false;
        }
        --room;
        sent.push_back(frame);
        return true;
    }
    int descriptor() const override { return -1; }
    short events() const override { return 0; }
    void service(media::Time now, media::ChannelListener& listener) override {
        if (announce) {
            announce = false;
            listener.link_changed(up ? media::LinkState::up : media::LinkState::down, up ? "there" : "gone",
                                  now);
        }
        for (; !incoming.empty(); incoming.pop_front()) {
            listener.frame(incoming.front(), now);
        }
        if (lost != 0) {
            listener.frames_lost(std::exchange(lost, 0), now);
        }
        wanted = false;
    }
    media::Time deadline() const override {
        return announce || wanted || lost != 0 || !incoming.empty() ? 0 : media::never;
    }
    std::optional<std::uint32_t> bit_rate() const override { return rate; }

    void set_up(bool now_up) {
        up = now_up;
        announce = true;
    }
    // There is room again: the channel wants to be served.
    void make_room(std::size_t frames) {
        room = frames;
        wanted = true;
    }
    std::vector<frame::Frame> take() { return std::exchange(sent, {}); }

    bool up = true;
    bool announce = true;
    bool wanted = false;
    std::size_t room = ~std::size_t{0};
    std::uint64_t lost = 0;
    std::deque<frame::Frame> incoming;
    std::vector<frame::Frame> sent;
    std::optional<std::uint32_t> rate;
};

class EventLog final : public Events {
  public:
    void status_changed(const device::GatewayStatus& before, const device::GatewayStatus& now) override {
        for (const std::string& line : lines_of_change(before, now)) {
            lines.push_back(line.substr(0, line.find(':')));
        }
    }
    void link_changed(Side side, media::LinkState state, std::string_view reason) override {
        lines.push_back(fmt::format("{} {} {}", side == Side::can1 ? "CAN1" : "CAN2",
                                    state == media::LinkState::up ? "up" : "down", reason));
    }
    void frames_lost(Side, std::uint64_t count) override { lines.push_back(fmt::format("lost {}", count)); }
    void governor_refused(const link::Refusal& refusal) override {
        lines.push_back(line_of_refusal(refusal));
    }
    void left_out(Time time) override { lines.push_back(fmt::format("left out {}", time)); }
    void frame(Side side, const frame::Frame& frame) override {
        ++frames[static_cast<std::size_t>(side)];
        last = frame;
    }

    std::vector<std::string> take() { return std::exchange(lines, {}); }

    std::vector<std::string> lines;
    std::array<std::size_t, 2> frames{};
    frame::Frame last;
};

}  // namespace cgw::runtime::test
