// CAN1 and CAN2 together: resets, refused configurations, and one bus that leaves the other alone.
#include "media/candump.hpp"
#include "simulation/master_node.hpp"
#include "simulation/plant.hpp"
#include "support/recording_port.hpp"
#include "support/sample_plant.hpp"

namespace cgw::simulation {
namespace {

using canopen::NmtCommand;
using device::GatewayState;

constexpr Time second = 1'000'000;

// Sends as fast as the bus carries it.
class Jammer final : public Participant {
  public:
    Jammer(Bus& bus, const frame::Frame& frame) : port_(&bus.attach(*this)), frame_(frame) {}
    Time poll(Time /*now*/) override {
        while (port_->send(frame_)) {
        }
        return canopen::never;
    }

  private:
    frame::FramePort* port_;
    frame::Frame frame_;
};

class TwoBuses : public testing::Test {
  protected:
    TwoBuses() {
        plant_.configuration.heartbeat_consumer = {};
        plant_.rpdo(2).time = {};
        bytes_ = plant_.image();
        EXPECT_EQ(image::Image::open(bytes_, image_), image::Status::ok);
    }
    static std::uint16_t errors(Plant& plant) { return plant.gateway().errors().canopen_errors(); }
    static void start(Plant& plant, MasterNode& master) {
        plant.run_until(plant.now() + second);
        master.master().command(NmtCommand::start, 5);
        plant.run_until(plant.now() + second);
        ASSERT_EQ(plant.gateway().state(), GatewayState::operational);
    }

    test::SamplePlant plant_;
    base::Bytes bytes_;
    image::Image image_;
};

TEST_F(TwoBuses, show_12419_after_a_reset_of_the_gateway_alone) {
    Plant plant(image_);
    MasterNode master(plant.can2(), 5, second);
    start(plant, master);
    plant.reset_gateway();
    EXPECT_EQ(plant.gateway().state(), GatewayState::undefined);
    plant.run_until(plant.now() + second);
    EXPECT_EQ(plant.gateway().state(), GatewayState::pre_operational);
    EXPECT_EQ(errors(plant), 1U << 8);
    EXPECT_EQ(master.boot_ups().size(), 2U);
}

TEST_F(TwoBuses, show_12411_after_a_reset_of_the_governor_alone) {
    Plant plant(image_);
    MasterNode master(plant.can2(), 5, second);
    start(plant, master);
    plant.reset_governor();
    plant.run_until(plant.now() + second);
    EXPECT_EQ(plant.gateway().state(), GatewayState::pre_operational);
    EXPECT_EQ(errors(plant), 1U << 0);
    EXPECT_EQ(master.boot_ups().size(), 2U);
}

TEST_F(TwoBuses, show_12412_when_the_devices_have_different_configurations) {
    plant_.tpdo(4).time = {32, 2, 31'250};
    const base::Bytes other_bytes = plant_.image();
    image::Image other;
    ASSERT_EQ(image::Image::open(other_bytes, other), image::Status::ok);
    Plant plant(image_, other);
    MasterNode master(plant.can2(), 5, second);
    plant.run_until(5 * second);
    EXPECT_EQ(plant.gateway().state(), GatewayState::undefined);
    EXPECT_EQ(errors(plant), 1U << 1);
    EXPECT_EQ(plant.gateway_link().refusal().expected.kind, link::ItemKind::cycles);
    EXPECT_EQ(plant.governor().link().failed_attempts(), 3U);
    EXPECT_TRUE(master.boot_ups().empty());
    plant.governor().clear_errors();
    plant.run_until(plant.now() + 200'000);
    EXPECT_EQ(errors(plant), 0);
    plant.run_until(plant.now() + 5 * second);
    EXPECT_EQ(errors(plant), 1U << 1);
}

TEST_F(TwoBuses, leave_can1_alone_when_can2_is_saturated) {
    base::Bytes logs[2];
    for (const bool saturated : {false, true}) {
        Plant plant(image_);
        media::CandumpLog log("can1");
        plant.can1().observe([&log](const frame::Frame& frame, Time now) { log.record(frame, now); });
        std::optional<Jammer> jammer;
        if (saturated) {
            jammer.emplace(plant.can2(), test::make_frame(0x001, {0, 0, 0, 0, 0, 0, 0, 0}));
        }
        plant.run_until(5 * second);
        EXPECT_EQ(plant.gateway().state(), GatewayState::pre_operational);
        logs[saturated ? 1 : 0] = log.content();
        if (saturated) {
            EXPECT_GT(plant.can2().busy_time(), 5 * second * 99 / 100);
        }
    }
    EXPECT_EQ(logs[0], logs[1]);
}

TEST_F(TwoBuses, leave_the_governor_its_part_of_can1_when_receive_pdos_saturate_can2) {
    Plant plant(image_);
    MasterNode master(plant.can2(), 5, second);
    start(plant, master);
    plant.run_until(plant.now() + 2 * second);
    Jammer jammer(plant.can2(), test::make_frame(0x305, {0x34, 0x12}));
    const Time busy_before = plant.can1().busy_time();
    const std::uint64_t received_before = plant.gateway().slave().receiver().counters().received;
    plant.run_until(plant.now() + 5 * second);
    EXPECT_GT(plant.gateway().slave().receiver().counters().received - received_before, 5'000U);
    EXPECT_EQ(plant.gateway().state(), GatewayState::operational);
    EXPECT_EQ(errors(plant), 0);
    EXPECT_EQ(plant.governor().link().phase(), link::GovernorEnd::Phase::running);
    EXPECT_LT(plant.can1().busy_time() - busy_before, 5 * second / 2);
}

TEST_F(TwoBuses, keep_heartbeats_and_answers_in_time_when_can1_is_saturated) {
    std::vector<Time> times[2];
    for (const bool saturated : {false, true}) {
        Plant plant(image_);
        MasterNode master(plant.can2(), 5, second);
        start(plant, master);
        std::optional<Jammer> jammer;
        if (saturated) {
            frame::Frame frame =
                test::make_frame(0x1FFFFFFF, {0, 0, 0, 0, 0, 0, 0, 0});  // gives way to the link
            frame.extended = true;
            jammer.emplace(plant.can1(), frame);
        }
        const Time begin = plant.now();
        plant.run_until(begin + 5 * second);
        EXPECT_EQ(plant.gateway().state(), GatewayState::operational);
        EXPECT_EQ(errors(plant), 0);
        for (const MasterNode::Event& heartbeat : master.heartbeats()) {
            times[saturated ? 1 : 0].push_back(heartbeat.time);
        }
        master.master().sdo().upload({0x1018, 1});
        plant.run_until(plant.now() + 2'000);
        EXPECT_EQ(master.master().sdo().status(), canopen::SdoClient::Status::done);
    }
    ASSERT_EQ(times[0].size(), times[1].size());
    for (std::size_t i = 0; i < times[0].size(); ++i) {
        EXPECT_NEAR(static_cast<double>(times[0][i]), static_cast<double>(times[1][i]), 2'000) << i;
    }
}

}  // namespace
}  // namespace cgw::simulation
