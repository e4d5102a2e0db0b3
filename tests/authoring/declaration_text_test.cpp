#include "authoring/declaration_text.hpp"

#include <gtest/gtest.h>

#include "catalogue/catalogue.hpp"

namespace cgw::authoring {
namespace {

using parameter::List;
using parameter::Role;
using parameter::Row;
using parameter::Scaling;

constexpr Row torque{
    .number = 2990, .name = "TorqueActual", .list = List::measurement, .unit = "%", .width = 16};

std::string with_scaling(const Scaling& scaling) {
    Row row = torque;
    row.unit = "";
    row.scaling = scaling;
    const std::string text = declaration_text(row);
    const std::string before =
        "\n[[governor.declare]]\nnumber = 2990\nname = \"TorqueActual\"\nkind = \"measurement\"\n"
        "width = 16\nsigned = false\n";
    EXPECT_TRUE(text.starts_with(before)) << text;
    return text.substr(std::min(before.size(), text.size()));
}

TEST(DeclarationText, of_a_measurement_has_all_its_cells) {
    Row row = torque;
    row.unit = "\"m³\"\\h";
    row.is_signed = true;
    row.scaling = Scaling{-32768, 32767, -100.0, 0.5, 0, 0};
    EXPECT_EQ(declaration_text(row),
              "\n[[governor.declare]]\n"
              "number = 2990\n"
              "name = \"TorqueActual\"\n"
              "kind = \"measurement\"\n"
              "unit = \"\\\"m³\\\"\\\\h\"\n"
              "width = 16\n"
              "signed = true\n"
              "internal = [-32768, 32767]\n"
              "external = [-100, 0.5]\n");
}

TEST(DeclarationText, leaves_out_cells_that_are_blank) {
    Row row = torque;
    row.unit = "";
    row.width = 0;
    EXPECT_EQ(declaration_text(row),
              "\n[[governor.declare]]\nnumber = 2990\nname = \"TorqueActual\"\nkind = \"measurement\"\n");
    EXPECT_EQ(with_scaling({0, 0, std::nullopt, std::nullopt, 0, 0}), "");
    EXPECT_EQ(with_scaling({0, 100, std::nullopt, std::nullopt, 0, 0}), "internal = [0, 100]\n");
    EXPECT_EQ(with_scaling({0, 0, 1.0, 2.0, 0, 0}), "external = [1, 2]\n");
    EXPECT_EQ(with_scaling({0, 0, 1.0, std::nullopt, 0, 0}), "") << "one end alone is not known to anybody";
    EXPECT_EQ(with_scaling({0, 0, std::nullopt, std::nullopt, 0, 981}), "");
}

TEST(DeclarationText, names_the_parameters_that_hold_the_ends_of_a_range) {
    EXPECT_EQ(with_scaling({0, 65535, std::nullopt, std::nullopt, 980, 981}),
              "internal = [0, 65535]\nexternal = [{ parameter = 980 }, { parameter = 981 }]\n");
    EXPECT_EQ(with_scaling({0, 65535, std::nullopt, 7.5, 980, 0}),
              "internal = [0, 65535]\nexternal = [{ parameter = 980 }, 7.5]\n");
}

TEST(DeclarationText, of_a_bit_says_so_and_no_width) {
    Row row = torque;
    row.unit = "";
    row.width = 1;
    EXPECT_EQ(declaration_text(row),
              "\n[[governor.declare]]\nnumber = 2990\nname = \"TorqueActual\"\nkind = \"measurement\"\n"
              "bit = true\n");
}

TEST(DeclarationText, of_switches_and_sensors_has_number_name_and_kind) {
    const Row rows[] = {
        {.number = 812, .name = "Own", .role = Role::switch_assignment},
        {.number = 4812, .name = "Own", .list = List::function, .role = Role::switch_type},
        {.number = 901, .name = "Own", .role = Role::sensor_assignment},
        {.number = 4901, .name = "Own", .list = List::function, .role = Role::sensor_type},
    };
    for (const Row& row : rows) {
        EXPECT_EQ(declaration_text(row), "\n[[governor.declare]]\nnumber = " + std::to_string(row.number) +
                                             "\nname = \"Own\"\nkind = \"" +
                                             (row.number % 4000 < 900 ? "switch" : "sensor") + "\"\n");
    }
}

// Known already: the row that ships says the rest.
TEST(DeclarationText, leaves_out_what_a_declaration_cannot_say) {
    const Row engine_stop{.number = 810, .name = "StopImpulseOrSwitch", .role = Role::switch_assignment};
    EXPECT_EQ(declaration_text(engine_stop),
              "\n[[governor.declare]]\nnumber = 810\nname = \"StopImpulseOrSwitch\"\n");
    const parameter::Catalogue shipped(catalogue::shipped_rows());
    const Row* element = shipped.find(parameter::Device::governor, 16401);
    ASSERT_NE(element, nullptr);
    ASSERT_EQ(element->name.back(), ')');
    EXPECT_EQ(declaration_text(*element), "\n[[governor.declare]]\nnumber = 16401\n");
    EXPECT_EQ(declaration_text(Row{.number = 820, .role = Role::switch_assignment}),
              "\n[[governor.declare]]\nnumber = 820\nkind = \"switch\"\n");
}

}  // namespace
}  // namespace cgw::authoring
