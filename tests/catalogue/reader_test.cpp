// Catalogue files: what they add, what they fill, what contradicts.
#include "catalogue/read_catalogue.hpp"

namespace {

using cgw::parameter::Base;
using cgw::parameter::Device;
using cgw::parameter::List;
using cgw::parameter::Role;
using cgw::parameter::Row;
using cgw::test::governor;
using cgw::test::torque;

using ReadCatalogue = cgw::test::ReadCatalogue;

TEST_F(ReadCatalogue, adds_a_measurement) {
    ASSERT_EQ(row(torque + "unit = \"%\"\nwidth = 16\nsigned = true\ninternal = [-32768, 32767]\n"
                           "external = [-100.0, 100]\nlevel = 4\ntext = \"torque\"\nsection = \"DG 1\""),
              "");
    const Row* added = find(2990);
    ASSERT_NE(added, nullptr);
    EXPECT_EQ(added->name, "TorqueActual");
    EXPECT_EQ(added->list, List::measurement);
    EXPECT_EQ(added->unit, "%");
    EXPECT_EQ(added->width, 16);
    EXPECT_TRUE(added->is_signed);
    EXPECT_EQ(added->level, 4);
    EXPECT_EQ(added->text, "torque");
    EXPECT_EQ(added->scaling->internal_minimum, -32768);
    EXPECT_EQ(added->scaling->external_maximum, 100.0);
}

TEST_F(ReadCatalogue, returns_true_only_without_findings) {
    EXPECT_TRUE(read(governor));
    EXPECT_TRUE(read(governor + "profile = \"digital-governor\"\n"));
    EXPECT_FALSE(read(governor + "[[row]]\nnumber = 0\n"));
    EXPECT_FALSE(read("device = \n"));
}

TEST_F(ReadCatalogue, wants_a_range_that_hexadecimal_digits_can_show) {
    const std::string text = file(
        governor + "[[row]]\nnumber = 4000\nname = \"Droop\"\nkind = \"function\"\nbase = \"hexadecimal\"\n");
    EXPECT_NE(text.find("4000 is hexadecimal: its range lies within 0..0xFFFFFFFF"), std::string::npos)
        << text;
}

TEST_F(ReadCatalogue, adds_settable_rows_of_every_list) {
    ASSERT_EQ(
        file(governor +
             "[[row]]\nnumber = 1\nname = \"TeethPickUp1\"\nkind = \"parameter\"\nrange = [1, 400]\n"
             "[[row]]\nnumber = 4000\nname = \"Droop\"\nkind = \"function\"\nbase = \"hexadecimal\"\n"
             "range = [0, 255]\n"
             "[[row]]\nnumber = 6000\nname = \"Map\"\nkind = \"curve\"\nchoices = [1, 2]\ndecimal = true\n"),
        "");
    EXPECT_EQ(find(1)->list, List::parameter);
    EXPECT_EQ(find(1)->maximum, 400.0);
    EXPECT_EQ(find(4000)->list, List::function);
    EXPECT_EQ(find(4000)->base, Base::hexadecimal);
    EXPECT_EQ(find(6000)->choices.size(), 2U);
    EXPECT_TRUE(find(6000)->decimal);
}

TEST_F(ReadCatalogue, adds_rows_of_the_gateway) {
    ASSERT_EQ(
        file("device = \"gateway\"\n[[row]]\nnumber = 2500\nname = \"Extra\"\nkind = \"measurement\"\n"), "");
    ASSERT_NE(catalogue.find(Device::gateway, std::uint16_t{2500}), nullptr);
    EXPECT_EQ(find(2500), nullptr);
}

TEST_F(ReadCatalogue, expands_arrays) {
    ASSERT_EQ(row("number = 23720\nname = \"BitCollection\"\ncount = 2\nkind = \"measurement\"\nwidth = 16\n"
                  "signed = false\naliases = [\"Bits\"]\ntext = \"word {1}, {set} {x\""),
              "");
    EXPECT_EQ(find(23721)->name, "BitCollection(1)");
    EXPECT_EQ(find(23721)->array_first, 23720);
    EXPECT_EQ(find(23721)->array_size, 2);
    EXPECT_EQ(find(23720)->list_end, 23721);
    EXPECT_EQ(find(23721)->text, "word 2, {set} {x");
    EXPECT_EQ(catalogue.find(Device::governor, "bitcollection")->number, 23720);
    EXPECT_EQ(catalogue.find(Device::governor, "Bits(1)")->number, 23721);
}

TEST_F(ReadCatalogue, lets_the_first_element_alone_have_a_longer_list) {
    ASSERT_EQ(row("number = 7000\nname = \"Map\"\ncount = 2\nkind = \"curve\"\nlist_end = 7005"), "");
    EXPECT_EQ(find(7000)->list_end, 7005);
    EXPECT_EQ(find(7001)->list_end, 7001);
}

TEST_F(ReadCatalogue, expands_ranges_of_unnamed_rows) {
    ASSERT_EQ(row("number = 7000\nlast = 7002\nkind = \"parameter\"\ntext = \"value {10}\""), "");
    EXPECT_EQ(find(7002)->text, "value 12");
    EXPECT_EQ(find(7002)->name, "");
    EXPECT_EQ(find(7002)->array_first, 0);
    EXPECT_EQ(find(7003), nullptr);
}

TEST_F(ReadCatalogue, fills_blanks_of_shipped_rows) {
    ASSERT_EQ(row("number = 2918\nunit = \"kW\"\nexternal = [{ parameter = 992 }, { parameter = 993 }]"), "");
    EXPECT_EQ(find(2918)->name, "MeasuredPower");
    EXPECT_EQ(find(2918)->unit, "kW");
    EXPECT_EQ(find(2918)->width, 16);
    EXPECT_EQ(find(2918)->scaling->external_maximum_parameter, 993);
    EXPECT_EQ(find(2918)->scaling->internal_maximum, 65535);
}

TEST_F(ReadCatalogue, replaces_texts_which_are_no_facts) {
    ASSERT_EQ(row("number = 2000\ntext = \"speed of the shaft\""), "");
    EXPECT_EQ(find(2000)->text, "speed of the shaft");
}

TEST_F(ReadCatalogue, may_repeat_what_is_known) {
    EXPECT_EQ(
        row("number = 2000\nname = \"Speed\"\nkind = \"measurement\"\nunit = \"1/min\"\nwidth = 16\n"
            "signed = false\nbit = false\ninternal = [0, 65535]\nexternal = [0, 4000]\nrange = [0, 4000]"),
        "");
}

TEST_F(ReadCatalogue, shows_both_values_of_a_contradiction) {
    EXPECT_EQ(row("number = 2000\nname = \"Rpm\""),
              "4:8 declaration-contradiction: `2000 Speed` has name \"Speed\" already, not \"Rpm\"\n");
    EXPECT_EQ(row("number = 2000\nkind = \"switch\""),
              "4:8 declaration-invalid: 2000 is no switch: its numbers are 810..849 and 4810..4849 of the "
              "governor\n");
    EXPECT_EQ(
        row("number = 2000\nkind = \"parameter\"\nunit = \"s\""),
        "4:8 declaration-contradiction: `2000 Speed` has kind \"measurement\" already, not \"parameter\"\n");
    EXPECT_EQ(row("number = 2000\nwidth = 8"),
              "4:9 declaration-contradiction: `2000 Speed` has width 16 already, not 8\n");
    EXPECT_EQ(row("number = 2000\nsigned = true"),
              "4:10 declaration-contradiction: `2000 Speed` has signed false already, not true\n");
    EXPECT_EQ(row("number = 2000\nbit = true"),
              "4:7 declaration-contradiction: `2000 Speed` has bit false already, not true\n");
    EXPECT_EQ(row("number = 2828\nbit = false"),
              "4:7 declaration-contradiction: `2828 SwitchErrorReset` has bit true already, not false\n");
    EXPECT_EQ(
        row("number = 2000\ninternal = [0, 4000]"),
        "4:12 declaration-contradiction: `2000 Speed` has internal [0, 65535] already, not [0, 4000]\n");
    EXPECT_EQ(row("number = 2905\nexternal = [0, 16]"),
              "4:12 declaration-contradiction: `2905 OilPressure` has external [{ parameter = 980 }, "
              "{ parameter = 981 }] already, not [0, 16]\n");
    EXPECT_EQ(
        row("number = 401\nrange = [1, 15]"),
        "4:9 declaration-contradiction: `401 CanMyNodeNumber` has range [1, 31] already, not [1, 15]\n");
    EXPECT_EQ(row("number = 416\nchoices = [125]"),
              "4:11 declaration-contradiction: `416 CanBaudrate` has choices [125, 250, 500, 1000] already, "
              "not [125]\n");
    EXPECT_EQ(row("number = 401\nbase = \"hexadecimal\""),
              "4:8 declaration-contradiction: `401 CanMyNodeNumber` has base \"decimal\" already, not "
              "\"hexadecimal\"\n");
    EXPECT_EQ(row("number = 401\ndecimal = true"),
              "4:11 declaration-contradiction: `401 CanMyNodeNumber` has decimal false already, not true\n");
    EXPECT_EQ(find(2000)->unit, "1/min");
    EXPECT_EQ(find(401)->maximum, 31.0);
}

TEST_F(ReadCatalogue, contradicts_what_an_earlier_file_filled) {
    ASSERT_EQ(row("number = 812\nname = \"FunctDroop2Or1\""), "");
    EXPECT_EQ(row("number = 812\nname = \"FunctOther\""),
              "4:8 declaration-contradiction: `812 FunctDroop2Or1` has name \"FunctDroop2Or1\" already, not "
              "\"FunctOther\"\n");
    EXPECT_EQ(find(812)->role, Role::switch_assignment);
}

}  // namespace
