// Names, aliases and misprints of the shipped rows of both devices.
#include <gtest/gtest.h>

#include <cctype>
#include <set>
#include <string>
#include <tuple>

#include "catalogue/catalogue.hpp"
#include "parameter/catalogue.hpp"

namespace {

using cgw::parameter::Catalogue;
using cgw::parameter::Device;
using cgw::parameter::Row;

constexpr Device devices[] = {Device::governor, Device::gateway};

std::string lower(std::string_view text) {
    std::string result;
    for (const char c : text) {
        result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return result;
}

class ShippedLookup : public testing::Test {
  protected:
    int number(Device device, std::string_view name) const {
        const Row* row = catalogue.find(device, name);
        return row != nullptr ? row->number : 0;
    }
    int misprint(std::uint16_t typed, std::string_view name) const {
        const Row* row = catalogue.find_misprint(Device::governor, typed, name);
        return row != nullptr ? row->number : 0;
    }

    Catalogue catalogue{cgw::catalogue::shipped_rows()};
};

TEST_F(ShippedLookup, rows_are_sorted_by_device_program_and_number_without_repetition) {
    const auto rows = cgw::catalogue::shipped_rows();
    ASSERT_GT(rows.size(), 300U);
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const auto place = [](const Row& row) { return std::tuple(row.device, row.program, row.number); };
        EXPECT_LT(place(rows[i - 1]), place(rows[i])) << rows[i].number;
    }
}

TEST_F(ShippedLookup, every_row_has_text_and_section) {
    for (const Row& row : cgw::catalogue::shipped_rows()) {
        EXPECT_FALSE(row.text.empty()) << row.number;
        EXPECT_LE(row.text.size(), 140U) << row.number;
        EXPECT_EQ(row.text.find('{'), std::string_view::npos) << row.number << ": " << row.text;
        EXPECT_EQ(row.text.find('\n'), std::string_view::npos) << row.number;
        const bool cited = row.section.starts_with("GWM ") || row.section.starts_with("NAT ");
        EXPECT_TRUE(cited) << row.number << ": " << row.section;
    }
}

TEST_F(ShippedLookup, every_settable_row_has_a_range) {
    for (const Row& row : cgw::catalogue::shipped_rows()) {
        if (row.settable()) {
            ASSERT_TRUE(row.minimum && row.maximum) << row.number;
            EXPECT_LT(*row.minimum, *row.maximum) << row.number;
        }
    }
}

TEST_F(ShippedLookup, no_name_or_alias_is_used_twice_in_a_device) {
    for (const Device device : devices) {
        std::set<std::string> names;
        for (const Row* row : catalogue.rows(device)) {
            EXPECT_TRUE(row->name.empty() || names.insert(lower(row->name)).second) << row->name;
            for (const std::string_view alias : row->aliases) {
                EXPECT_TRUE(names.insert(lower(alias)).second) << alias;
            }
        }
    }
}

TEST_F(ShippedLookup, every_row_is_found_by_its_number_name_and_aliases) {
    for (const Row& row : cgw::catalogue::shipped_rows()) {
        EXPECT_EQ(catalogue.find(row.device, row.program, row.number), &row);
        EXPECT_TRUE(row.name.empty() || catalogue.find(row.device, row.program, row.name) == &row)
            << row.name;
        for (const std::string_view alias : row.aliases) {
            EXPECT_EQ(catalogue.find(row.device, row.program, alias), &row) << alias;
        }
    }
}

TEST_F(ShippedLookup, the_print_variants_of_D3_are_the_same_parameter) {
    EXPECT_EQ(number(Device::gateway, "HzmCanSegmOrBaudrate"), 4416);
    EXPECT_EQ(number(Device::gateway, "HzmCanSegmentOrBaudrate"), 4416);
    EXPECT_EQ(number(Device::gateway, "CanOpSegmOrBaudrate"), 4426);
    EXPECT_EQ(number(Device::gateway, "CanOpSegmentOrBaudrate"), 4426);
    EXPECT_EQ(number(Device::gateway, "CanOpSegmentOrBaurdate"), 4426);
    EXPECT_EQ(number(Device::gateway, "HzmCanCommDCOn"), 4400);
    EXPECT_EQ(number(Device::gateway, "HzmCanCommDCon"), 4400);
    EXPECT_EQ(number(Device::governor, "ChanType_Setp1Ext"), 4900);
    EXPECT_EQ(number(Device::governor, "ChanType_Setp1ext"), 4900);
    EXPECT_EQ(number(Device::governor, "CanOpTPDO4-16Cyc(11)"), 16471);
    EXPECT_EQ(number(Device::governor, "CanOpTPDO4-16Cyc (11)"), 16471);
}

TEST_F(ShippedLookup, an_ambiguous_print_of_the_synoptic_table_is_no_alias) {
    EXPECT_EQ(number(Device::gateway, "CanOpGWErrCanComm"), 0);  // D59
    EXPECT_EQ(number(Device::gateway, "CanOpGWErrCanComm1"), 12422);
    EXPECT_EQ(number(Device::gateway, "CanOpGWErrCanComm2"), 12424);
}

TEST_F(ShippedLookup, the_misprints_of_D2_and_D10_resolve_as_such_only) {
    EXPECT_EQ(catalogue.find(Device::governor, std::uint16_t{409}), nullptr);
    EXPECT_EQ(misprint(409, ""), 416);
    EXPECT_EQ(misprint(409, "CanBaudrate"), 416);
    EXPECT_EQ(misprint(409, "canbaudrate"), 416);
    EXPECT_EQ(misprint(4409, ""), 4416);
    EXPECT_EQ(misprint(4409, "CanSegmentOrBaudrate"), 4416);
    EXPECT_EQ(misprint(4901, "ChanType_Setp1Ext"), 4901);
    EXPECT_EQ(misprint(4901, ""), 0);  // a number of its own
    EXPECT_EQ(misprint(409, "CanMyNodeNumber"), 0);
    EXPECT_EQ(misprint(416, "CanBaudrate"), 0);
    EXPECT_EQ(catalogue.find_misprint(Device::gateway, 409, ""), nullptr);
}

TEST_F(ShippedLookup, an_array_without_index_is_its_first_element) {
    EXPECT_EQ(number(Device::gateway, "CanOpTPDO5-16ID"), 16404);
    EXPECT_EQ(number(Device::governor, "CanOpTPDO16Assign"), 16448);
    EXPECT_EQ(number(Device::governor, "canoprpdo1-4cyc"), 16480);
}

TEST_F(ShippedLookup, one_number_means_different_things_in_the_two_devices) {
    EXPECT_EQ(catalogue.find(Device::governor, std::uint16_t{16404})->name, "CanOpTPDO5Assign(0)");
    EXPECT_EQ(catalogue.find(Device::gateway, std::uint16_t{16404})->name, "CanOpTPDO5-16ID(0)");  // D1
}

}  // namespace
