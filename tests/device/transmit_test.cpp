// When the gateway sends which transmit PDO (manual 4.1, D53).
#include "device/gateway_test.hpp"

namespace cgw::device {
namespace {

using canopen::NmtCommand;
using test::identifiers;
using test::make_frame;
using Ids = std::vector<std::uint32_t>;

class GatewayTransmit : public test::GatewayTest {};

TEST_F(GatewayTransmit, sends_the_binary_pdos_once_on_each_entry_into_operational) {
    boot_up();
    data_.errors[0] = 0x1234;
    cycle();
    nmt(NmtCommand::start);
    EXPECT_EQ(port_.take(), (std::vector{make_frame(0x185, {0x34, 0x12, 0, 0, 0, 0, 0, 0}),
                                         make_frame(0x285, {0, 0, 0, 0})}));
    nmt(NmtCommand::start);  // no entry
    EXPECT_TRUE(port_.take().empty());
    nmt(NmtCommand::stop);
    nmt(NmtCommand::start);
    EXPECT_EQ(identifiers(port_.take()), (Ids{0x185, 0x285}));
}

TEST_F(GatewayTransmit, sends_cyclic_pdos_first_in_the_cycle_after_entry_and_then_by_their_cycles) {
    start();
    std::vector<int> tpdo4;
    std::vector<int> tpdo5;
    for (int number = 0; number < 30; ++number) {
        for (const frame::Frame& frame : cycle()) {
            (frame.id == 0x485 ? tpdo4 : tpdo5).push_back(number);
            EXPECT_TRUE(frame.id == 0x485 || frame.id == 0x282) << frame.id;
        }
    }
    EXPECT_EQ(tpdo4.size(), 30U);
    EXPECT_EQ(tpdo5, (std::vector{0, 12, 24}));
}

TEST_F(GatewayTransmit, keeps_the_rhythm_over_main_cycles_whose_data_did_not_come) {
    start();
    std::vector<int> tpdo5;
    int number = 0;
    for (const unsigned elapsed : {1U, 5U, 5U, 5U, 5U, 7U, 30U, 1U, 1U, 1U, 1U, 1U, 1U}) {
        number += static_cast<int>(elapsed);
        gateway_.main_cycle(data_, now_, elapsed);
        for (const frame::Frame& frame : port_.take()) {
            if (frame.id == 0x282) {
                tpdo5.push_back(number);
            }
        }
    }
    // Due in main cycle 1, 13, 25, 37, 49 and 61, and sent with the data that come then.
    EXPECT_EQ(tpdo5, (std::vector{1, 16, 28, 58, 61}));
}

TEST_F(GatewayTransmit, begins_the_rhythm_anew_with_each_entry) {
    start();
    EXPECT_EQ(identifiers(cycle()), (Ids{0x485, 0x282}));
    EXPECT_EQ(identifiers(cycle()), (Ids{0x485}));
    nmt(NmtCommand::enter_pre_operational);
    nmt(NmtCommand::start);
    port_.take();
    EXPECT_EQ(identifiers(cycle()), (Ids{0x485, 0x282}));
}

TEST_F(GatewayTransmit, carries_the_governors_words_dense_and_little_endian) {
    start();
    data_.analogue[0] = {0x1122, 0x3344, 0x5566, 0x7788};
    data_.analogue[1] = {0xABCD, 0xFFFF, 0xFFFF, 0xFFFF};
    EXPECT_EQ(cycle(), (std::vector{make_frame(0x485, {0x22, 0x11, 0x44, 0x33, 0x66, 0x55, 0x88, 0x77}),
                                    make_frame(0x282, {0xCD, 0xAB})}));
}

TEST_F(GatewayTransmit, sends_a_binary_pdo_in_the_cycle_of_a_change_and_only_then) {
    start();
    cycle();
    data_.errors[5] = 0x8000;
    EXPECT_EQ(identifiers(cycle()), (Ids{0x285, 0x485}));
    EXPECT_EQ(identifiers(cycle()), (Ids{0x485}));
    data_.errors[3] = 1;
    EXPECT_EQ(identifiers(cycle()), (Ids{0x185, 0x485}));
}

TEST_F(GatewayTransmit, sends_the_engine_state_in_tpdo3_when_that_is_active) {
    plant_.configuration.send_status = true;
    plant_.tpdo(3).active = true;
    plant_.tpdo(3).mapping = {{config::WordKind::engine_state, 0x2000, 7, nullptr}};
    for (dictionary::Object& object : plant_.dictionary.objects) {
        if (object.index == 0x2000) {
            dictionary::Variable seventh = object.variables.back();
            seventh.sub_index = 7;
            object.variables.push_back(seventh);
        }
    }
    start();
    cycle();
    data_.engine_state = 0x7F81;  // only the low byte counts (D22)
    const std::vector<frame::Frame> frames = cycle();
    EXPECT_EQ(frames.front(), make_frame(0x385, {0x81, 0x00}));
    EXPECT_EQ(upload(0x2000, 7), 0x81U);
}

TEST_F(GatewayTransmit, sends_no_pdo_outside_operational) {
    boot_up();
    for (const NmtCommand away : {NmtCommand::enter_pre_operational, NmtCommand::stop}) {
        nmt(away);
        data_.errors[0] = static_cast<std::uint16_t>(data_.errors[0] + 1);
        for (int i = 0; i < 20; ++i) {
            EXPECT_TRUE(cycle().empty());
        }
    }
}

TEST_F(GatewayTransmit, works_without_any_pdo) {
    plant_.configuration.send_errors = false;
    plant_.configuration.switches.clear();
    plant_.configuration.sensors.clear();
    for (config::Pdo& pdo : plant_.configuration.pdos) {
        pdo.active = false;
        pdo.mapping.clear();
    }
    start();
    data_.errors[0] = 7;
    EXPECT_TRUE(cycle().empty());
    gateway_.receive(make_frame(0x205, {1, 2, 3, 4, 5, 6}), now_);
    EXPECT_TRUE(link_.received.empty());
    EXPECT_EQ(upload(0x2000, 1), 7U);
}

}  // namespace
}  // namespace cgw::device
