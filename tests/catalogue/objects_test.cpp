// Object descriptions and the meaning of bits.
#include "catalogue/objects.hpp"

#include <gtest/gtest.h>

#include <string>

#include "catalogue/catalogue.hpp"

namespace {

using cgw::catalogue::find_object;
using cgw::catalogue::find_object_bit;
using cgw::catalogue::object_bits;
using cgw::catalogue::ObjectDescription;
using cgw::parameter::Catalogue;
using cgw::parameter::Device;
using cgw::parameter::NamedBit;
using cgw::parameter::Row;

class CatalogueObjects : public testing::Test {
  protected:
    // "1 CanOpInitErr, 8 CanOpGWResetErr"
    std::string bits(std::uint16_t index, std::uint8_t sub) const {
        std::string text;
        for (const NamedBit& bit : object_bits(index, sub, catalogue)) {
            text += (text.empty() ? "" : ", ") + std::to_string(bit.bit) + " " + std::string(bit.name);
        }
        return text;
    }
    const Row* gateway(int number) const {
        return catalogue.find(Device::gateway, static_cast<std::uint16_t>(number));
    }

    Catalogue catalogue{cgw::catalogue::shipped_rows()};
};

TEST_F(CatalogueObjects, bits_of_2005h_are_those_of_the_manuals_table_2) {  // D52
    EXPECT_EQ(bits(0x2005, 0),
              "0 CanOpDCResetErr, 1 CanOpInitErr, 2 CanOpTimeCtrlErr, 3 CanOpDCErrCanBus, "
              "4 CanOpDCErrCanComm, 8 CanOpGWResetErr, 9 CanOpHeartbeatErr, 10 CanOpGWErrCanBus1, "
              "11 CanOpGWErrCanComm1, 12 CanOpGWErrCanBus2, 13 CanOpGWErrCanComm2");
}

TEST_F(CatalogueObjects, error_bits_are_3000_upward_16_in_a_word) {  // D21, D58
    EXPECT_EQ(bits(0x2000, 1), "0 ConfigurationError, 5 ErrSetpointExtern");
    EXPECT_EQ(bits(0x2000, 2), "");
    EXPECT_EQ(bits(0x2000, 5),
              "6 ErrCanBus1, 7 ErrCanComm1, 8 ErrCanBus2, 9 ErrCanComm2, 10 ErrCanOpen, 12 ErrParamStore, "
              "13 ErrProgramTest, 14 ErrRAMTest");
    EXPECT_EQ(bits(0x2000, 6), "5 ErrVoltage, 10 ErrData, 13 ErrStack, 14 ErrIntern");
}

TEST_F(CatalogueObjects, the_engine_state_has_eight_bits_in_the_low_byte) {  // D22
    EXPECT_EQ(object_bits(0x2000, 7, catalogue).size(), 8U);
    EXPECT_EQ(object_bits(0x2000, 7, catalogue).back().bit, 7);
}

TEST_F(CatalogueObjects, words_of_rpdo1_have_16_switches_and_12_flags) {  // D25
    const auto switches = object_bits(0x2003, 1, catalogue);
    ASSERT_EQ(switches.size(), 16U);
    EXPECT_EQ(switches.front().name, "Switch1");
    EXPECT_EQ(switches.back().name, "Switch16");
    const auto flags = object_bits(0x2003, 2, catalogue);
    ASSERT_EQ(flags.size(), 12U);
    EXPECT_EQ(flags[11].bit, 11);
    EXPECT_EQ(flags[11].name, "SensorError12");
}

TEST_F(CatalogueObjects, a_parameter_knows_its_bit) {
    const auto init = find_object_bit(12412);
    ASSERT_TRUE(init);
    EXPECT_EQ(init->index, 0x2005);
    EXPECT_EQ(init->bit, 1);
    const auto canopen = find_object_bit(3074);
    ASSERT_TRUE(canopen);
    EXPECT_EQ(canopen->index, 0x2000);
    EXPECT_EQ(canopen->sub, 5);
    EXPECT_EQ(canopen->bit, 10);
    EXPECT_TRUE(find_object_bit(3095));
    EXPECT_FALSE(find_object_bit(3096));  // D21
    EXPECT_FALSE(find_object_bit(2999));
    EXPECT_FALSE(find_object_bit(12425));
}

TEST_F(CatalogueObjects, node_state_words_hold_a_node_a_bit) {  // D11
    EXPECT_EQ(gateway(2411)->bits.size(), 15U);
    EXPECT_EQ(gateway(2411)->bits.front().bit, 1);
    EXPECT_EQ(gateway(2411)->bits.front().name, "Node1");
    EXPECT_EQ(gateway(2410)->bits.size(), 16U);
    EXPECT_EQ(gateway(2410)->bits.front().name, "Node16");
    EXPECT_EQ(gateway(2410)->bits.back().text, "the governor with node number 31 is heard");
    EXPECT_EQ(gateway(2424)->bits.back().name, "Node31");
    EXPECT_EQ(gateway(2425)->bits.back().name, "Node15");
}

TEST_F(CatalogueObjects, pages_of_the_eeprom_have_the_printed_bits) {  // GWM 9.4
    std::string numbers;
    for (const NamedBit& bit : gateway(3099)->bits) {
        numbers += std::to_string(bit.bit);
    }
    EXPECT_EQ(numbers, "03456");
}

TEST_F(CatalogueObjects, arrays_say_which_object_each_element_feeds) {
    EXPECT_EQ(gateway(16404)->used, "1804h:1, the COB-ID of TPDO5");
    EXPECT_EQ(gateway(16415)->used, "180Fh:1, the COB-ID of TPDO16");
    const Row* cycle = catalogue.find(Device::governor, std::uint16_t{16472});
    EXPECT_NE(cycle->used.find("180Fh:5, the event timer of TPDO16"), std::string_view::npos) << cycle->used;
}

TEST_F(CatalogueObjects, an_entry_without_a_text_of_its_own_has_the_objects) {
    EXPECT_EQ(find_object(0x1018, 2)->first_sub, 2);
    EXPECT_TRUE(find_object(0x1018, 0)->whole);
    EXPECT_EQ(find_object(0x1800, 5)->text, "0: TPDO1 is sent when a bit changes, not in a period");
    EXPECT_EQ(find_object(0x1804, 1)->text, "COB-ID of TPDO5; bit 31 set: not active");
    EXPECT_EQ(find_object(0x1010), nullptr);  // D42
    EXPECT_EQ(find_object(0x1010, 1), nullptr);
}

}  // namespace
