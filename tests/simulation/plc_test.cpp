// The PLC, what disturbs a plant, and how it is told.
#include "simulation/error_numbers.hpp"
#include "simulation/faults.hpp"
#include "simulation/installation.hpp"
#include "simulation/text.hpp"
#include "support/recording_port.hpp"
#include "support/sample_plant.hpp"

namespace cgw::simulation {
namespace {

using device::GatewayState;

constexpr Time second = 1'000'000;

class InstallationTest : public testing::Test {
  protected:
    InstallationTest() {
        bytes_ = plant_.image();
        EXPECT_EQ(image::Image::open(bytes_, image_), image::Status::ok);
    }
    static std::uint16_t errors(Installation& installation) {
        return installation.plant().gateway().errors().canopen_errors();
    }

    test::SamplePlant plant_;
    base::Bytes bytes_;
    image::Image image_;
};

TEST_F(InstallationTest, has_a_plc_that_starts_the_gateway_and_keeps_it_content) {
    Installation installation(image_);
    installation.plant().run_until(3 * second);
    EXPECT_EQ(installation.plant().gateway().state(), GatewayState::operational);
    EXPECT_EQ(errors(installation), 0);
    EXPECT_EQ(installation.node().boot_ups().size(), 1U);
    EXPECT_GT(installation.node().received(0x485)->count, 100U);
}

TEST_F(InstallationTest, plc_waits_a_moment_after_the_boot_up) {
    Installation installation(image_);
    std::vector<Time> commands;
    installation.plant().can2().observe([&commands](const frame::Frame& frame, Time now) {
        if (frame.id == 0) {
            commands.push_back(now);
        }
    });
    installation.plant().run_until(3 * second);
    ASSERT_EQ(commands.size(), 1U);
    const Time waited = commands[0] - installation.node().boot_ups()[0].time;
    EXPECT_GE(waited, Plc::start_delay);
    EXPECT_LT(waited, Plc::start_delay + 1'000);
}

TEST_F(InstallationTest, plc_leaves_the_gateway_alone_when_it_is_told_to) {
    Installation installation(image_);
    installation.plc().start_after_boot_up(false);
    installation.plant().run_until(3 * second);
    EXPECT_EQ(installation.plant().gateway().state(), GatewayState::pre_operational);
}

TEST_F(InstallationTest, plc_has_outputs_only_for_what_comes_over_canopen) {
    Installation installation(image_);
    Plc& plc = installation.plc();
    EXPECT_TRUE(plc.set_sensor(900, 0x1234));
    EXPECT_EQ(plc.outputs()[1][0], 0x1234);
    EXPECT_FALSE(plc.set_sensor(901, 1));
    EXPECT_TRUE(plc.flag_sensor(906, true));
    EXPECT_EQ(plc.outputs()[0][2], 1U << 6);
    EXPECT_TRUE(plc.flag_sensor(906, false));
    EXPECT_EQ(plc.outputs()[0][2], 0);
    EXPECT_FALSE(plc.flag_sensor(901, true));
    EXPECT_EQ(plc.outputs()[0][0], 0);  // 811 off, 835 enabled by a low-active bit
    EXPECT_TRUE(plc.set_switch(835, false));
    EXPECT_TRUE(plc.set_switch(811, true));
    EXPECT_EQ(plc.outputs()[0][0], 0x11);
    EXPECT_FALSE(plc.set_switch(812, true));
}

TEST_F(InstallationTest, finds_the_word_of_a_parameter) {
    const auto place = find_word(image_, 2101);
    ASSERT_TRUE(place);
    EXPECT_EQ(place->pdo.number, 4);
    EXPECT_EQ(place->word, 2U);
    EXPECT_FALSE(find_word(image_, 2102));
    EXPECT_FALSE(find_word(image_, 0));
}

TEST_F(InstallationTest, keeps_causes_over_a_reset_of_the_gateway) {
    Installation installation(image_);
    installation.plant().run_until(2 * second);
    installation.plant().report(device::Fault::can2_bus, true);
    installation.plant().reset_gateway();
    EXPECT_TRUE(installation.plant().gateway().errors().present(device::Fault::can2_bus));
    installation.plant().report(device::Fault::can2_bus, false);
    installation.plant().reset_gateway();
    EXPECT_FALSE(installation.plant().gateway().errors().shown(device::Fault::can2_bus));
}

TEST_F(InstallationTest, mending_a_bus_and_mending_its_fault_are_two_things) {
    struct Case {
        Plant::BusName bus;
        device::Fault fault;
    };
    for (const Case& one : {Case{Plant::BusName::can1, device::Fault::can1_bus},
                            Case{Plant::BusName::can2, device::Fault::can2_bus}}) {
        Installation installation(image_);
        Plant& plant = installation.plant();
        const auto present = [&] { return plant.gateway().errors().present(one.fault); };
        plant.run_until(2 * second);
        plant.report(one.fault, true);
        plant.connect(one.bus, false);
        plant.connect(one.bus, true);
        EXPECT_TRUE(present()) << "reported by name";
        plant.report(one.fault, false);
        EXPECT_FALSE(present());
        plant.connect(one.bus, false);
        plant.report(one.fault, true);
        plant.report(one.fault, false);
        EXPECT_TRUE(present()) << "still cut";
        plant.reset_gateway();
        EXPECT_TRUE(present()) << "after a reset";
        plant.connect(one.bus, true);
        EXPECT_FALSE(present());
    }
}

TEST_F(InstallationTest, shows_the_errors_of_both_devices) {
    Installation installation(image_);
    installation.plant().run_until(2 * second);
    EXPECT_EQ(installation.error_words()[0], 0);
    installation.plc().flag_sensor(900, true);
    installation.plc().send_outputs();
    installation.plant().report(device::Fault::supply_voltage, true);
    installation.plant().run_until(3 * second);
    EXPECT_EQ(installation.error_words()[0], 1U << 5);
    EXPECT_EQ(installation.error_words()[5], 1U << 5);
}

TEST_F(InstallationTest, clearing_errors_at_either_device_lifts_an_emergency_stop) {
    for (const bool at_governor : {true, false}) {
        Installation installation(image_);
        installation.plant().run_until(6 * second);
        installation.plant().report(EngineFault::actuator_stuck, true);
        installation.plant().report(EngineFault::load_rejection, true);
        installation.plant().run_until(30 * second);
        const SimulatedGovernor& governor = installation.plant().governor();
        EXPECT_TRUE(governor.alarms().emergency_stop());
        EXPECT_TRUE(governor.engine().state().standing());
        installation.plant().report(EngineFault::actuator_stuck, false);
        installation.plant().reset_governor();
        installation.plant().run_until(40 * second);
        EXPECT_TRUE(governor.alarms().emergency_stop()) << "not lifted by an interrupted supply";
        if (at_governor) {
            installation.plant().governor().clear_errors();
        } else {
            installation.plant().clear_gateway_errors();
        }
        installation.plant().run_until(50 * second);
        EXPECT_FALSE(governor.alarms().any());
        EXPECT_TRUE(governor.engine().state().running());
    }
}

TEST(SimulationFaults, are_those_that_come_from_outside_each_with_one_name) {
    std::vector<device::Fault> seen_by_the_gateway{
        device::Fault::governor_reset, device::Fault::initialisation, device::Fault::receive_pdo_late,
        device::Fault::gateway_reset,  device::Fault::heartbeat_lost, device::Fault::governor_silent,
        device::Fault::sdo_overflow};
    for (const device::FaultRow& row : device::fault_rows()) {
        std::size_t named = 0;
        for (const NamedFault& fault : named_faults()) {
            named += fault.cause == std::variant<device::Fault, EngineFault>(row.fault) ? 1U : 0U;
        }
        const bool own = std::find(seen_by_the_gateway.begin(), seen_by_the_gateway.end(), row.fault) !=
                         seen_by_the_gateway.end();
        EXPECT_EQ(named, own ? 0U : 1U) << static_cast<int>(row.fault);
    }
}

TEST(SimulationFaults, of_the_engine_have_one_name_each) {
    std::vector<std::size_t> named(engine_fault_count);
    for (const NamedFault& fault : named_faults()) {
        if (const EngineFault* const cause = std::get_if<EngineFault>(&fault.cause)) {
            ++named[static_cast<std::size_t>(*cause)];
        }
    }
    EXPECT_EQ(named, std::vector<std::size_t>(engine_fault_count, 1));
}

TEST(SimulationErrorNumbers, are_those_of_both_kinds_of_bits) {
    std::array<std::uint16_t, device::error_words> words{};
    words[0] = 1U << 5;
    words[5] = 0x8000;
    EXPECT_EQ(error_numbers(0x2001, words), (std::vector<std::uint16_t>{12411, 12424, 3005, 3095}));
    EXPECT_TRUE(error_numbers(0, {}).empty());
}

TEST(SimulationTexts, say_why_a_configuration_is_refused) {
    using link::ItemKind;
    EXPECT_EQ(refusal_text({false, {ItemKind::cycles, 0, 1}, 2}),
              "main cycles of TPDO4: 2 at the governor, 1 at the gateway");
    EXPECT_EQ(refusal_text({false, {ItemKind::assignment, 51, 2905}, 0}),
              "parameter in word 4 of TPDO16: 0 at the governor, 2905 at the gateway");
    EXPECT_EQ(refusal_text({false, {ItemKind::monitoring, 3, 6}, 0}),
              "monitoring cycles of RPDO4: 0 at the governor, 6 at the gateway");
    EXPECT_EQ(refusal_text({false, {ItemKind::sensor_number, 2, 906}, 907}),
              "sensor 3 of the list: 907 at the governor, 906 at the gateway");
    EXPECT_EQ(refusal_text({true, {}, 0}), "telegrams of the governor's configuration are missing");
    for (int kind = 0; kind <= static_cast<int>(ItemKind::sensor_channel); ++kind) {
        EXPECT_EQ(refusal_text({false, {static_cast<ItemKind>(kind), 0, 0}, 0}).find("unknown"),
                  std::string::npos);
    }
}

}  // namespace
}  // namespace cgw::simulation
