// What the forms say that no run can tell: limits of REAL, strings of Python, a plant without anything.
#include <gtest/gtest.h>

#include "partner/structured_parts.hpp"
#include "partner/text.hpp"
#include "signals/signal_support.hpp"

namespace cgw::partner {
namespace {

bool has(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

Half half_with(const parameter::Row& row) {
    config::Configuration configuration = test::empty_configuration();
    test::add_output(configuration, 4, row);
    return {.title = "",
            .configuration_id = "0123456789abcdef",
            .tool_version = "0.1.0",
            .node_id = 5,
            .frames = test::frames_of(configuration)};
}

}  // namespace

TEST(StructuredText, has_physical_values_in_real) {
    const std::string text = structured_text(half_with(test::scaled_row(2000, "Real", -40, 215)));
    EXPECT_TRUE(has(text, "    Real_2 : REAL; (* 2000 Real, 2001h:1; -40..215 *)\n")) << text;
    EXPECT_TRUE(has(text, "GW5_TPDO4_VALUE_Real_2 := DINT_TO_REAL(raw) * 0.0038910506 + -40.0;\n")) << text;
}

TEST(StructuredText, leaves_a_scaling_out_that_real_does_not_hold) {
    for (const auto& [low, high] : {std::pair(0.0, 1e300), std::pair(0.0, 1e-40), std::pair(-1e39, 1.0)}) {
        const std::string text = structured_text(half_with(test::scaled_row(2000, "Speed", low, high)));
        EXPECT_TRUE(
            has(text, "    Speed : DINT; (* 2000 Speed, 2001h:1; raw, REAL does not hold its scaling *)\n"))
            << text;
        EXPECT_FALSE(has(text, "_VALUE_Speed"));
    }
}

TEST(StructuredText, writes_reals_as_the_standard_does) {
    EXPECT_EQ(st_real(250), "250.0");
    EXPECT_EQ(st_real(0.1), "0.1");
    EXPECT_EQ(st_real(1e-7), "1.0E-07");
    EXPECT_EQ(st_real(-1.5e20), "-1.5E+20");
}

TEST(Stx, says_when_the_controllers_heartbeat_comes_too_seldom) {
    Half half = half_with(test::scaled_row(2000, "Speed", 0, 4000));
    half.partner_node_id = 1;
    half.partner_heartbeat_us = 1'000'000;
    EXPECT_TRUE(has(stx(half), "must be set to less"));
    half.partner_heartbeat_us = 1'000'001;
    EXPECT_FALSE(has(stx(half), "must be set to less"));
}

TEST(Stx, has_a_timeout_of_twice_the_heartbeat) {
    Half half = half_with(test::scaled_row(2000, "Speed", 0, 4000));
    EXPECT_TRUE(has(stx(half), "// The gateway sends no heartbeat: leave the timeout at 0.\n"));
    half.heartbeat_us = 796'875;
    EXPECT_TRUE(has(stx(half), "#Define GW5_TIMEOUT_MS 1594\n"));
}

TEST(Stx, initialises_no_controller_whose_node_nobody_knows) {
    const std::string text = stx(half_with(test::scaled_row(2000, "Speed", 0, 4000)));
    EXPECT_FALSE(has(text, "CanOpenInit("));
    EXPECT_TRUE(has(text, "the controller's node-ID is to be chosen"));
}

TEST(PythonString, is_ascii_and_ends_nowhere_else) {
    EXPECT_EQ(python_string("1/min"), "\"1/min\"");
    EXPECT_EQ(python_string("\"\\\n"), "\"\\U00000022\\U0000005c\\U0000000a\"");
    EXPECT_EQ(python_string("\xC2\xB0"
                            "C \xF0\x9F\x9A\xA2 \xFF"),
              "\"\\U000000b0C \\U0001f6a2 \\U0000fffd\"");
}

TEST(PartnersHalf, of_a_gateway_without_active_pdos_is_a_whole_file_still) {
    const Half half{
        .title = "", .configuration_id = "0123456789abcdef", .tool_version = "0.1.0", .node_id = 5};
    EXPECT_TRUE(has(python_canopen(half), "PDOS = (\n)\n"));
    EXPECT_TRUE(has(structured_text(half), "VAR_GLOBAL CONSTANT\n    GW5_NODE_ID : UINT := 5;\n"));
    EXPECT_TRUE(points(half).starts_with("tag,direction,"));
    EXPECT_TRUE(c_header(half).ends_with("\n#endif\n"));
}

}  // namespace cgw::partner
