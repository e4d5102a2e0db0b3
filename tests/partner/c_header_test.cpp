#include "partner/half.hpp"

#include <gtest/gtest.h>

#include "signals/signal_support.hpp"

namespace cgw::partner {
namespace {

Half sample() {
    return {.title = "Genset 2",
            .configuration_id = "0123456789abcdef",
            .tool_version = "0.1.0",
            .node_id = 12,
            .frames = test::frames_of(test::manual_configuration())};
}

bool has(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST(PartnerHalf, is_named_after_the_node_so_that_two_gateways_fit_into_one_program) {
    EXPECT_EQ(prefix(sample()), "gw12");
    EXPECT_TRUE(has(c_header(sample()), "#ifndef CGW_GW12_PARTNER_H\n#define CGW_GW12_PARTNER_H\n"));
}

TEST(CHeader, names_what_the_partner_sends_and_reads) {
    const std::string text = c_header(sample());
    EXPECT_TRUE(has(text,
                    "#define GW12_TPDO4_COB_ID 0x481u\n#define GW12_TPDO4_LENGTH 8u\n"
                    "#define GW12_TPDO4_CYCLE_US 15625u\n"));
    EXPECT_TRUE(has(text, "#define GW12_RPDO3_MONITORING_US 187500u\n"));
    EXPECT_TRUE(has(text, "gw12_tpdo4_raw_Speed(const gw12_tpdo4 *pdo)"));
    EXPECT_TRUE(has(text, "gw12_rpdo1_turn_FunctLoadEnable(gw12_rpdo1 *pdo, int on)"));
    EXPECT_FALSE(has(text, "gw12_tpdo4_setraw_")) << "nobody but the gateway sends a transmit PDO";
    EXPECT_TRUE(has(text, "#define GW12_CONFIGURATION_ID \"0123456789abcdef\"\n"));
}

TEST(CHeader, has_no_physical_value_where_the_scaling_is_not_known) {
    EXPECT_FALSE(has(c_header(sample()), "gw12_tpdo4_value_Speed"));
    EXPECT_TRUE(has(c_header(sample()), "scaling not known"));
}

TEST(CHeader, says_that_a_bit_rate_set_by_hand_is_not_known) {
    Half half = sample();
    EXPECT_TRUE(has(c_header(half), "/* The bit rate is set by hand and not known here. */\n"));
    half.bit_rate = 250'000;
    EXPECT_TRUE(has(c_header(half), "#define GW12_BIT_RATE 250000u\n"));
}

TEST(Points, are_a_line_for_each_signal) {
    const std::string text = points(sample());
    EXPECT_TRUE(has(text,
                    "\nGW12.TPDO4.Speed,read,TPDO4,0x481,8,0,0,16,UINT16,,,,,,0,65535,15.625,"
                    "measurement,2001h:1,,\"2000 Speed, 2001h:1\",0123456789abcdef\n"))
        << text;
    EXPECT_TRUE(has(text,
                    "\nGW12.RPDO1.FunctLoadEnable,write,RPDO1,0x201,6,0,4,1,BOOL,,,,,,0,1,0,switch,"
                    "2003h:1,0=on; 1=off,"))
        << text;
}

}  // namespace cgw::partner
