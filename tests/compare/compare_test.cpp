// What two configurations differ in, as a reader of `cgw diff` sees it.
#include "compare/compare.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <memory>

#include "catalogue/catalogue.hpp"
#include "input/parameter_file.hpp"

namespace cgw::compare {
namespace {

struct Plant {
    std::unique_ptr<parameter::Catalogue> catalogue;
    parameter::Settings settings;
    config::Configuration configuration;

    Side side() const { return {settings, configuration, *catalogue}; }
};

Plant plant(const std::string& top, const std::string& governor, const std::string& gateway,
            const std::string& gateway_communication = "1") {
    Plant made;
    made.catalogue = std::make_unique<parameter::Catalogue>(catalogue::shipped_rows());
    diagnostic::Findings findings;
    const std::string text = fmt::format(
        "format = 1\n{}\n[governor]\n[governor.parameters]\n401 = 1\n403 = 1\n416 = 250\n4406 = "
        "1\n{}\n[gateway]\n"
        "[gateway.parameters]\n401 = 1\n402 = 1\n416 = 250\n4400 = {}\n426 = 125\n{}\n",
        top, governor, gateway_communication, gateway);
    const auto load = [](const std::string& name) -> base::Result<std::string> {
        return base::failure("cannot read " + name);
    };
    input::ReadResult read = input::read_parameter_file(text, "f.toml", *made.catalogue, load, findings);
    EXPECT_TRUE(findings.all().empty()) << findings.all()[0].message;
    made.settings = std::move(read.file.settings);
    made.configuration = config::resolve(made.settings, *made.catalogue);
    return made;
}

const std::string base_governor = "16400 = [2000, 2031, 2300, 2905]\n16460 = [125]\n";

// The consequences between two governors, one a line.
std::string consequences(const std::string& governor_a, const std::string& governor_b,
                         const std::string& gateway_a = "427 = 1", const std::string& gateway_b = "427 = 1") {
    const Plant a = plant("", governor_a, gateway_a);
    const Plant b = plant("", governor_b, gateway_b);
    std::string text;
    for (const Difference& difference : compare(a.side(), b.side()).consequences) {
        text += fmt::format("{} | {} | {} | {}\n", difference.kind, difference.subject, difference.a,
                            difference.b);
    }
    return text;
}

TEST(Compare, finds_nothing_between_equal_plants) {
    const Plant a = plant("title = \"x\"", base_governor, "427 = 1");
    const Plant b = plant("title = \"x\"", base_governor + "16461 = 0\n", "427 = 0x1");
    const Comparison comparison = compare(a.side(), b.side());
    EXPECT_TRUE(comparison.same());
    EXPECT_EQ(render_text(comparison, {{"a.toml"}, "01"}, {{"b.toml"}, "01"}),
              "A: a.toml\n   configuration 01\nB: b.toml\n   configuration 01\n\nNothing differs.\n");
}

TEST(Compare, says_which_words_of_a_pdo_moved) {
    EXPECT_EQ(consequences(base_governor, "16400 = [2000, 0, 2300, 2905]\n16460 = [125]\n"),
              "pdo-word | TPDO4 word 2 | 2031 SpeedSetp | 2300 ActPos, moved from word 3\n"
              "pdo-word | TPDO4 word 3 | 2300 ActPos | 2905 OilPressure, moved from word 4\n"
              "pdo-word | TPDO4 word 4 | 2905 OilPressure | nothing\n"
              "object | 2001h:2 | 2031 SpeedSetp | 2300 ActPos\n"
              "object | 2001h:3 | 2300 ActPos | 2905 OilPressure\n"
              "object | 2001h:4 | 2905 OilPressure | nothing\n");
}

TEST(Compare, says_which_pdo_appears_or_disappears) {
    const std::string fifth = base_governor + "16404 = 2907\n16461 = 200\n";
    EXPECT_EQ(consequences(base_governor, fifth, "427 = 1\n16404 = 0x681", "427 = 1\n16404 = 0x681"),
              "pdo | TPDO5 | inactive | 681h, 2 bytes, 187.5 ms\n");
    EXPECT_EQ(consequences("14401 = 1\n", "14401 = 0\n"),
              "pdo | TPDO1 | 181h, 8 bytes | inactive\npdo | TPDO2 | 281h, 4 bytes | inactive\n");
}

TEST(Compare, compares_times_as_the_devices_run_them) {
    EXPECT_EQ(consequences(base_governor, "16400 = [2000, 2031, 2300, 2905]\n16460 = [126]\n"), "");
    EXPECT_EQ(consequences(base_governor, "16400 = [2000, 2031, 2300, 2905]\n16460 = [150]\n"),
              "pdo-time | TPDO4 cycle | 125 ms | 140.625 ms\n");
}

TEST(Compare, follows_the_node_id_into_the_identifiers) {
    EXPECT_EQ(consequences(base_governor, base_governor, "427 = 1", "427 = 2"),
              "node-id | CANopen node id | 1 | 2\n"
              "node-identifier | SDO requests to the gateway | 601h | 602h\n"
              "node-identifier | SDO answers of the gateway | 581h | 582h\n"
              "node-identifier | boot-up and heartbeat identifier | 701h | 702h\npdo-identifier | TPDO4 "
              "identifier | 481h | 482h\n");
}

TEST(Compare, names_buses_and_heartbeats) {
    EXPECT_EQ(consequences("", "", "427 = 1\n429 = 800", "427 = 1\n428 = 9\n430 = 100\n4426 = 1\n420 = 3"),
              "bit-rate | CANopen bit rate | 125 kbit/s | by hand 3/0/0/0/0/0\n"
              "heartbeat | heartbeat sent | 800 ms | off\n"
              "heartbeat | heartbeat expected | off | node 9 within 96 ms\n");
}

TEST(Compare, names_switches_and_sensors) {
    const std::string received = "827 = 1\n4827 = 3\n900 = 1\n4900 = 3\n16480 = [500, 500]\n";
    EXPECT_EQ(consequences(received, "827 = -2\n4827 = 3\n900 = 2\n4900 = 3\n16480 = [500, 0]\n"),
              "pdo-time | RPDO2 monitoring | 500 ms | not monitored\n"
              "pdo-word | RPDO2 word 1 | 900 AssignIn_Setp1Ext | dummy\n"
              "pdo-word | RPDO2 word 2 | nothing | 900 AssignIn_Setp1Ext, moved from word 1\n"
              "switch | switch 827 FunctSetpoint2Or1 | RPDO1 bit 1 | RPDO1 bit 2, low-active\n"
              "sensor | sensor 900 AssignIn_Setp1Ext | RPDO2 word 1 | RPDO2 word 2\n");
    EXPECT_EQ(consequences(received, "900 = 1\n4900 = 3\n16480 = [500, 500]\n"),
              "pdo-word | RPDO1 word 1 | switch functions | dummy\n"
              "switch | switch 827 FunctSetpoint2Or1 | RPDO1 bit 1 | not over CANopen\n");
}

TEST(Compare, names_what_else_the_configuration_id_depends_on) {
    const Plant a = plant("title = \"one\"\n[network]\nnodes = [3, 2]", "", "427 = 1");
    const Plant b = plant("title = \"two\"",
                          "[[governor.declare]]\nnumber = 2990\nname = \"Torque\"\nkind = "
                          "\"measurement\"\nwidth = 16\nsigned = true\n",
                          "427 = 1");
    std::string text;
    for (const Difference& difference : compare(a.side(), b.side()).otherwise) {
        text += fmt::format("{} | {} | {} | {}\n", difference.kind, difference.subject, difference.a,
                            difference.b);
    }
    EXPECT_EQ(text,
              "title | title | \"one\" | \"two\"\n"
              "declaration | declared governor 2990 | nothing | \"Torque\" measurement 16 signed \"\"\n"
              "network | listed nodes | 2, 3 | none\n");
}

TEST(Compare, prints_parameters_and_consequences_within_80_columns) {
    const Plant a = plant("", base_governor, "427 = 1\n16415 = 0x57F");
    const Plant b = plant("", "16400 = [2000, 2031, 2905, 2300]\n16460 = [500]\n", "427 = 1\n16415 = 0x580");
    const std::string text = render_text(compare(a.side(), b.side()), {{"a.toml"}, "01"}, {{"b.toml"}, "02"});
    EXPECT_EQ(text,
              "A: a.toml\n   configuration 01\nB: b.toml\n   configuration 02\n"
              "\nParameters\n"
              "  governor 16402 CanOpTPDO4Assign(2)   2300 -> 2905\n"
              "  governor 16403 CanOpTPDO4Assign(3)   2905 -> 2300\n"
              "  governor 16460 CanOpTPDO4-16Cyc(0)   125 -> 500 ms\n"
              "  gateway  16415 CanOpTPDO5-16ID(11)   0x57F -> 0x580\n"
              "\nWhat follows\n"
              "  TPDO4 cycle                          125 ms -> 500 ms\n"
              "  TPDO4 word 3\n      2300 ActPos\n   -> 2905 OilPressure, moved from word 4\n"
              "  TPDO4 word 4\n      2905 OilPressure\n   -> 2300 ActPos, moved from word 3\n"
              "  2001h:3                              2300 ActPos -> 2905 OilPressure\n"
              "  2001h:4                              2905 OilPressure -> 2300 ActPos\n");
}

const std::string ambient = "16400 = [2000, 2906]\n16460 = [125]\n";

TEST(Compare, says_what_a_reference_parameter_does_to_a_word) {
    EXPECT_EQ(consequences(ambient + "984 = 500\n985 = 1200\n", ambient + "984 = 500\n985 = 2000\n"),
              "scaling | TPDO4 word 2 2906 AmbientPressure | 500..1200 mbar | 500..2000 mbar\n");
    EXPECT_EQ(consequences(ambient, ambient + "984 = 500\n985 = 2000\n"),
              "scaling | TPDO4 word 2 2906 AmbientPressure | not known | 500..2000 mbar\n");
}

TEST(Compare, says_what_a_reference_parameter_does_to_a_sensor) {
    const std::string sensor = "906 = 5\n4906 = 3\n984 = 500\n";
    EXPECT_EQ(consequences(sensor + "985 = 1200\n", sensor + "985 = 2000\n"),
              "scaling | RPDO3 word 1 906 AssignIn_AmbPress | 500..1200 mbar | 500..2000 mbar\n");
}

TEST(Compare, is_silent_about_the_scaling_of_words_that_nobody_carries) {
    EXPECT_EQ(consequences("984 = 500\n985 = 1200\n", "984 = 500\n985 = 2000\n"), "");
}

// A declared measurement in TPDO4 word 1.
std::string declared(const std::string& unit, bool is_signed, int internal, double external) {
    return fmt::format(
        "16400 = 2990\n16460 = 125\n[[governor.declare]]\nnumber = 2990\nname = \"Power\"\nkind = "
        "\"measurement\"\nunit = \"{}\"\nwidth = 16\nsigned = {}\ninternal = [0, {}]\nexternal = [0.0, "
        "{}]\n",
        unit, is_signed, internal, external);
}

TEST(Compare, says_what_a_declaration_does_to_a_word) {
    EXPECT_EQ(consequences(declared("kW", false, 1000, 12.5), declared("MW", false, 1000, 12.5)),
              "scaling | TPDO4 word 1 2990 Power | 0..12.5 kW | 0..12.5 MW\n");
    EXPECT_EQ(
        consequences(declared("kW", false, 1000, 12.5), declared("kW", false, 2000, 12.5)),
        "scaling | TPDO4 word 1 2990 Power | 0..12.5 kW for 0..1000, unsigned | 0..12.5 kW for 0..2000, "
        "unsigned\n");
    EXPECT_EQ(
        consequences(declared("kW", false, 1000, 12.5), declared("kW", true, 1000, 12.5)),
        "scaling | TPDO4 word 1 2990 Power | 0..12.5 kW for 0..1000, unsigned | 0..12.5 kW for 0..1000, "
        "signed\n"
        "object | 2001h:1 | 2990 Power | nothing\n");
}

TEST(Compare, says_when_the_two_devices_stop_talking) {
    const Plant on = plant("", "", "427 = 1");
    const Plant off = plant("", "", "427 = 1", "0");
    const Comparison comparison = compare(on.side(), off.side());
    ASSERT_EQ(comparison.consequences.size(), 1U);
    EXPECT_EQ(comparison.consequences[0].kind, "communication");
    EXPECT_EQ(comparison.consequences[0].b, "off: governor and gateway exchange nothing");
}

TEST(Compare, shows_a_few_of_many_objects_that_changed) {
    const Plant a =
        plant("", "16400 = [2000, 2031, 2300, 2904]\n16404 = [2905, 2907, 2908]\n16460 = [125, 125]",
              "427 = 1\n16404 = 0x681");
    const Plant b = plant("", "16400 = [2031, 2300, 2904, 0]\n16404 = [2905, 2907, 2908]\n16460 = [125, 125]",
                          "427 = 1\n16404 = 0x681");
    const Comparison comparison = compare(a.side(), b.side());
    const std::string text = render_text(comparison, {{"a"}, "01"}, {{"b"}, "02"});
    EXPECT_NE(text.find("  2001h:4                              2904 "), std::string::npos) << text;
    EXPECT_EQ(text.find("  2001h:5"), std::string::npos) << text;
    EXPECT_TRUE(text.ends_with("\n  and 3 more sub-indexes of 2001h and 2002h\n")) << text;
    const std::string json = render_json(comparison, {{"a"}, "01"}, {{"b"}, "02"});
    EXPECT_NE(json.find("2001h:7"), std::string::npos);
}

TEST(Compare, names_the_numbers_that_tables_leave_out) {
    const Plant a = plant("", "", "427 = 1");
    std::set<std::uint16_t> printed;
    for (const parameter::Row* row : a.catalogue->rows(parameter::Device::gateway)) {
        if (row->number != 428 && row->number != 429 && row->number != 16415) {
            printed.insert(row->number);
        }
    }
    Comparison comparison = compare(a.side(), a.side());
    comparison.not_printed = ranges_not_printed(*a.catalogue, parameter::Device::gateway, printed);
    EXPECT_EQ(render_text(comparison, {{"a"}, ""}, {{"t"}, ""}),
              "A: a\nB: t\n\nAll parameters that the tables print are the same.\n"
              "\nNot in the tables, taken as in A: 3 parameters\n  gateway  428..429, 16415\n");
}

}  // namespace
}  // namespace cgw::compare
