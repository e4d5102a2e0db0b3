#include "parameter/catalogue.hpp"

#include <gtest/gtest.h>

#include <array>

namespace {

using cgw::parameter::array_name;
using cgw::parameter::Catalogue;
using cgw::parameter::Device;
using cgw::parameter::List;
using cgw::parameter::Row;

constexpr std::string_view aliases[] = {"SegmentOrBaudrate"};
constexpr std::string_view misprints[] = {"409 Baudrate"};
constexpr std::string_view swapped[] = {"418 First"};
constexpr std::uint32_t choices[] = {125, 250};

constexpr Row rows[] = {
    {.number = 416, .name = "Baudrate", .misprints = misprints, .choices = choices},
    {.number = 417, .name = "First"},
    {.number = 418, .name = "Second", .misprints = swapped},
    {.number = 812},
    {.number = 2000, .name = "Speed", .list = List::measurement},
    {.number = 16460, .name = "Cyc(0)", .array_first = 16460, .array_size = 2, .list_end = 16461},
    {.number = 16461, .name = "Cyc(1)", .array_first = 16460, .array_size = 2, .list_end = 16461},
    {.device = Device::gateway, .number = 416, .name = "HzmBaudrate"},
    {.device = Device::gateway, .number = 4416, .name = "SegmOrBaudrate", .aliases = aliases},
};

class CatalogueTest : public testing::Test {
  protected:
    const Row* find(std::uint16_t number) const { return catalogue.find(Device::governor, number); }
    const Row* find(std::string_view name) const { return catalogue.find(Device::governor, name); }

