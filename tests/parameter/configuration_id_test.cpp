#include <gtest/gtest.h>

#include "base/sha256.hpp"
#include "parameter/settings.hpp"

namespace {

using cgw::parameter::canonical_text;
using cgw::parameter::configuration_id;
using cgw::parameter::Device;
using cgw::parameter::List;
using cgw::parameter::Role;
using cgw::parameter::Row;
using cgw::parameter::Scaling;
using cgw::parameter::Settings;

constexpr Row node{.number = 401, .name = "CanMyNodeNumber"};
constexpr Row delay{.number = 400, .name = "CanStartTimeOutDelay"};
constexpr Row identifier{.device = Device::gateway, .number = 16404, .name = "CanOpTPDO5-16ID(0)"};
constexpr Row torque{.number = 2990,
                     .name = "TorqueActual",
                     .list = List::measurement,
                     .unit = "%",
                     .width = 16,
                     .is_signed = true,
                     .scaling = Scaling{-32768, 32767, -100.0, 100.0, 0, 0},
                     .text = "not part of the model"};

Settings plant() {
    Settings settings;
    settings.title = "Genset \"2\"";
    settings.identity = {12, 407, 13};
    settings.governor.assign({.row = &node, .value = 1, .spelling = "401"});
    settings.governor.assign({.row = &delay, .value = 0.5});
    settings.gateway.assign({.row = &identifier, .value = 0x282, .decimal_typed = true});
    settings.declarations = {&torque};
    return settings;
}

TEST(CanonicalText, holds_the_whole_model_one_fact_a_line) {
    EXPECT_EQ(canonical_text(plant()),
              "cgw-configuration 1\n"
              "title \"Genset \\\"2\\\"\"\n"
              "identity 12 407 13\n"
              "main-cycle-us 15625\n"
              "row governor 2990 \"TorqueActual\" measurement 16 signed \"%\" -32768..32767 -100..100\n"
              "governor 400 0.5\n"
              "governor 401 1\n"
              "gateway 16404 642\n");
}

TEST(CanonicalText, shows_references_blanks_and_roles_of_declared_rows) {
    const Row power{.number = 2918,
                    .name = "MeasuredPower",
                    .list = List::measurement,
                    .unit = "kW",
                    .width = 16,
                    .scaling = Scaling{0, 65535, std::nullopt, std::nullopt, 992, 0}};
    const Row function{.number = 812, .name = "FunctDroop", .role = Role::switch_assignment};
    Settings settings;
    settings.declarations = {&power, &function};
    const std::string text = canonical_text(settings);
    EXPECT_NE(
        text.find("row governor 812 \"FunctDroop\" parameter switch\n"
                  "row governor 2918 \"MeasuredPower\" measurement 16 unsigned \"kW\" 0..65535 @992..?\n"),
        std::string::npos)
        << text;
}

TEST(CanonicalText, holds_the_latest_row_of_a_number_that_is_declared_twice) {
    const Row first{.number = 2990, .name = "TorqueActual", .list = List::measurement, .width = 16};
    Settings twice = plant();
    twice.declarations = {&first, &torque};
    EXPECT_EQ(canonical_text(twice), canonical_text(plant()));
}

TEST(CanonicalText, leaves_out_what_a_bootloader_means_by_a_number) {
    const Row boot{.program = cgw::parameter::Program::bootloader, .number = 2990, .name = "BootError"};
    Settings other = plant();
    other.declarations.push_back(&boot);
    EXPECT_EQ(canonical_text(other), canonical_text(plant()));
}

TEST(ConfigurationId, is_the_sha256_of_the_canonical_text) {
    const std::string text = canonical_text(plant());
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    EXPECT_EQ(configuration_id(plant()), cgw::base::sha256(bytes));
}

TEST(ConfigurationId, does_not_depend_on_order_spelling_or_base) {
    Settings other;
    other.title = plant().title;
    other.identity = plant().identity;
    other.declarations = {&torque};
    other.gateway.assign({.row = &identifier, .value = 642});
    other.governor.assign({.row = &delay, .value = 0.5, .spelling = "CanStartTimeOutDelay"});
    other.governor.assign({.row = &node, .value = 1, .spelling = "CANMYNODENUMBER"});
    EXPECT_EQ(configuration_id(other), configuration_id(plant()));
}

TEST(ConfigurationId, does_not_depend_on_zeros_document_and_network) {
    Settings other = plant();
    const Row off{.number = 403, .name = "CanCMNodeNumber"};
    other.governor.assign({.row = &off, .value = 0});
    other.document.author = "somebody";
    other.network_nodes.push_back({.node_id = 3, .where = {}});
    EXPECT_EQ(configuration_id(other), configuration_id(plant()));
}

TEST(ConfigurationId, changes_with_every_part_of_the_model) {
    const auto id = configuration_id(plant());
    Settings other = plant();
    other.title = "Genset 3";
    EXPECT_NE(configuration_id(other), id);
    other = plant();
    other.identity.serial_number = 14;
    EXPECT_NE(configuration_id(other), id);
    other = plant();
    other.main_cycle_us = 20000;
    EXPECT_NE(configuration_id(other), id);
    other = plant();
    other.declarations.clear();
    EXPECT_NE(configuration_id(other), id);
    other = plant();
    other.gateway.assign({.row = &node, .value = 1});
    EXPECT_NE(configuration_id(other), id);
}

TEST(ConfigurationId, tells_the_same_number_in_the_two_devices_apart) {
    Settings left;
    left.governor.assign({.row = &node, .value = 5});
    Settings right;
    right.gateway.assign({.row = &node, .value = 5});
    EXPECT_NE(configuration_id(left), configuration_id(right));
}

}  // namespace
