// Times, switches, sensors and assigned parameters; and what holds for the table as a whole.
#include <gtest/gtest.h>

#include <set>

#include "check/findings_text.hpp"
#include "diagnostic/rules.hpp"

namespace cgw::check {
namespace {

using parameter::Device;
using test::errors_of;
using test::PlantBuilder;

TEST(Times, are_shorter_than_256_main_cycles) {
    PlantBuilder plant;
    EXPECT_EQ(errors_of(plant.minimal().governor(16460, 3999).governor(16483, 3999)), "");
    EXPECT_EQ(errors_of(plant.governor(16472, 4000)),
              "22:8 E0209 time-too-long: 16472 CanOpTPDO4-16Cyc(12) is 4000 ms, 256 main cycles of 15.625 "
              "ms; at most "
              "255 are possible (manual 7.1.3)\n"
              "  help: 3999 ms is the longest time that works\n");
}

TEST(Times, of_rpdos_are_held_to_the_same_limit) {
    PlantBuilder plant;
    EXPECT_EQ(errors_of(plant.minimal().governor(16480, 5000)),
              "20:8 E0209 time-too-long: 16480 CanOpRPDO1-4Cyc(0) is 5000 ms, 320 main cycles of 15.625 ms; "
              "at most 255 "
              "are possible (manual 7.1.5)\n"
              "  help: 3999 ms is the longest time that works\n");
}

TEST(Times, are_counted_in_the_governors_own_main_cycle) {
    PlantBuilder plant;
    plant.minimal().governor(16460, 2560).settings().main_cycle_us = 10000;
    EXPECT_EQ(errors_of(plant),
              "20:8 E0209 time-too-long: 16460 CanOpTPDO4-16Cyc(0) is 2560 ms, 256 main cycles of 10 ms; at "
              "most 255 "
              "are possible (manual 7.1.3)\n"
              "  help: 2559 ms is the longest time that works\n");
}

TEST(Switches, use_bits_1_to_16_of_either_sign) {
    PlantBuilder plant;
    plant.minimal().governor(811, 16).governor(4811, 3).governor(812, -16).governor(4812, 3);
    EXPECT_EQ(errors_of(plant.governor(813, 0).governor(4813, 3)), "");
    EXPECT_EQ(errors_of(plant.governor(849, 17).governor(4849, 3)),
              "26:8 E0210 switch-bit-range: 849 is 17, but RPDO1 word 1 has the bits 1 to 16, negative for "
              "low-active (manual 7.1.4.1)\n"
              "  see 27:8: the governor's 4849 is 3 here\n");
    const std::string text = errors_of(plant.governor(849, -17));
    EXPECT_NE(text.find("is -17, but"), std::string::npos) << text;
}

TEST(Switches, that_are_hardware_inputs_are_no_business_of_ours) {
    PlantBuilder plant;
    EXPECT_EQ(errors_of(plant.minimal().governor(811, 40).governor(4811, 1).governor(812, 40)), "");
}

TEST(Sensors, use_channels_1_to_12) {
    PlantBuilder plant;
    EXPECT_EQ(
        errors_of(plant.minimal().governor(900, 12).governor(4900, 3).governor(901, 0).governor(4901, 3)),
        "");
    const std::string text = errors_of(plant.governor(929, 13).governor(4929, 3));
    EXPECT_EQ(text.find("24:8 E0211 sensor-channel-range: "), 0U) << text;
    EXPECT_NE(text.find("is 13, but the words of RPDO2 to RPDO4 are the channels 1 to 12 (manual 7.1.4.2)"),
              std::string::npos);
    const std::string negative = errors_of(plant.governor(929, -1));
    EXPECT_NE(negative.find("E0211"), std::string::npos) << negative;
}

TEST(Sensors, that_are_hardware_inputs_are_no_business_of_ours) {
    PlantBuilder plant;
    EXPECT_EQ(errors_of(plant.minimal().governor(900, 20).governor(4900, 1)), "");
}

TEST(EngineStop, never_comes_over_canopen) {
    PlantBuilder plant;
    EXPECT_EQ(errors_of(plant.minimal().governor(810, 99).governor(4810, 3)),
              "21:8 E0212 engine-stop-over-canopen: 4810 is 3: engine stop must be wired and must not "
              "come over "
              "CANopen (manual 7.1.4.1)\n"
              "  see 20:8: the governor's 810 is 99 here\n");
}

TEST(EngineStop, may_be_wired) {
    PlantBuilder plant;
    EXPECT_EQ(errors_of(plant.minimal().governor(810, 4).governor(4810, 1)), "");
}

TEST(Outputs, are_known_to_a_catalogue) {
    PlantBuilder plant;
    EXPECT_EQ(
        errors_of(plant.minimal().governor(16402, 2990)),
        "20:8 E0213 tpdo-parameter-unknown: 16402 Assign(2) is 2990, which no catalogue knows; the governor "
        "leaves out what it cannot send (manual 7.1.2.2)\n"
        "  help: if the governor has it as an analogue value, declare it with its width and sign:\n"
        "[[governor.declare]]\n"
        "number = 2990\n"
        "name = \"Measurement2990\"\n"
        "kind = \"measurement\"\n"
        "width = 16\n"
        "signed = false\n");
}

TEST(Outputs, have_a_known_width) {
    PlantBuilder plant;
    const std::string text = errors_of(plant.minimal().governor(16451, 2503));
    EXPECT_EQ(
        text.find(
            "20:8 E0213 tpdo-parameter-unknown: 16451 Assign(51) is 2503 Unmeasured, whose width is not "
            "known;"),
        0U)
        << text;
    EXPECT_NE(text.find("name = \"Unmeasured\""), std::string::npos) << text;
}

TEST(Outputs, are_no_single_bits) {
    PlantBuilder plant;
    EXPECT_EQ(
        errors_of(plant.minimal().governor(16400, 3070)),
        "20:8 E0214 tpdo-parameter-bit: 16400 Assign(0) is 3070 ErrCanBus, a single bit, which a TPDO cannot "
        "carry (manual 4.1.2)\n"
        "  help: error bits travel in TPDO1 and TPDO2: write 14401 = 1\n");
    EXPECT_EQ(
        errors_of(plant.governor(16400, 12411)),
        "21:8 E0214 tpdo-parameter-bit: 16400 Assign(0) is 12411 CanOpDCResetErr, a single bit, which a TPDO "
        "cannot carry (manual 4.1.2)\n");
}

TEST(CheckTable, has_one_row_for_every_rule_of_the_plant) {
    std::set<const diagnostic::Rule*> checked_rules;
    for (const Check& row : all_checks()) {
        EXPECT_TRUE(checked_rules.insert(row.rule).second) << row.rule->code;
    }
    for (const diagnostic::Rule* rule : diagnostic::all_rules()) {
        const bool about_plants = rule->code >= "E0200" && rule->code < "E0500";  // E05: tables, copies
        if (about_plants) {
            EXPECT_EQ(checked_rules.count(rule), 1U) << rule->code;
        }
    }
}

TEST(CheckTable, gives_no_finding_for_settings_that_say_nothing_at_all) {
    PlantBuilder plant;
    plant.settings().governor_table = {};
    plant.settings().gateway_table = {};
    EXPECT_EQ(test::checked(plant), "");
}

TEST(CheckTable, survives_values_that_fit_no_parameter) {
    for (const double value : {-1e300, -1.0, 0.5, 70000.0, 1e300}) {
        PlantBuilder plant;
        plant.minimal();
        for (const parameter::Row* row : plant.catalogue().rows(Device::governor)) {
            plant.governor(row->number, value);
        }
        for (const parameter::Row* row : plant.catalogue().rows(Device::gateway)) {
            plant.gateway(row->number, value);
        }
        EXPECT_EQ(errors_of(plant).find("E0206"), std::string::npos) << value;
    }
}

}  // namespace
}  // namespace cgw::check
