// The parameter file of the documentation, read with the catalogue that ships.
#include "catalogue/catalogue.hpp"
#include "input/support.hpp"
#include "support/golden.hpp"

namespace cgw {
namespace {

using test::Outcome;
using test::show;

Outcome read(std::string_view text) {
    return test::read(text, {}, catalogue::shipped_rows());
}

constexpr std::string_view documented = R"toml(#:schema ../schemas/parameter-file.schema.json
format = 1
title = "Genset 2, starboard"

[document]
created = 2026-03-01
author = "..."
revision = 2

[governor]
main_cycle_us = 15625
[governor.parameters]
401 = 1
CanCMNodeNumber = 1
416 = 250
"16460 CanOpTPDO4-16Cyc(0)" = 16
16400 = [2000, 2031, 2300, 2330]
CanOpTPDO16Assign = [2905, 2908, 2917]
ChanType_Setp1Ext = 3
[[governor.declare]]
number = 2990
name = "TorqueActual"
kind = "measurement"
unit = "%"
width = 16
signed = true
internal = [-32768, 32767]
external = [-100.0, 100.0]

[gateway]
identity = { software_version = 1, serial_date = 407, serial_number = 12 }
[gateway.parameters]
401 = 1
402 = 1
416 = 250
426 = 125
427 = 1
CanOpTPDO5-16ID = [0x282]

[network]
nodes = [2, 127]
)toml";

TEST(InputShipped, the_documented_file_is_fine) {
    const Outcome outcome = read(documented);
    EXPECT_EQ(show(outcome.findings), "fine");
    EXPECT_EQ(outcome.settings().governor.value(16403), 2330);
    EXPECT_EQ(outcome.settings().governor.value(16450), 2917);
    EXPECT_EQ(outcome.settings().governor.value(4900), 3);
    EXPECT_EQ(outcome.settings().gateway.value(16404), 0x282);
    ASSERT_EQ(outcome.settings().declarations.size(), 1U);
}

TEST(InputShipped, the_samples_are_fine) {
    for (const char* name : {"genset.toml", "manual-example.toml", "minimal.toml"}) {
        EXPECT_EQ(show(read(test::read_text(std::string(CGW_SAMPLES) + "/" + name)).findings), "fine")
            << name;
    }
}

TEST(InputShipped, one_wrong_letter_in_a_key_is_one_finding) {
    const std::string text(documented);
    for (const std::string_view word :
         {"CanCMNodeNumber", "CanOpTPDO16Assign", "main_cycle_us", "identity", "nodes"}) {
        std::string wrong = text;
        wrong[wrong.find(word) + word.size() / 2] = 'x';
        const Outcome outcome = read(wrong);
        EXPECT_EQ(outcome.findings.all().size(), 1U) << show(outcome.findings);
        EXPECT_NE(show(outcome.findings).find("did you mean"), std::string::npos) << show(outcome.findings);
    }
}

const std::string frame =
    "format = 1\ntitle = 't'\n[gateway.parameters]\n401 = 1\n402 = 1\n416 = 250\n426 = 125\n427 = 1\n"
    "[governor.parameters]\n401 = 1\n403 = 1\n";

// GWM 7.1.1 as printed (D2), and GWM 7.1.4.2 (D10).
TEST(InputShipped, the_manuals_examples_are_read_as_printed) {
    const Outcome outcome = read(frame +
                                 "\"400 CanStartTimeOutDelay\" = 1.0\n\"409 CanBaudrate\" = 250\n"
                                 "\"4406 CanCommCMOn\" = 1\n\"4409 CanSegmentOrBaudrate\" = 0\n"
                                 "\"4900 ChanType_Setp1Ext\" = 3\n\"4901 ChanType_Setp1Ext\" = 3\n"
                                 "\"16471 CanOpTPDO4-16Cyc (11)\" = 0\n\"835 FunctLoadEnable\" = -5\n");
    EXPECT_EQ(show(outcome.findings), "fine");
    EXPECT_EQ(outcome.settings().governor.value(416), 250);
    EXPECT_EQ(outcome.settings().governor.value(4901), 3);
    EXPECT_EQ(outcome.settings().governor.value(835), -5);
}

TEST(InputShipped, tpdo_assignments_run_to_16451_from_16400_only) {
    std::string values;
    for (int i = 16400; i <= 16451; ++i) {
        values += "0, ";
    }
    EXPECT_EQ(show(read(frame + "416 = 250\n16400 = [" + values + "]\n").findings), "fine");
    EXPECT_NE(show(read(frame + "416 = 250\n16400 = [" + values + "0]\n").findings).find("E0112"),
              std::string::npos);
    EXPECT_EQ(show(read(frame + "416 = 250\nCanOpTPDO4Assign = [" + values + "]\n").findings), "fine");
    EXPECT_EQ(show(read(frame + "416 = 250\n16404 = [0, 0, 0, 0]\n").findings), "fine");
    EXPECT_NE(show(read(frame + "416 = 250\n16404 = [0, 0, 0, 0, 0]\n").findings).find("E0112"),
              std::string::npos);
}

TEST(InputShipped, other_lists_end_with_their_array) {
    EXPECT_EQ(
        show(read(frame + "416 = 250\n16460 = [0,0,0,0,0,0,0,0,0,0,0,0,0]\n16480 = [0,0,0,0]\n").findings),
        "fine");
    EXPECT_NE(show(read(frame + "416 = 250\n16460 = [0,0,0,0,0,0,0,0,0,0,0,0,0,0]\n").findings)
                  .find("to 16472 are only 13"),
              std::string::npos);
    EXPECT_NE(show(read(frame + "416 = 250\n16480 = [0,0,0,0,0]\n").findings).find("to 16483 are only 4"),
              std::string::npos);
}

}  // namespace
}  // namespace cgw
