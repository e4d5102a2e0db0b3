// The table of manual 9.4 and 9.5, and what is set at the moment.
#include "device/gateway_errors.hpp"

#include <gtest/gtest.h>

#include "catalogue/errors.hpp"

namespace cgw::device {
namespace {

std::uint16_t word_of(const GatewayErrors& errors, std::uint16_t number) {
    return errors.words()[(number - 3000U) / 16];
}
bool set(const GatewayErrors& errors, std::uint16_t number) {
    return ((unsigned{word_of(errors, number)} >> ((number - 3000U) % 16)) & 1U) != 0;
}

TEST(GatewayErrorTable, has_every_canopen_error_of_2005h) {
    unsigned bits = 0;
    for (const FaultRow& row : fault_rows()) {
        if (row.canopen_error != 0) {
            ASSERT_GE(row.canopen_error, 12411);
            bits |= 1U << (row.canopen_error - 12411U);
        }
    }
    EXPECT_EQ(bits, 0b0011'1111'0001'1111U);  // manual, table 2
}

TEST(GatewayErrorTable, keeps_its_own_errors_within_the_sentinels) {
    for (const FaultRow& row : fault_rows()) {
        if (row.error != 0) {
            EXPECT_GE(row.error, GatewayErrors::first_error);
            EXPECT_LT(row.error, GatewayErrors::first_error + GatewayErrors::error_count);
        }
    }
}

// What `cgw explain` says of an error and what the gateway does must be the same.
TEST(GatewayErrorTable, clears_errors_as_their_descriptions_say) {
    for (const FaultRow& row : fault_rows()) {
        for (const std::uint16_t number : {row.error, row.canopen_error}) {
            if (number == 0) {
                continue;
            }
            const catalogue::ErrorDescription* const described =
                catalogue::find_error(parameter::Device::gateway, parameter::Program::application, number);
            ASSERT_NE(described, nullptr) << number;
            const bool by_itself = described->clears.find("by itself") != std::string_view::npos;
            const bool by_reset = described->clears.find("with the reset") != std::string_view::npos;
            EXPECT_EQ(row.clearing == Clearing::by_itself, by_itself) << number;
            EXPECT_EQ(row.clearing == Clearing::by_reset, by_reset) << number;
        }
    }
}

// The counter of 30nn is 31nn.
TEST(GatewayErrorTable, counts_exactly_the_errors_that_have_a_sentinel) {
    for (const FaultRow& row : fault_rows()) {
        if (row.error != 0) {
            const catalogue::ErrorDescription* const described =
                catalogue::find_error(parameter::Device::gateway, parameter::Program::application, row.error);
            ASSERT_NE(described, nullptr) << row.error;
            EXPECT_EQ(described->counter, row.error + 100);
        }
    }
}

TEST(GatewayErrors, shows_a_fault_in_2005h_and_in_its_own_bits) {
    GatewayErrors errors;
    errors.set(Fault::can2_bus, true);
    EXPECT_EQ(errors.canopen_errors(), 1U << 12);
    EXPECT_TRUE(set(errors, 3072));
    EXPECT_TRUE(set(errors, 3074));
    EXPECT_FALSE(set(errors, 3070));
}

TEST(GatewayErrors, has_no_3074_without_a_canopen_error) {
    GatewayErrors errors;
    errors.set(Fault::supply_voltage, true);
    EXPECT_TRUE(set(errors, 3085));
    EXPECT_FALSE(set(errors, 3074));
}

TEST(GatewayErrors, keeps_a_fault_whose_cause_is_gone_until_it_is_cleared) {
    GatewayErrors errors;
    errors.set(Fault::can1_bus, true);
    errors.clear();
    EXPECT_TRUE(errors.shown(Fault::can1_bus));  // still there
    errors.set(Fault::can1_bus, false);
    EXPECT_TRUE(errors.shown(Fault::can1_bus));
    errors.clear();
    EXPECT_FALSE(errors.shown(Fault::can1_bus));
    EXPECT_EQ(errors.canopen_errors(), 0);
}

TEST(GatewayErrors, drops_what_clears_itself_with_its_cause) {
    for (const Fault fault : {Fault::receive_pdo_late, Fault::heartbeat_lost, Fault::supply_voltage}) {
        GatewayErrors errors;
        errors.set(fault, true);
        EXPECT_TRUE(errors.shown(fault));
        errors.set(fault, false);
        EXPECT_FALSE(errors.shown(fault));
    }
}

TEST(GatewayErrors, keeps_what_only_a_reset_clears) {
    GatewayErrors errors;
    errors.strike(Fault::program_memory);
    errors.clear();
    EXPECT_TRUE(set(errors, 3077));
    EXPECT_TRUE(errors.blocking());
}

TEST(GatewayErrors, shows_one_error_for_several_causes_until_the_last_is_cleared) {
    GatewayErrors errors;
    errors.strike(Fault::can1_overflow);
    errors.set(Fault::governor_silent, true);
    errors.clear();
    EXPECT_TRUE(set(errors, 3071));
    errors.set(Fault::governor_silent, false);
    errors.clear();
    EXPECT_FALSE(set(errors, 3071));
}

TEST(GatewayErrors, lets_canopen_run_with_errors_that_forbid_it_no_more) {
    GatewayErrors errors;
    errors.strike(Fault::can1_overflow);
    EXPECT_FALSE(errors.blocking());
    errors.set(Fault::can1_bus, true);
    EXPECT_TRUE(errors.blocking());
    errors.set(Fault::can1_bus, false);
    EXPECT_FALSE(errors.blocking());
    errors.set(Fault::can2_bus, true);
    EXPECT_FALSE(errors.blocking());
}

TEST(GatewayErrors, counts_each_appearance_of_an_error) {
    GatewayErrors errors;
    for (int i = 0; i < 3; ++i) {
        errors.strike(Fault::can1_overflow);
        errors.clear();
    }
    EXPECT_EQ(errors.sentinels()[3071 - 3070], 3);
    EXPECT_EQ(errors.sentinels()[3074 - 3070], 3);
    EXPECT_EQ(errors.sentinels()[3070 - 3070], 0);
}

TEST(GatewayErrors, counts_an_error_that_is_already_set_once) {
    GatewayErrors errors;
    errors.strike(Fault::can1_overflow);
    errors.strike(Fault::can1_overflow);
    errors.set(Fault::governor_silent, true);
    EXPECT_EQ(errors.sentinels()[3071 - 3070], 1);
}

TEST(GatewayErrors, counts_to_255_and_goes_on_from_where_it_was_restored) {
    GatewayErrors errors;
    std::array<std::uint8_t, GatewayErrors::error_count> before{};
    before[3072 - 3070] = 254;
    errors.restore(before);
    for (int i = 0; i < 3; ++i) {
        errors.strike(Fault::can2_bus);
        errors.clear();
    }
    EXPECT_EQ(errors.sentinels()[3072 - 3070], 255);
}

}  // namespace
}  // namespace cgw::device
