// A gateway with the sample plant's image, a recording CAN2 and a recording governor link. Node 5, main cycle
// 15.625 ms, heartbeat 1008 ms, TPDO1, 2, 4 (every cycle) and 5 (every 12), RPDO1 to 3; nothing is monitored.
#pragma once

#include <vector>

#include "canopen/nmt.hpp"
#include "device/gateway.hpp"
#include "support/recording_port.hpp"
#include "support/sample_plant.hpp"

namespace cgw::test {

class RecordingLink final : public device::GovernorLink {
  public:
    void status_changed(const device::GatewayStatus& now) override {
        if (now.state != status.state) {
            states.push_back(now.state);
        }
        status = now;
    }
    void process_data(std::uint8_t rpdo, const device::PdoWords& words) override {
        received.emplace_back(rpdo, words);
    }

    device::GatewayStatus status;
    std::vector<device::GatewayState> states;
    std::vector<std::pair<std::uint8_t, device::PdoWords>> received;
};

class GatewayTest : public testing::Test {
  protected:
    static constexpr canopen::Time main_cycle = 15'625;

    GatewayTest() {
        plant_.configuration.heartbeat_consumer = {};
        plant_.rpdo(2).time = {};
    }

    device::OpenStatus open() {
        bytes_ = plant_.image();
        image::Image image;
        EXPECT_EQ(image::Image::open(bytes_, image), image::Status::ok);
        return gateway_.open(image, now_);
    }
    void command(device::GovernorCommand command) { gateway_.command(command, now_); }
    void nmt(canopen::NmtCommand command, std::uint8_t node = 5) {
        gateway_.receive(canopen::nmt_frame(command, node), now_);
    }
    // Opened and through its initialisation; the boot-up message is taken away.
    void boot_up() {
        ASSERT_EQ(open(), device::OpenStatus::ok);
        command(device::GovernorCommand::init);
        command(device::GovernorCommand::pre_operational);
        port_.take();
        link_.states.clear();
    }
    // In Operational; the frames of the entry are taken away.
    void start() {
        boot_up();
        nmt(canopen::NmtCommand::start);
        port_.take();
        link_.states.clear();
    }
    std::vector<frame::Frame> cycle() {
        now_ += main_cycle;
        gateway_.main_cycle(data_, now_);
        return port_.take();
    }
    // Main cycles up to the moment, at least; returns what was sent.
    std::vector<frame::Frame> run_until(canopen::Time end) {
        while (now_ < end) {
            now_ += main_cycle;
            gateway_.main_cycle(data_, now_);
        }
        return port_.take();
    }
    std::uint32_t upload(std::uint16_t index, std::uint8_t sub_index) {
        gateway_.receive(canopen::sdo::make_frame(0x605, 0x40, {index, sub_index}, 0), now_);
        const std::vector<frame::Frame> answers = port_.take();
        EXPECT_EQ(answers.size(), 1U);
        return answers.empty() ? 0 : canopen::sdo::payload(answers.front());
    }

    SamplePlant plant_;
    base::Bytes bytes_;
    RecordingPort port_;
    RecordingLink link_;
    device::Gateway gateway_{port_, link_};
    device::GovernorData data_;
    canopen::Time now_ = 0;
};

inline std::vector<std::uint32_t> identifiers(const std::vector<frame::Frame>& frames) {
    std::vector<std::uint32_t> result;
    for (const frame::Frame& frame : frames) {
        result.push_back(frame.id);
    }
    return result;
}

}  // namespace cgw::test
