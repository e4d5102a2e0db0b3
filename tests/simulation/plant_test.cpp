// Gateway, governor and master together on the simulated bus.
#include "simulation/plant.hpp"

#include "media/candump.hpp"
#include "simulation/master_node.hpp"
#include "simulation/scaling.hpp"
#include "support/recording_port.hpp"
#include "support/sample_plant.hpp"

namespace cgw::simulation {
namespace {

using canopen::NmtCommand;
using canopen::NmtState;
using device::GatewayState;

constexpr Time second = 1'000'000;

class PlantTest : public testing::Test {
  protected:
    PlantTest() {
        sample_.load.number = 2031;
        sample_.load.scaling = sample_.speed.scaling;
        bytes_ = sample_.image();
        EXPECT_EQ(image::Image::open(bytes_, image_), image::Status::ok);
    }
    // As a PLC does: RPDO2 is monitored with 93.75 ms.
    static void produce(MasterNode& master, std::uint32_t id, std::initializer_list<std::uint8_t> data) {
        master.produce(test::make_frame(id, data), 50'000);
    }
    // Node 127's heartbeat is monitored with 96 ms.
    static void beat(MasterNode& master) { produce(master, 0x77F, {0x05}); }

    double speed(const MasterNode& master, std::size_t word = 0) const {
        const auto received = master.received(0x485);
        const std::uint8_t* data = received.value().last.data.data() + 2 * word;
        return scale_of(image_, 2000, 0, 4000)
            .to_engineering(static_cast<std::uint16_t>(data[0] | data[1] << 8));
    }

    test::SamplePlant sample_;
    base::Bytes bytes_;
    image::Image image_;
};

TEST_F(PlantTest, boots_and_beats_like_the_manual_says) {
    Plant plant(image_);
    ASSERT_EQ(plant.status(), device::OpenStatus::ok);
    MasterNode master(plant.can2(), 5, second);
    plant.run_until(3 * second);
    ASSERT_EQ(master.boot_ups().size(), 1U);
    EXPECT_LT(master.boot_ups()[0].time, second / 4);
    ASSERT_EQ(master.heartbeats().size(), 2U);
    EXPECT_EQ(master.heartbeats()[0].state, NmtState::pre_operational);
    EXPECT_NEAR(static_cast<double>(master.heartbeats()[0].time - master.boot_ups()[0].time), 1'008'000,
                1000);
    EXPECT_EQ(plant.gateway().state(), GatewayState::pre_operational);
}

TEST_F(PlantTest, boots_once_more_after_a_reset_by_the_master) {
    Plant plant(image_);
    MasterNode master(plant.can2(), 5, second);
    plant.run_until(second);
    master.master().command(NmtCommand::start, 5);
    plant.run_until(2 * second);
    EXPECT_EQ(plant.gateway().state(), GatewayState::operational);
    master.master().command(NmtCommand::reset_node, 0);
    plant.run_until(3 * second);
    EXPECT_EQ(master.boot_ups().size(), 2U);
    EXPECT_EQ(plant.gateway().state(), GatewayState::pre_operational);
}

TEST_F(PlantTest, sends_cyclic_pdos_in_the_rhythm_of_the_governor) {
    Plant plant(image_);
    MasterNode master(plant.can2(), 5, second);
    master.master().subscribe(0x485);
    master.master().subscribe(0x282);
    plant.run_until(second);
    master.master().command(NmtCommand::start, 5);
    plant.run_until(second + 10 * second);
    EXPECT_NEAR(static_cast<double>(master.received(0x485)->count), 640, 1);
    EXPECT_NEAR(static_cast<double>(master.received(0x282)->count), 640.0 / 12, 1);
    EXPECT_NEAR(speed(master), 1500, 5);
}

TEST_F(PlantTest, follows_an_external_setpoint_first_with_the_setpoint_then_with_the_speed) {
    Plant plant(image_);
    MasterNode master(plant.can2(), 5, second);
    beat(master);
    master.master().subscribe(0x485);
    plant.run_until(second);
    master.master().command(NmtCommand::start, 5);
    plant.run_until(6 * second);
    ASSERT_NEAR(speed(master), 1500, 5);
    produce(master, 0x305, {0xFF, 0xFF});
    plant.run_until(6 * second + 150'000);
    EXPECT_GT(speed(master, 2), speed(master) + 50);  // 2031 SpeedSetp leads
    plant.run_until(9 * second);
    EXPECT_NEAR(speed(master, 2), 1800, 5);
    EXPECT_NEAR(speed(master), 1800, 5);
}

TEST_F(PlantTest, obeys_switch_functions) {
    Plant plant(image_);
    MasterNode master(plant.can2(), 5, second);
    beat(master);
    plant.run_until(second);
    master.master().command(NmtCommand::start, 5);
    plant.run_until(4 * second);
    EXPECT_NEAR(plant.governor().engine().state().load, 0, 0.1);  // 835 counts 0 before RPDO1 came
    produce(master, 0x205, {0x00, 0, 0, 0, 0, 0});                // low-active bit 5
    plant.run_until(8 * second);
    EXPECT_NEAR(plant.governor().engine().state().load, 60, 0.1);
    produce(master, 0x205, {0x01, 0, 0, 0, 0, 0});
    plant.run_until(12 * second);
    EXPECT_NEAR(plant.governor().engine().state().speed, idle_speed, 1);
}

TEST_F(PlantTest, reports_a_missing_sensor_as_an_error_until_it_comes) {
    Plant plant(image_);
    MasterNode master(plant.can2(), 5, second);
    beat(master);
    master.master().subscribe(0x185);
    plant.run_until(second);
    master.master().command(NmtCommand::start, 5);
    plant.run_until(2 * second);
    EXPECT_EQ(master.received(0x185)->last.data[0], 1U << 5);  // 3005 for sensor 900
    EXPECT_EQ(master.received(0x185)->last.data[1], 1U << 3);  // 3011 for sensor 906
    const std::uint64_t before = master.received(0x185)->count;
    produce(master, 0x305, {0, 0x80});
    plant.run_until(3 * second);
    EXPECT_EQ(master.received(0x185)->last.data[0], 0U);
    EXPECT_EQ(master.received(0x185)->count, before + 1);
}

TEST_F(PlantTest, answers_an_sdo_master) {
    Plant plant(image_);
    MasterNode master(plant.can2(), 5, second);
    plant.run_until(second);
    master.master().sdo().upload({0x1018, 1});
    plant.run_until(second + 10'000);
    EXPECT_EQ(master.master().sdo().status(), canopen::SdoClient::Status::done);
    EXPECT_EQ(master.master().sdo().value(), 0x161U);
}

TEST_F(PlantTest, gives_the_same_log_byte_for_byte) {
    const auto run = [this] {
        Plant plant(image_);
        MasterNode master(plant.can2(), 5, second);
        media::CandumpLog log("can0");
        plant.can2().observe([&log](const frame::Frame& frame, Time now) { log.record(frame, now); });
        plant.run_until(second);
        master.master().command(NmtCommand::start, 5);
        plant.run_until(2 * second);
        master.master().send_process_data(0x305, std::array<std::uint8_t, 2>{0, 0x80});
        master.master().sdo().upload({0x2001, 1});
        plant.run_until(5 * second);
        return log.content();
    };
    const base::Bytes first = run();
    EXPECT_GT(first.size(), 10'000U);
    EXPECT_EQ(run(), first);
}

TEST_F(PlantTest, works_without_labels) {
    const base::Bytes bytes = sample_.image(false);
    image::Image image;
    ASSERT_EQ(image::Image::open(bytes, image), image::Status::ok);
    Plant plant(image);
    MasterNode master(plant.can2(), 5, second);
    master.master().subscribe(0x485);
    plant.run_until(second);
    master.master().command(NmtCommand::start, 5);
    plant.run_until(6 * second);
    EXPECT_NEAR(speed(master), 1500, 5);
}

TEST_F(PlantTest, says_why_the_gateway_refuses_an_image) {
    std::erase_if(sample_.dictionary.objects, [](const auto& object) { return object.index == 0x2005; });
    const base::Bytes bytes = sample_.image();
    image::Image image;
    ASSERT_EQ(image::Image::open(bytes, image), image::Status::ok);
    Plant plant(image);
    EXPECT_EQ(plant.status(), device::OpenStatus::object_missing);
}

}  // namespace
}  // namespace cgw::simulation
