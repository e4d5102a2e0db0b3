// The bootloader's rows against the manual's list 9.3.2, typed from the print, and its two value lists.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "catalogue/catalogue.hpp"
#include "parameter/catalogue.hpp"

namespace {

using cgw::parameter::Base;
using cgw::parameter::Catalogue;
using cgw::parameter::Device;
using cgw::parameter::List;
using cgw::parameter::Program;
using cgw::parameter::Row;

struct Printed {
    std::uint16_t number;
    const char* name;
    double maximum;
    bool hexadecimal;
};

constexpr Printed printed[] = {
    {3075, "ErrClearFlash", 1, false},
    {3076, "ErrEEPROM", 1, false},
    {3078, "ErrRAMTest", 1, false},
    {3079, "ErrProgFlash", 1, false},
    {3087, "ErrMainCheckSum", 1, false},
    {3089, "ErrWatchdog", 1, false},
    {3094, "ErrIntern", 1, false},
    {3095, "ExceptionNumber", 0xFFFF, true},
    {3096, "ExceptionAddrLow", 0xFFFF, true},
    {3097, "ExceptionAddrHigh", 0xFFFF, true},
    {3098, "ExceptionFlag", 0xFFFF, true},
    {3800, "TestStatus", 65535, false},
    {3801, "TestValue1", 0xFFFF, true},
    {3802, "TestValue2", 0xFFFF, true},
    {3803, "TestValue3", 0xFFFF, true},
    {3840, "HardwareVersion", 9999, false},
    {3841, "AddHardwareVersion", 9999, false},
    {3842, "SoftwareVersion", 65535, false},
    {3850, "Identifier", 65535, false},
    {3870, "Timer", 65535, false},
};

class ShippedBootloader : public testing::Test {
  protected:
    const Row* find(int number) const {
        return catalogue.find(Device::gateway, Program::bootloader, static_cast<std::uint16_t>(number));
    }

    Catalogue catalogue{cgw::catalogue::shipped_rows()};
};

TEST_F(ShippedBootloader, has_every_row_of_the_printed_list_and_no_other) {
    const std::vector<const Row*>& rows = catalogue.rows(Device::gateway, Program::bootloader);
    ASSERT_EQ(rows.size(), std::size(printed));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        SCOPED_TRACE(printed[i].number);
        EXPECT_EQ(rows[i]->number, printed[i].number);
        EXPECT_EQ(rows[i]->name, printed[i].name);
        EXPECT_EQ(rows[i]->list, List::measurement);
        EXPECT_EQ(rows[i]->level, 1);
        EXPECT_EQ(rows[i]->minimum, 0.0);
        EXPECT_EQ(rows[i]->maximum, printed[i].maximum);
        EXPECT_EQ(rows[i]->base, printed[i].hexadecimal ? Base::hexadecimal : Base::decimal);
        EXPECT_EQ(rows[i]->is_bit(), printed[i].maximum == 1);
    }
}

TEST_F(ShippedBootloader, a_number_means_something_else_than_in_the_application) {  // D1
    EXPECT_EQ(find(3076)->name, "ErrEEPROM");
    EXPECT_EQ(catalogue.find(Device::gateway, std::uint16_t{3076})->name, "ErrParamStore");
    EXPECT_EQ(find(401), nullptr);
    EXPECT_EQ(catalogue.find(Device::gateway, std::uint16_t{3800}), nullptr);
    EXPECT_TRUE(catalogue.rows(Device::governor, Program::bootloader).empty());
}

TEST_F(ShippedBootloader, its_names_are_looked_up_in_its_own_program_only) {
    EXPECT_EQ(catalogue.find(Device::gateway, Program::bootloader, "erreeprom"), find(3076));
    EXPECT_EQ(catalogue.find(Device::gateway, "ErrEEPROM"), nullptr);
    EXPECT_EQ(catalogue.find(Device::gateway, "Timer")->program, Program::application);
    EXPECT_EQ(catalogue.find(Device::gateway, Program::bootloader, "Timer")->program, Program::bootloader);
}

TEST_F(ShippedBootloader, explains_every_test_status_and_exception_number) {
    const Row* status = find(3800);
    ASSERT_EQ(status->values.size(), 11U);  // 0 of section 9.3.1, 1..10 of 9.3.3
    for (std::uint32_t value = 0; value <= 10; ++value) {
        EXPECT_EQ(status->values[value].value, value);
        EXPECT_NE(status->values[value].text.find("3801"), std::string_view::npos) << value;
    }
    const Row* exception = find(3095);
    ASSERT_EQ(exception->values.size(), 3U);
    EXPECT_EQ(exception->values[2].value, 3U);
    EXPECT_NE(exception->values[2].text.find("watchdog"), std::string_view::npos);
}

}  // namespace
