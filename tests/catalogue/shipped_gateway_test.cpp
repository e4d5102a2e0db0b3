// The gateway's rows against the manual's chapter 11, typed from the print (lists 1 to 4).
#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <string>

#include "catalogue/catalogue.hpp"
#include "parameter/catalogue.hpp"

namespace {

using cgw::parameter::Base;
using cgw::parameter::Catalogue;
using cgw::parameter::Device;
using cgw::parameter::List;
using cgw::parameter::Row;

struct Printed {
    std::uint16_t number;
    const char* name;
    List list;
    int level;
    double minimum;
    double maximum;
    const char* unit;
    bool hexadecimal;
};

// clang-format off
constexpr Printed printed[] = {
    {400, "CanStartTimeOutDelay", List::parameter, 6, 0, 100, "s", false},
    {401, "CanMyNodeNumber", List::parameter, 6, 1, 31, "", false},
    {402, "CanDCNodeNumber", List::parameter, 6, 1, 31, "", false},
    {410, "HzmCanPrescaler", List::parameter, 6, 0, 63, "", false},
    {411, "HzmCanSyncJumpWidth", List::parameter, 6, 0, 3, "", false},
    {412, "HzmCanSamplingMode", List::parameter, 6, 0, 1, "", false},
    {413, "HzmCanPhaseSegment1", List::parameter, 6, 0, 7, "", false},
    {414, "HzmCanPhaseSegment2", List::parameter, 6, 0, 7, "", false},
    {415, "HzmCanPropSegment", List::parameter, 6, 0, 7, "", false},
    {416, "HzmCanBaudrate", List::parameter, 6, 125, 1000, "kbit/s", false},
    {420, "CanOpenPrescaler", List::parameter, 6, 0, 63, "", false},
    {421, "CanOpenSyncJumpWidth", List::parameter, 6, 0, 3, "", false},
    {422, "CanOpenSamplingMode", List::parameter, 6, 0, 1, "", false},
    {423, "CanOpenPhaseSegment1", List::parameter, 6, 0, 7, "", false},
    {424, "CanOpenPhaseSegment2", List::parameter, 6, 0, 7, "", false},
    {425, "CanOpenPropSegment", List::parameter, 6, 0, 7, "", false},
    {426, "CanOpenBaudrate", List::parameter, 6, 125, 1000, "kbit/s", false},
    {427, "CanOpenMyNodeID", List::parameter, 6, 1, 127, "", false},
    {428, "CanOpenPartnerNodeID", List::parameter, 6, 0, 127, "", false},
    {429, "CanOpHeartBeatTxTime", List::parameter, 6, 0, 65535, "ms", false},
    {430, "CanOpHeartBeatRxTime", List::parameter, 6, 0, 65535, "ms", false},
    {1800, "Level", List::parameter, 1, 1, 7, "", false},
    {2401, "CanTxBufferState", List::measurement, 1, 0, 0xFFFF, "", true},
    {2402, "CanRxBufferState", List::measurement, 1, 0, 0xFFFF, "", true},
    {2403, "CanRxTimeout", List::measurement, 1, 0, 0xFFFF, "", true},
    {2404, "CanTypeMismatch", List::measurement, 1, 0, 1, "", false},
    {2405, "CanOnline", List::measurement, 1, 0, 1, "", false},
    {2410, "CanDCNodeState31to16", List::measurement, 6, 0, 0xFFFF, "", true},
    {2411, "CanDCNodeState15to01", List::measurement, 6, 0, 0xFFFF, "", true},
    {2424, "CanPCNodeState31to16", List::measurement, 6, 0, 0xFFFF, "", true},
    {2425, "CanPCNodeState15to01", List::measurement, 6, 0, 0xFFFF, "", true},
    {3070, "ErrCanBus1", List::measurement, 1, 0, 1, "", false},
    {3071, "ErrCanComm1", List::measurement, 1, 0, 1, "", false},
    {3072, "ErrCanBus2", List::measurement, 1, 0, 1, "", false},
    {3073, "ErrCanComm2", List::measurement, 1, 0, 1, "", false},
    {3074, "ErrCanOpen", List::measurement, 1, 0, 1, "", false},
    {3076, "ErrParamStore", List::measurement, 1, 0, 1, "", false},
    {3077, "ErrProgramTest", List::measurement, 1, 0, 1, "", false},
    {3078, "ErrRAMTest", List::measurement, 1, 0, 1, "", false},
    {3085, "ErrVoltage", List::measurement, 1, 0, 1, "", false},
    {3090, "ErrData", List::measurement, 1, 0, 1, "", false},
    {3093, "ErrStack", List::measurement, 1, 0, 1, "", false},
    {3094, "ErrIntern", List::measurement, 1, 0, 1, "", false},
    {3099, "EEPROMErrorCode", List::measurement, 6, 0, 0xFFFF, "", true},
    {3170, "SErrCanBus1", List::measurement, 1, 0, 255, "", false},
    {3171, "SErrCanComm1", List::measurement, 1, 0, 255, "", false},
    {3172, "SErrCanBus2", List::measurement, 1, 0, 255, "", false},
    {3173, "SErrCanComm2", List::measurement, 1, 0, 255, "", false},
    {3174, "SErrCanOpen", List::measurement, 1, 0, 255, "", false},
    {3176, "SErrParamStore", List::measurement, 1, 0, 255, "", false},
    {3177, "SErrProgramTest", List::measurement, 1, 0, 255, "", false},
    {3178, "SErrRAMTest", List::measurement, 1, 0, 255, "", false},
    {3185, "SErrVoltage", List::measurement, 1, 0, 255, "", false},
    {3190, "SErrData", List::measurement, 1, 0, 255, "", false},
    {3193, "SErrStack", List::measurement, 1, 0, 255, "", false},
    {3194, "SErrIntern", List::measurement, 1, 0, 255, "", false},
    {3195, "SExceptionNumber", List::measurement, 1, 0, 65535, "", false},
    {3196, "SExceptionAddrLow", List::measurement, 1, 0, 0xFFFF, "", true},
    {3197, "SExceptionAddrHigh", List::measurement, 1, 0, 0xFFFF, "", true},
    {3198, "SExceptionFlag", List::measurement, 1, 0, 0xFFFF, "", true},
    {3600, "PowerSupply", List::measurement, 1, 0, 55, "V", false},
    {3840, "HardwareVersion", List::measurement, 1, 0, 9999, "", false},
    {3841, "AddHardwareVersion", List::measurement, 1, 0, 9999, "", false},
    {3842, "SoftwareVersion", List::measurement, 1, 0, 65535, "", false},
    {3843, "BootSoftwareVersion", List::measurement, 1, 0, 65535, "", false},
    {3844, "SerialDate", List::measurement, 1, 0, 9912, "", false},
    {3845, "SerialNumber", List::measurement, 1, 0, 65535, "", false},
    {3850, "Identifier", List::measurement, 1, 0, 65535, "", false},
    {3851, "LastIdentifier", List::measurement, 1, 0, 65535, "", false},
    {3865, "CalculationTime", List::measurement, 1, 0, 16.384, "ms", false},
    {3870, "Timer", List::measurement, 1, 0, 65.535, "s", false},
    {3895, "RAMTestAddr", List::measurement, 6, 0, 0xFFFF, "", true},
    {3896, "RAMTestPattern", List::measurement, 6, 0, 0xFFFF, "", true},
    {3897, "CStackTestFreeBytes", List::measurement, 6, 0, 0x200, "", true},
    {3898, "IStackTestFreeBytes", List::measurement, 6, 0, 0x200, "", true},
    {12401, "CanOpStopped", List::measurement, 6, 0, 1, "", false},
    {12402, "CanOpInit", List::measurement, 6, 0, 1, "", false},
    {12403, "CanOpPreOperational", List::measurement, 6, 0, 1, "", false},
    {12404, "CanOpOperational", List::measurement, 6, 0, 1, "", false},
    {12405, "CanOpOnline", List::measurement, 6, 0, 1, "", false},
    {12411, "CanOpDCResetErr", List::measurement, 6, 0, 1, "", false},
    {12412, "CanOpInitErr", List::measurement, 6, 0, 1, "", false},
    {12413, "CanOpTimeCtrlErr", List::measurement, 6, 0, 1, "", false},
    {12414, "CanOpDCErrCanBus", List::measurement, 6, 0, 1, "", false},
    {12415, "CanOpDCErrCanComm", List::measurement, 6, 0, 1, "", false},
    {12419, "CanOpGWResetErr", List::measurement, 6, 0, 1, "", false},
    {12420, "CanOpHeartbeatErr", List::measurement, 6, 0, 1, "", false},
    {12421, "CanOpGWErrCanBus1", List::measurement, 6, 0, 1, "", false},
    {12422, "CanOpGWErrCanComm1", List::measurement, 6, 0, 1, "", false},
    {12423, "CanOpGWErrCanBus2", List::measurement, 6, 0, 1, "", false},
    {12424, "CanOpGWErrCanComm2", List::measurement, 6, 0, 1, "", false},
    {4400, "HzmCanCommDCon", List::function, 6, 0, 1, "", false},
    {4416, "HzmCanSegmOrBaudrate", List::function, 6, 0, 1, "", false},
    {4426, "CanOpSegmOrBaudrate", List::function, 6, 0, 1, "", false},
};
// clang-format on

class ShippedGateway : public testing::Test {
  protected:
    const Row* find(int number) const {
        return catalogue.find(Device::gateway, static_cast<std::uint16_t>(number));
    }

