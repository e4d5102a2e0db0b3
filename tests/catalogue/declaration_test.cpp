// [[governor.declare]]: what a parameter file may say about its governor, good and bad (D13).
#include <gtest/gtest.h>

#include <string>

#include "catalogue/catalogue.hpp"
#include "catalogue/findings_text.hpp"
#include "parameter/catalogue.hpp"
#include "toml/document.hpp"

namespace {

using cgw::parameter::Catalogue;
using cgw::parameter::Device;
using cgw::parameter::List;
using cgw::parameter::Role;
using cgw::parameter::Row;

class Declaration : public testing::Test {
  protected:
    // Cells start in line 2. `row` is what the reader returned.
    std::string declare(const std::string& cells) {
        findings = {};
        const auto document = cgw::toml::parse("[[declare]]\n" + cells + "\n", "plant.toml", findings);
        if (document) {
            row = cgw::catalogue::read_declaration(document->find("declare")->value.elements[0], "plant.toml",
                                                   catalogue, findings);
        }
        return cgw::test::findings_text(findings);
    }

    Catalogue catalogue{cgw::catalogue::shipped_rows()};
    cgw::diagnostic::Findings findings;
    const Row* row = nullptr;
};

TEST_F(Declaration, of_the_contract_is_read) {
    ASSERT_EQ(
        declare("number = 2990\nname = \"TorqueActual\"\nkind = \"measurement\"\nunit = \"%\"\nwidth = 16\n"
                "signed = true\ninternal = [-32768, 32767]\nexternal = [-100.0, 100.0]"),
        "");
    ASSERT_NE(row, nullptr);
    EXPECT_EQ(row->device, Device::governor);
    EXPECT_EQ(row->number, 2990);
    EXPECT_EQ(row->name, "TorqueActual");
    EXPECT_EQ(row->list, List::measurement);
    EXPECT_EQ(row->unit, "%");
    EXPECT_EQ(row->width, 16);
    EXPECT_TRUE(row->is_signed);
    EXPECT_EQ(row->scaling->internal_minimum, -32768);
    EXPECT_EQ(row->scaling->external_minimum, -100.0);
    EXPECT_EQ(catalogue.find(Device::governor, "torqueactual"), row);
}

TEST_F(Declaration, outlives_the_text_it_was_read_from) {
    ASSERT_EQ(declare("number = 2990\nname = \"AQuiteLongNameThatIsNotStoredInPlace\"\nkind = "
                      "\"measurement\"\nbit = true"),
              "");
    EXPECT_EQ(row->name, "AQuiteLongNameThatIsNotStoredInPlace");
    EXPECT_TRUE(row->is_bit());
}

TEST_F(Declaration, names_switches_and_sensors) {
    ASSERT_EQ(declare("number = 812\nname = \"FunctDroop2Or1\"\nkind = \"switch\""), "");
    EXPECT_EQ(row->role, Role::switch_assignment);
    EXPECT_EQ(row->minimum, -32768.0);
    EXPECT_NE(row->text, "");
    ASSERT_EQ(declare("number = 4812\nname = \"Type_Droop2Or1\"\nkind = \"switch\""), "");
    EXPECT_EQ(row->role, Role::switch_type);
    ASSERT_EQ(declare("number = 905\nname = \"AssignIn_OilPressure\"\nkind = \"sensor\""), "");
    EXPECT_EQ(row->role, Role::sensor_assignment);
    ASSERT_EQ(declare("number = 4905\nname = \"ChanType_OilPressure\"\nkind = \"sensor\""), "");
    EXPECT_EQ(row->role, Role::sensor_type);
}

TEST_F(Declaration, fills_the_blanks_of_a_known_measurement) {
    ASSERT_EQ(declare("number = 2350\nunit = \"mm³/str\"\nexternal = [0, 500]"), "");
    EXPECT_EQ(row->name, "FuelQuantity");
    EXPECT_EQ(row->unit, "mm³/str");
    EXPECT_EQ(row->width, 16);
    EXPECT_EQ(row->scaling->external_maximum, 500.0);
    EXPECT_EQ(row->scaling->internal_maximum, 65535);
    ASSERT_EQ(declare("number = 2919\nunit = \"kW\"\nexternal = [{ parameter = 994 }, { parameter = 995 }]"),
              "");
    EXPECT_EQ(row->scaling->external_minimum_parameter, 994);
}

TEST_F(Declaration, contradicting_the_catalogue_shows_both_values) {
    EXPECT_EQ(declare("number = 2917\nname = \"AsymmetricLoad\"\nkind = \"measurement\""),
              "3:8 declaration-contradiction: `2917 CurrentLoad` has name \"CurrentLoad\" already, not "
              "\"AsymmetricLoad\"\n");
    EXPECT_EQ(row, nullptr);
    EXPECT_EQ(catalogue.find(Device::governor, std::uint16_t{2917})->name, "CurrentLoad");
}

TEST_F(Declaration, of_one_number_twice_may_not_differ) {
    const std::string first = "number = 2990\nname = \"Torque\"\nkind = \"measurement\"\nwidth = 16\n";
    ASSERT_EQ(declare(first + "signed = true"), "");
    EXPECT_EQ(declare(first + "signed = true"), "");
    EXPECT_EQ(declare(first + "signed = false"),
              "6:10 declaration-contradiction: `2990 Torque` has signed true already, not false\n");
}

TEST_F(Declaration, says_which_kind_it_is) {
    EXPECT_EQ(declare("number = 2990\nname = \"Torque\"\nwidth = 16\nsigned = true"),
              "1:1 key-missing: `kind` of 2990 is missing\n");
    EXPECT_EQ(declare("number = 7000\nname = \"Other\"\nkind = \"parameter\""),
              "4:8 key-value: a declaration's kind is measurement, switch or sensor, not parameter\n");
    EXPECT_EQ(declare("number = 7001\nname = \"Other2\"\nkind = \"valve\""),
              "4:8 key-value: unknown kind `valve`\n");
}

TEST_F(Declaration, of_a_switch_or_sensor_has_one_of_its_numbers) {
    EXPECT_EQ(declare("number = 930\nname = \"AssignIn_X\"\nkind = \"sensor\""),
              "4:8 declaration-invalid: 930 is no sensor: its numbers are 900..929 and 4900..4929 of the "
              "governor\n");
    EXPECT_EQ(declare("number = 905\nname = \"AssignIn_Y\"\nkind = \"switch\""),
              "4:8 declaration-invalid: 905 is no switch: its numbers are 810..849 and 4810..4849 of the "
              "governor\n");
    EXPECT_EQ(
        declare("number = 905\nname = \"AssignIn_Y\"\nkind = \"measurement\"\nbit = true"),
        "4:8 declaration-contradiction: `905 AssignIn_Y` has kind \"sensor\" already, not \"measurement\"\n");
}

TEST_F(Declaration, cannot_rename_the_engine_stop) {
    EXPECT_EQ(declare("number = 810\nkind = \"switch\"\nname = \"FunctEngineStop\""),
              "2:10 declaration-invalid: 810 is the engine stop, which is known and cannot be declared\n");
    EXPECT_EQ(declare("number = 4810\nkind = \"switch\"\nname = \"Type_EngineStop\""),
              "2:10 declaration-invalid: 4810 is the engine stop, which is known and cannot be declared\n");
    EXPECT_EQ(row, nullptr);
}

TEST_F(Declaration, of_a_switch_without_a_name_says_nothing) {
    EXPECT_EQ(declare("number = 812\nkind = \"switch\""), "1:1 key-missing: `name` of 812 is missing\n");
}

TEST_F(Declaration, knows_no_cells_of_catalogue_files) {
    EXPECT_EQ(declare("number = 812\nkind = \"switch\"\nname = \"FunctX\"\nlevel = 6\ncount = 2"),
              "5:1 key-unknown: unknown key `level`\n"
              "6:1 key-unknown: unknown key `count`\n");
}

TEST_F(Declaration, of_a_measurement_needs_width_and_sign) {
    EXPECT_EQ(declare("number = 2990\nname = \"Torque\"\nkind = \"measurement\""),
              "1:1 key-missing: `width` of 2990 is missing\n");
    EXPECT_EQ(declare("number = 2991\nname = \"Torque2\"\nkind = \"measurement\"\nwidth = 16"),
              "1:1 key-missing: `signed` of 2991 is missing\n");
    EXPECT_EQ(
        declare("number = 2992\nname = \"Torque3\"\nkind = \"measurement\"\nwidth = 16\nsigned = false\n"
                "internal = [-100, 100]"),
        "7:12 declaration-invalid: internal [-100, 100] does not fit 16 bits, unsigned\n");
    EXPECT_EQ(row, nullptr);
}

TEST_F(Declaration, after_a_finding_is_known_all_the_same) {
    EXPECT_NE(declare("number = 2990\nname = \"Torque\"\nkind = \"measurement\"\nunit = 5"), "");
    EXPECT_EQ(row, nullptr);
    const Row* known = catalogue.find(Device::governor, std::uint16_t{2990});
    ASSERT_NE(known, nullptr);
    EXPECT_EQ(known->list, List::measurement);
    EXPECT_NE(known->width, 0);
}

TEST_F(Declaration, refers_to_settable_parameters_only) {
    EXPECT_EQ(declare("number = 2919\nunit = \"kW\"\nexternal = [{ parameter = 994 }, { parameter = 999 }]"),
              "4:48 declaration-invalid: 999 is no settable parameter of the governor\n");
    EXPECT_EQ(row, nullptr);
}

TEST_F(Declaration, has_a_number) {
    EXPECT_EQ(declare("name = \"Torque\"\nkind = \"measurement\"\nbit = true"),
              "1:1 key-missing: `number` is missing\n");
    EXPECT_EQ(declare("number = 40000\nkind = \"measurement\""),
              "2:10 declaration-invalid: number 40000 is outside 1..29999\n");
}

}  // namespace
