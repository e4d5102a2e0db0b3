#include "runtime/event_lines.hpp"

#include <gtest/gtest.h>

#include "simulation/text.hpp"

namespace cgw::runtime {
namespace {

using Lines = std::vector<std::string>;

// What the gateway tells of itself with these faults.
device::GatewayStatus status_with(std::initializer_list<device::Fault> faults,
                                  device::GatewayState state = device::GatewayState::operational) {
    device::GatewayErrors errors;
    for (const device::Fault fault : faults) {
        errors.set(fault, true);
    }
    device::GatewayStatus status;
    status.state = state;
    status.errors = errors.words();
    status.canopen_errors = errors.canopen_errors();
    return status;
}

TEST(EventLines, say_nothing_when_nothing_has_changed) {
    EXPECT_EQ(lines_of_change(status_with({}), status_with({})), Lines{});
    device::GatewayStatus late = status_with({});
    late.late_rpdos = 1;
    EXPECT_EQ(lines_of_change(status_with({}), late), Lines{});
}

TEST(EventLines, name_the_state) {
    EXPECT_EQ(lines_of_change(status_with({}, device::GatewayState::init),
                              status_with({}, device::GatewayState::pre_operational)),
              Lines{"state Pre-Operational"});
}

TEST(EventLines, tell_an_error_once_with_its_meaning_and_what_it_did) {
    EXPECT_EQ(lines_of_change(status_with({}),
                              status_with({device::Fault::can2_bus}, device::GatewayState::pre_operational)),
              (Lines{"error 3072 ErrCanBus2: CANopen bus faulty: look at cabling, termination, bit rates",
                     "state Pre-Operational"}));
    EXPECT_EQ(lines_of_change(status_with({}), status_with({device::Fault::heartbeat_lost})),
              Lines{"error 12420 CanOpHeartbeatErr: the partner's heartbeat came later than 430 allows"});
}

TEST(EventLines, tell_what_was_cleared) {
    EXPECT_EQ(lines_of_change(status_with({device::Fault::can2_bus, device::Fault::receive_pdo_late}),
                              status_with({device::Fault::can2_bus})),
              Lines{"cleared 12413 CanOpTimeCtrlErr"});
}

TEST(EventLines, have_a_line_for_every_fault) {
    for (const device::FaultRow& row : device::fault_rows()) {
        const Lines lines = lines_of_change(status_with({}), status_with({row.fault}));
        ASSERT_EQ(lines.size(), 1U) << row.error << " " << row.canopen_error;
        const std::string number = std::to_string(row.error != 0 ? row.error : row.canopen_error);
        EXPECT_TRUE(lines.front().starts_with("error " + number + " ")) << lines.front();
    }
}

TEST(EventLines, say_why_a_governor_is_refused) {
    EXPECT_EQ(line_of_refusal({true, {}, 0}),
              "the governor is refused: telegrams of the governor's configuration are missing");
    const link::Refusal differs{false, {link::ItemKind::monitoring, 1, 6}, 7};
    EXPECT_EQ(line_of_refusal(differs), "the governor is refused: " + simulation::refusal_text(differs));
}

}  // namespace
}  // namespace cgw::runtime
