// A gateway and a governor with their ends of the link, and a wire between them that a test can break.
#pragma once

#include <gtest/gtest.h>

#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "canopen/nmt.hpp"
#include "link/gateway_end.hpp"
#include "link/governor_end.hpp"
#include "support/recording_port.hpp"
#include "support/sample_plant.hpp"

namespace cgw::test {

// One direction; frames arrive when the test lets them.
struct Wire final : frame::FramePort {
    bool send(const frame::Frame& frame) override {
        if (waiting.size() >= room) {
            return false;
        }
        waiting.push_back(frame);
        return true;
    }
    std::size_t room = 64;
    std::deque<frame::Frame> waiting;
};

class LinkTest : public testing::Test, public link::GovernorListener {
  protected:
    static constexpr canopen::Time main_cycle = 15'625;

    LinkTest() {
        plant_.configuration.heartbeat_consumer = {};
        bytes_ = plant_.image();
        EXPECT_EQ(image::Image::open(bytes_, image_), image::Status::ok);
        gateway_end_.connect(gateway_);
        open_gateway(1);
        governor_end_.open(image_, 1);
    }

    void gateway_status(const device::GatewayStatus& status) override { status_ = status; }
    void process_data(std::uint8_t rpdo, const device::PdoWords& words) override {
        received_.emplace_back(rpdo, words);
    }

    void open_gateway(std::uint8_t boot) {
        gateway_end_.open(image_, boot);
        EXPECT_EQ(gateway_.open(image_, now_), device::OpenStatus::ok);
    }
    // The governor has another configuration than the gateway.
    void governor_differs(const std::function<void(SamplePlant&)>& change) {
        change(plant_);
        other_bytes_ = plant_.image();
        ASSERT_EQ(image::Image::open(other_bytes_, other_), image::Status::ok);
        governor_end_.open(other_, 1);
    }

    void deliver() {
        for (bool moved = true; moved;) {
            moved = false;
            if (!to_gateway_.waiting.empty()) {
                const frame::Frame frame = to_gateway_.waiting.front();
                to_gateway_.waiting.pop_front();
                moved = true;
                if (!lost_ || !lost_(frame)) {
                    gateway_end_.receive(frame, now_);
                }
            }
            if (!to_governor_.waiting.empty()) {
                const frame::Frame frame = to_governor_.waiting.front();
                to_governor_.waiting.pop_front();
                moved = true;
                if (!lost_to_governor_ || !lost_to_governor_(frame)) {
                    governor_end_.receive(frame, now_);
                }
            }
        }
    }
    void cycle() {
        now_ += main_cycle;
        governor_end_.main_cycle(data_, flags_, now_);
        gateway_end_.poll(now_);
        gateway_.poll(now_);
        deliver();
        gateway_end_.poll(now_);
        governor_end_.poll();
        deliver();
    }
    void run_for(canopen::Time time) {
        for (const canopen::Time end = now_ + time; now_ < end;) {
            cycle();
        }
    }
    void start() {
        run_for(500'000);
        gateway_.receive(canopen::nmt_frame(canopen::NmtCommand::start, 5), now_);
        cycle();
        ASSERT_EQ(gateway_.state(), device::GatewayState::operational);
        can2_.take();
    }
    // The governor's words of TPDO4, as the gateway sends them.
    std::optional<frame::Frame> tpdo4() {
        std::optional<frame::Frame> last;
        for (const frame::Frame& frame : can2_.take()) {
            if (frame.id == 0x485) {
                last = frame;
            }
        }
        return last;
    }
    std::uint16_t errors() const { return gateway_.errors().canopen_errors(); }

    SamplePlant plant_;
    base::Bytes bytes_, other_bytes_;
    image::Image image_, other_;
    Wire to_gateway_, to_governor_;
    std::function<bool(const frame::Frame&)> lost_;  // on the way to the gateway
    std::function<bool(const frame::Frame&)> lost_to_governor_;
    RecordingPort can2_;
    link::GatewayEnd gateway_end_{to_governor_};
    device::Gateway gateway_{can2_, gateway_end_};
    link::GovernorEnd governor_end_{to_gateway_, *this};
    device::GovernorData data_;
    std::uint8_t flags_ = 0;
    canopen::Time now_ = 0;
    device::GatewayStatus status_;
    std::vector<std::pair<std::uint8_t, device::PdoWords>> received_;
};

}  // namespace cgw::test
