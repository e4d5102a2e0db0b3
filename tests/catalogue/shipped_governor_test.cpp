// The governor's rows against the gateway manual's chapter 7 and the native manual's chapter 10.
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "catalogue/catalogue.hpp"
#include "parameter/catalogue.hpp"
#include "parameter/settings.hpp"

namespace {

using cgw::parameter::Assignment;
using cgw::parameter::Catalogue;
using cgw::parameter::Device;
using cgw::parameter::external_limits;
using cgw::parameter::List;
using cgw::parameter::ParameterSet;
using cgw::parameter::Role;
using cgw::parameter::Row;
using cgw::parameter::to_engineering;

class ShippedGovernor : public testing::Test {
  protected:
    const Row* find(int number) const {
        return catalogue.find(Device::governor, static_cast<std::uint16_t>(number));
    }

    Catalogue catalogue{cgw::catalogue::shipped_rows()};
};

struct Setting {
    int number;
    const char* name;
    List list;
    double minimum;
    double maximum;
    const char* unit;
};

// Manual 7.1.1, 7.1.2.1; ranges by D17.
constexpr Setting settings[] = {
    {400, "CanStartTimeOutDelay", List::parameter, 0, 100, "s"},
    {401, "CanMyNodeNumber", List::parameter, 1, 31, ""},
    {403, "CanCMNodeNumber", List::parameter, 1, 31, ""},
    {410, "CanPrescaler", List::parameter, 0, 63, ""},
    {411, "CanSyncJumpWidth", List::parameter, 0, 3, ""},
    {412, "CanSamplingMode", List::parameter, 0, 1, ""},
    {413, "CanPhaseSegment1", List::parameter, 0, 7, ""},
    {414, "CanPhaseSegment2", List::parameter, 0, 7, ""},
    {416, "CanBaudrate", List::parameter, 125, 1000, "kbit/s"},
    {4406, "CanCommCMOn", List::function, 0, 1, ""},
    {4416, "CanSegmentOrBaudrate", List::function, 0, 1, ""},
    {14401, "CanOpenSendErrors", List::function, 0, 1, ""},
    {14402, "CanOpenSendStatus", List::function, 0, 1, ""},
};

TEST_F(ShippedGovernor, has_the_settings_of_both_buses) {
    for (const Setting& expected : settings) {
        SCOPED_TRACE(expected.number);
        const Row* row = find(expected.number);
        ASSERT_NE(row, nullptr);
        EXPECT_EQ(row->name, expected.name);
        EXPECT_EQ(row->list, expected.list);
        EXPECT_EQ(row->minimum, expected.minimum);
        EXPECT_EQ(row->maximum, expected.maximum);
        EXPECT_EQ(row->unit, expected.unit);
        EXPECT_EQ(row->decimal, expected.number == 400);
    }
    EXPECT_EQ(find(402), nullptr);  // only the gateway has it
    EXPECT_EQ(find(415), nullptr);  // no propagation segment (D7)
    EXPECT_EQ(find(416)->choices.size(), 4U);
}

TEST_F(ShippedGovernor, has_four_words_for_each_of_tpdo_4_to_16) {
    for (int number = 16400; number <= 16451; ++number) {
        const int tpdo = 4 + (number - 16400) / 4;
        const int word = (number - 16400) % 4;
        const Row* row = find(number);
        ASSERT_NE(row, nullptr) << number;
        EXPECT_EQ(row->name, "CanOpTPDO" + std::to_string(tpdo) + "Assign(" + std::to_string(word) + ")");
        EXPECT_EQ(row->maximum, 29999);
        EXPECT_EQ(row->array_first, number - word);
        EXPECT_EQ(row->array_size, 4);
        const std::string text = "number of the measurement in word " + std::to_string(word + 1) +
                                 " of TPDO" + std::to_string(tpdo) + ";";
        EXPECT_TRUE(row->text.starts_with(text)) << row->text;
    }
    EXPECT_EQ(find(16452), nullptr);
}

TEST_F(ShippedGovernor, lets_only_the_list_of_16400_run_on_to_16451) {
    EXPECT_EQ(find(16400)->list_end, 16451);
    EXPECT_EQ(find(16401)->list_end, 16403);
    EXPECT_EQ(find(16404)->list_end, 16407);
    EXPECT_EQ(find(16448)->list_end, 16451);
    EXPECT_EQ(find(16460)->list_end, 16472);
    EXPECT_EQ(find(16472)->list_end, 16472);
    EXPECT_EQ(find(16482)->list_end, 16483);
    EXPECT_EQ(find(416)->list_end, 0);
}

TEST_F(ShippedGovernor, has_a_time_for_each_cyclic_pdo) {
    for (int number = 16460; number <= 16472; ++number) {
        EXPECT_EQ(find(number)->name, "CanOpTPDO4-16Cyc(" + std::to_string(number - 16460) + ")");
        const std::string text = "period of TPDO" + std::to_string(4 + number - 16460) + ",";
        EXPECT_TRUE(find(number)->text.starts_with(text)) << find(number)->text;
    }
    for (int number = 16480; number <= 16483; ++number) {
        EXPECT_EQ(find(number)->name, "CanOpRPDO1-4Cyc(" + std::to_string(number - 16480) + ")");
        EXPECT_EQ(find(number)->unit, "ms");
        EXPECT_EQ(find(number)->maximum, 65535);
    }
    EXPECT_EQ(find(16473), nullptr);
    EXPECT_EQ(find(16484), nullptr);
}

TEST_F(ShippedGovernor, knows_every_switch_by_number) {
    for (int number = 810; number <= 849; ++number) {
        ASSERT_NE(find(number), nullptr) << number;
        EXPECT_EQ(find(number)->role, Role::switch_assignment);
        EXPECT_EQ(find(number)->list, List::parameter);
        EXPECT_EQ(find(number)->minimum, -32768);  // D19
        EXPECT_EQ(find(number)->maximum, 32767);
        ASSERT_NE(find(number + 4000), nullptr) << number;
        EXPECT_EQ(find(number + 4000)->role, Role::switch_type);
        EXPECT_EQ(find(number + 4000)->list, List::function);
        EXPECT_EQ(find(number + 4000)->minimum, 0);
        EXPECT_EQ(find(number + 4000)->maximum, 4);
    }
    EXPECT_EQ(find(809), nullptr);
    EXPECT_EQ(find(850), nullptr);
}

TEST_F(ShippedGovernor, knows_every_sensor_by_number) {
    for (int number = 900; number <= 929; ++number) {
        ASSERT_NE(find(number), nullptr) << number;
        EXPECT_EQ(find(number)->role, Role::sensor_assignment);
        ASSERT_NE(find(number + 4000), nullptr) << number;
        EXPECT_EQ(find(number + 4000)->role, Role::sensor_type);
        EXPECT_EQ(find(number + 4000)->maximum, 4);
    }
    EXPECT_EQ(find(930), nullptr);
}

TEST_F(ShippedGovernor, names_switches_and_sensors_only_where_a_manual_does) {
    const std::map<int, std::string> named = {
        {810, "FunctEngineStop"},        {811, "FunctIdleSpeed"},     {827, "FunctSetpoint2Or1"},
        {835, "FunctLoadEnable"},        {900, "AssignIn_Setp1Ext"},  {901, "AssignIn_Setp2Ext"},
        {904, "AssignIn_BoostPressure"}, {906, "AssignIn_AmbPress"},  {907, "AssignIn_CoolantTemp"},
        {917, "AssignIn_CurrentLoad"},   {4811, "Type_IdleSpeed"},    {4827, "Type_Setpoint2Or1"},
        {4835, "Type_LoadEnable"},       {4900, "ChanType_Setp1Ext"}, {4901, "ChanType_Setp2Ext"},
        {4904, "ChanType_BoostPress"},   {4906, "ChanType_AmbPress"}, {4907, "ChanType_CoolantTemp"},
        {4917, "ChanType_CurrentLoad"},
    };
    for (const Row* row : catalogue.rows(Device::governor)) {
        if (row->role != Role::none) {
            const auto expected = named.find(row->number);
            EXPECT_EQ(row->name, expected != named.end() ? expected->second : "") << row->number;
        }
    }
}

TEST_F(ShippedGovernor, tells_a_switch_row_which_partner_it_has) {
    EXPECT_NE(find(815)->text.find("4815"), std::string_view::npos) << find(815)->text;
    EXPECT_NE(find(4849)->text.find("849 says"), std::string_view::npos) << find(4849)->text;
    EXPECT_NE(find(912)->text.find("2912"), std::string_view::npos) << find(912)->text;
}

struct Measurement {
    int number;
    const char* name;
    const char* unit;
    double minimum;
    double maximum;
    int minimum_parameter;
    int maximum_parameter;
};

// Native manual 10.1 and 10.2; all are words 0..65535.
constexpr Measurement measurements[] = {
    {2000, "Speed", "1/min", 0, 4000, 0, 0},
    {2031, "SpeedSetp", "1/min", 0, 4000, 0, 0},
    {2300, "ActPos", "%", 0, 100, 0, 0},
    {2900, "Setpoint1Extern", "%", 0, 100, 0, 0},
    {2901, "Setpoint2Extern", "%", 0, 100, 0, 0},
    {2902, "LoadControlInput", "%", 0, 100, 0, 0},
    {2903, "SyncInput", "%", 0, 100, 0, 0},
    {2904, "BoostPressure", "bar", 0, 5, 982, 983},
    {2905, "OilPressure", "bar", 0, 20, 980, 981},
    {2906, "AmbientPressure", "mbar", 0, 2000, 984, 985},
    {2907, "CoolantTemp", "°C", -100, 1000, 0, 0},
    {2908, "ChargeAirTemp", "°C", -100, 1000, 0, 0},
    {2909, "OilTemp", "°C", -100, 1000, 0, 0},
    {2910, "FuelTemp", "°C", -100, 1000, 0, 0},
    {2911, "ExhaustTemp", "°C", -100, 1000, 0, 0},
    {2914, "SlideExcitReduction", "%", 0, 100, 0, 0},
    {2915, "SlideSpeedReduction", "1/min", 0, 4000, 0, 987},
    {2916, "CoolantPressure", "bar", 0, 5, 978, 979},
};

TEST_F(ShippedGovernor, scales_the_measurements_of_the_native_manual) {
    for (const Measurement& expected : measurements) {
        SCOPED_TRACE(expected.number);
        const Row* row = find(expected.number);
        ASSERT_NE(row, nullptr);
        EXPECT_EQ(row->name, expected.name);
        EXPECT_EQ(row->unit, expected.unit);
        EXPECT_EQ(row->minimum, expected.minimum);
        EXPECT_EQ(row->maximum, expected.maximum);
        EXPECT_EQ(row->width, 16);
        EXPECT_FALSE(row->is_signed);
        ASSERT_TRUE(row->scaling.has_value());
        EXPECT_EQ(row->scaling->internal_minimum, 0);
        EXPECT_EQ(row->scaling->internal_maximum, 65535);
        EXPECT_EQ(row->scaling->external_minimum_parameter, expected.minimum_parameter);
        EXPECT_EQ(row->scaling->external_maximum_parameter, expected.maximum_parameter);
        EXPECT_EQ(row->scaling->external_minimum.has_value(), expected.minimum_parameter == 0);
        EXPECT_EQ(row->scaling->external_maximum.has_value(), expected.maximum_parameter == 0);
        EXPECT_EQ(row->scaling->external_minimum.value_or(expected.minimum), expected.minimum);
        EXPECT_EQ(row->scaling->external_maximum.value_or(expected.maximum), expected.maximum);
    }
}

TEST_F(ShippedGovernor, leaves_blank_what_no_manual_prints) {
    for (const int number : {2330, 2350, 2917, 2918, 2919}) {
        const Row* row = find(number);
        ASSERT_NE(row, nullptr) << number;
        EXPECT_EQ(row->width, 16);  // D13
        EXPECT_FALSE(row->is_signed);
        EXPECT_EQ(row->unit, "");
        ASSERT_TRUE(row->scaling.has_value());
        EXPECT_EQ(row->scaling->internal_maximum, 65535);
        EXPECT_FALSE(row->scaling->external_minimum.has_value());
    }
    EXPECT_EQ(find(2917)->name, "CurrentLoad");  // AsymmetricLoad in the native governor (D68)
}

TEST_F(ShippedGovernor, knows_the_bits_that_a_user_might_assign) {
    for (const int number :
         {2810,  2827,  2828,  3000,  3005,  3070,  3071,  3074,  12401, 12402, 12403, 12404,
          12411, 12412, 12413, 12414, 12415, 12419, 12420, 12421, 12422, 12423, 12424}) {
        ASSERT_NE(find(number), nullptr) << number;
        EXPECT_TRUE(find(number)->is_bit()) << number;
        EXPECT_EQ(find(number)->list, List::measurement) << number;
    }
}

TEST_F(ShippedGovernor, scales_oil_pressure_by_the_settings_980_and_981) {
    const Row* oil = find(2905);
    ParameterSet set;
    EXPECT_FALSE(external_limits(*oil, set).has_value());
    ASSERT_TRUE(set.assign(Assignment{.row = find(980), .value = 0.5}));
    EXPECT_FALSE(external_limits(*oil, set).has_value());
    ASSERT_TRUE(set.assign(Assignment{.row = find(981), .value = 10.5}));
    const auto limits = external_limits(*oil, set);
    ASSERT_TRUE(limits.has_value());
    const auto bar = [&](int raw) {
        return to_engineering(raw, oil->scaling->internal_minimum, oil->scaling->internal_maximum,
                              limits->minimum, limits->maximum);
    };
    EXPECT_DOUBLE_EQ(bar(0), 0.5);
    EXPECT_DOUBLE_EQ(bar(65535), 10.5);
    EXPECT_NEAR(bar(32768), 5.5, 0.0001);
}

TEST_F(ShippedGovernor, has_a_settable_parameter_behind_every_reference) {
    int references = 0;
    for (const Row* row : catalogue.rows(Device::governor)) {
        for (const int number : {row->scaling ? row->scaling->external_minimum_parameter : 0,
                                 row->scaling ? row->scaling->external_maximum_parameter : 0}) {
            if (number != 0) {
                ASSERT_NE(find(number), nullptr) << number;
                EXPECT_TRUE(find(number)->settable());
                EXPECT_EQ(find(number)->unit, row->unit);
                EXPECT_EQ(find(number)->maximum, row->maximum);
                ++references;
            }
        }
    }
    EXPECT_EQ(references, 9);
    for (const int number : {992, 993, 994, 995}) {  // for whoever declares 2918 and 2919 in kW
        EXPECT_EQ(find(number)->unit, "kW");
        EXPECT_EQ(find(number)->maximum, 2500);
    }
}

}  // namespace