    Catalogue catalogue{rows};
};

using CatalogueLookup = CatalogueTest;
using CatalogueMisprint = CatalogueTest;
using CataloguePut = CatalogueTest;

TEST_F(CatalogueLookup, finds_by_device_and_number) {
    EXPECT_EQ(find(416)->name, "Baudrate");
    EXPECT_EQ(catalogue.find(Device::gateway, std::uint16_t{416})->name, "HzmBaudrate");
    EXPECT_EQ(find(419), nullptr);
    EXPECT_EQ(find(0), nullptr);
    EXPECT_EQ(find(65535), nullptr);
}

TEST_F(CatalogueLookup, finds_by_name_in_any_case) {
    EXPECT_EQ(find("Baudrate")->number, 416);
    EXPECT_EQ(find("bAUDRATE")->number, 416);
    EXPECT_EQ(find("Baudrates"), nullptr);
    EXPECT_EQ(find("Baudrat"), nullptr);
    EXPECT_EQ(find("HzmBaudrate"), nullptr);  // the other device's
}

TEST_F(CatalogueLookup, does_not_find_rows_without_a_name_by_an_empty_one) {
    EXPECT_EQ(find(""), nullptr);
}

TEST_F(CatalogueLookup, ignores_blanks_before_a_bracket_only) {
    EXPECT_EQ(find("Cyc(1)")->number, 16461);
    EXPECT_EQ(find("Cyc  (1)")->number, 16461);
    EXPECT_EQ(find("Cyc( 1)"), nullptr);
    EXPECT_EQ(find("Baud rate"), nullptr);
    EXPECT_EQ(find("Baudrate "), nullptr);
}

TEST_F(CatalogueLookup, takes_an_array_without_index_as_element_0) {
    EXPECT_EQ(find("Cyc")->number, 16460);
    EXPECT_EQ(find("Cyc(2)"), nullptr);
    EXPECT_EQ(array_name(*find("Cyc(1)")), "Cyc");
    EXPECT_EQ(array_name(*find("Baudrate")), "Baudrate");
}

TEST_F(CatalogueLookup, finds_by_alias) {
    EXPECT_EQ(catalogue.find(Device::gateway, "segmentOrBaudrate")->number, 4416);
}

TEST_F(CatalogueLookup, lists_rows_in_ascending_order) {
    const auto& governor = catalogue.rows(Device::governor);
    ASSERT_EQ(governor.size(), 7U);
    EXPECT_EQ(governor.front()->number, 416);
    EXPECT_EQ(governor.back()->number, 16461);
    EXPECT_EQ(catalogue.rows(Device::gateway).size(), 2U);
}

TEST_F(CatalogueLookup, suggests_settable_names_and_arrays) {
    const std::vector<std::string_view> expected = {"Baudrate", "First", "Second", "Cyc", "Cyc(0)", "Cyc(1)"};
    EXPECT_EQ(catalogue.names(Device::governor), expected);
}

TEST_F(CatalogueMisprint, resolves_number_with_name_and_bare_number) {
    EXPECT_EQ(catalogue.find_misprint(Device::governor, 409, "BAUDRATE")->number, 416);
    EXPECT_EQ(catalogue.find_misprint(Device::governor, 409, "")->number, 416);
}

TEST_F(CatalogueMisprint, is_none_for_another_name_number_or_device) {
    EXPECT_EQ(catalogue.find_misprint(Device::governor, 409, "First"), nullptr);
    EXPECT_EQ(catalogue.find_misprint(Device::governor, 408, "Baudrate"), nullptr);
    EXPECT_EQ(catalogue.find_misprint(Device::gateway, 409, ""), nullptr);
}

TEST_F(CatalogueMisprint, of_a_number_with_its_own_row_needs_the_name) {
    EXPECT_EQ(catalogue.find_misprint(Device::governor, 418, "First")->number, 418);
    EXPECT_EQ(catalogue.find_misprint(Device::governor, 418, ""), nullptr);
}

TEST_F(CataloguePut, copies_every_text_and_list) {
    const Row* added = nullptr;
    {
        const std::string name = "TorqueActualWithALongName";
        const std::string unit = "a unit that is longer than a small string";
        const std::array<std::string, 1> texts = {"another name that is quite long"};
        const std::array<std::string_view, 1> list = {texts[0]};
        const std::array<std::uint32_t, 2> numbers = {1, 2};
        added =
            catalogue.put({.number = 2990, .name = name, .aliases = list, .choices = numbers, .unit = unit});
    }
    EXPECT_EQ(added->name, "TorqueActualWithALongName");
    EXPECT_EQ(added->unit, "a unit that is longer than a small string");
    ASSERT_EQ(added->aliases.size(), 1U);
    EXPECT_EQ(find("Another name that is quite long"), added);
    EXPECT_EQ(added->choices[1], 2U);
    EXPECT_EQ(find(2990), added);
    EXPECT_EQ(catalogue.rows(Device::governor)[5], added);  // between 2000 and 16460
}

TEST_F(CataloguePut, replaces_a_row_with_its_names) {
    const Row* added = catalogue.put({.number = 417, .name = "Renamed"});
    EXPECT_EQ(find(417), added);
    EXPECT_EQ(find("Renamed"), added);
    EXPECT_EQ(find("First"), nullptr);
    EXPECT_EQ(catalogue.rows(Device::governor).size(), 7U);
    EXPECT_EQ(catalogue.find(Device::gateway, std::uint16_t{416})->name, "HzmBaudrate");
}

TEST_F(CataloguePut, keeps_a_replaced_row_with_the_same_name_findable) {
    const Row* added = catalogue.put({.number = 417, .name = "First", .unit = "%"});
    EXPECT_EQ(find("first"), added);
    EXPECT_EQ(find("first")->unit, "%");
}

TEST_F(CataloguePut, lets_the_first_of_two_rows_keep_the_name) {
    catalogue.put({.number = 900, .name = "baudrate"});
    EXPECT_EQ(find("Baudrate")->number, 416);
}

TEST_F(CataloguePut, lists_what_was_added_once_in_order) {
    EXPECT_TRUE(catalogue.added().empty());
    catalogue.put({.device = Device::gateway, .number = 417, .name = "G"});
    catalogue.put({.number = 2990, .name = "Torque"});
    catalogue.put({.number = 812, .name = "FunctDroop"});
    const Row* latest = catalogue.put({.number = 2990, .name = "Torque", .unit = "%"});
    const std::vector<const Row*> added = catalogue.added();
    ASSERT_EQ(added.size(), 3U);
    EXPECT_EQ(added[0]->number, 812);
    EXPECT_EQ(added[1], latest);
    EXPECT_EQ(added[2]->number, 417);
}

TEST_F(CataloguePut, may_add_a_row_that_lives_in_the_catalogue) {
    const Row copy = *find("Baudrate");
    const Row* added = catalogue.put(copy);
    EXPECT_EQ(added->choices.size(), 2U);
    EXPECT_EQ(catalogue.find_misprint(Device::governor, 409, ""), added);
}

}  // namespace