    Catalogue catalogue{cgw::catalogue::shipped_rows()};
};

TEST_F(ShippedGateway, has_every_row_of_chapter_11_as_printed) {
    for (const Printed& expected : printed) {
        SCOPED_TRACE(expected.number);
        const Row* row = find(expected.number);
        ASSERT_NE(row, nullptr);
        EXPECT_EQ(row->name, expected.name);
        EXPECT_EQ(row->list, expected.list);
        EXPECT_EQ(row->level, expected.level);
        EXPECT_EQ(row->minimum, expected.minimum);
        EXPECT_EQ(row->maximum, expected.maximum);
        EXPECT_EQ(row->unit, expected.unit);
        EXPECT_EQ(row->base, expected.hexadecimal ? Base::hexadecimal : Base::decimal);
    }
}

TEST_F(ShippedGateway, has_nothing_that_chapter_11_does_not_print) {
    const auto is_printed = [](std::uint16_t number) {
        return std::any_of(std::begin(printed), std::end(printed),
                           [number](const Printed& row) { return row.number == number; });
    };
    for (const Row* row : catalogue.rows(Device::gateway)) {
        const std::uint16_t number = row->number;
        const bool identifier = number >= 16404 && number <= 16415;
        const bool synoptic_only = number == 2406 || number == 12400 || number == 12410;  // D59
        EXPECT_TRUE(identifier || synoptic_only || is_printed(number)) << number;
    }
}

TEST_F(ShippedGateway, has_an_identifier_for_each_of_tpdo_5_to_16) {
    for (std::uint16_t i = 0; i < 12; ++i) {
        const Row* row = find(16404 + i);
        ASSERT_NE(row, nullptr) << i;
        EXPECT_EQ(row->name, "CanOpTPDO5-16ID(" + std::to_string(i) + ")");
        EXPECT_EQ(row->list, List::curve);
        EXPECT_EQ(row->level, 6);
        EXPECT_EQ(row->minimum, 0.0);
        EXPECT_EQ(row->maximum, 0x7FF);
        EXPECT_EQ(row->base, Base::hexadecimal);
        EXPECT_EQ(row->array_first, 16404);
        EXPECT_EQ(row->array_size, 12);
        EXPECT_EQ(row->array_index(), i);
        EXPECT_EQ(row->list_end, 16415);
        EXPECT_NE(row->text.find("TPDO" + std::to_string(5 + i) + ";"), std::string_view::npos) << row->text;
    }
    EXPECT_EQ(find(16416), nullptr);
}

TEST_F(ShippedGateway, takes_four_bit_rates) {
    for (const int number : {416, 426}) {
        const std::span<const std::uint32_t> choices = find(number)->choices;
        EXPECT_EQ(std::vector<std::uint32_t>(choices.begin(), choices.end()),
                  (std::vector<std::uint32_t>{125, 250, 500, 1000}));
    }
}

TEST_F(ShippedGateway, takes_fractions_only_for_the_start_up_delay) {
    for (const Row* row : catalogue.rows(Device::gateway)) {
        EXPECT_EQ(row->settable() && row->decimal, row->number == 400) << row->number;
    }
}

TEST_F(ShippedGateway, has_the_pages_that_the_manuals_list_prints) {
    const std::span<const std::uint32_t> pages = find(400)->pages;
    EXPECT_EQ(std::vector<std::uint32_t>(pages.begin(), pages.end()), (std::vector<std::uint32_t>{27, 29}));
    EXPECT_EQ(find(16415)->pages.size(), 1U);  // every element of an array
    EXPECT_TRUE(find(1800)->pages.empty());    // the list prints none
}

TEST_F(ShippedGateway, lets_nobody_set_a_measurement) {
    EXPECT_FALSE(find(2401)->settable());
    EXPECT_FALSE(find(3074)->settable());
    EXPECT_TRUE(find(401)->settable());
    EXPECT_TRUE(find(4400)->settable());
    EXPECT_TRUE(find(16404)->settable());
}

TEST_F(ShippedGateway, marks_what_is_0_or_1_as_a_bit) {
    for (const Row* row : catalogue.rows(Device::gateway)) {
        if (row->list == List::measurement) {
            EXPECT_EQ(row->is_bit(), row->maximum == 1.0) << row->number;
        }
    }
}

TEST_F(ShippedGateway, says_that_the_meaning_of_three_rows_is_not_printed) {
    for (const int number : {2406, 12400, 12410}) {
        ASSERT_NE(find(number), nullptr);
        EXPECT_NE(find(number)->text.find("not printed"), std::string_view::npos);
        EXPECT_EQ(find(number)->level, 0);
    }
}

}  // namespace
