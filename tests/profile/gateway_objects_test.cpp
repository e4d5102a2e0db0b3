// The gateway's dictionary without its PDOs: communication objects and 2000h–2005h.
#include <gtest/gtest.h>

#include <set>

#include "profile/gateway.hpp"
#include "support/sample_configuration.hpp"

namespace cgw::profile {
namespace {

using dictionary::Dictionary;
using dictionary::Object;
using dictionary::Variable;
using object::Access;
using object::DataType;
using object::ObjectCode;

Dictionary dictionary_of(const config::Configuration& configuration) {
    return gateway_dictionary(configuration, GatewayDocument{});
}

std::uint64_t value(const Dictionary& dictionary, std::uint16_t index, std::uint8_t sub_index) {
    const Variable* const variable = dictionary.find(index, sub_index);
    EXPECT_NE(variable, nullptr) << std::hex << index << ':' << +sub_index;
    return variable != nullptr ? variable->default_value.number : 0xDEADBEEF;
}

std::vector<std::string> entry_names(const Dictionary& dictionary, std::uint16_t index) {
    std::vector<std::string> names;
    const Object* const object = dictionary.find(index);
    for (std::size_t i = 1; object != nullptr && i < object->variables.size(); ++i) {
        names.push_back(object->variables[i].name);
    }
    return names;
}

using Names = std::vector<std::string>;
using Indices = std::vector<std::uint16_t>;

}  // namespace

TEST(GatewayObjects, are_exactly_those_of_the_printed_eds_in_ascending_order) {
    std::vector<std::uint16_t> expected{0x1000, 0x1001, 0x1016, 0x1017, 0x1018, 0x1200};
    const auto append = [&](std::uint16_t first, std::uint16_t last) {
        for (std::uint16_t index = first; index <= last; ++index) {
            expected.push_back(index);
        }
    };
    append(0x1400, 0x1403);
    append(0x1600, 0x1603);
    append(0x1800, 0x180F);
    append(0x1A00, 0x1A0F);
    append(0x2000, 0x2005);
    for (const config::Configuration& configuration :
         {test::empty_configuration(), test::manual_configuration()}) {
        std::vector<std::uint16_t> found;
        for (const Object& object : dictionary_of(configuration).objects) {
            found.push_back(object.index);
        }
        EXPECT_EQ(found, expected);
    }
}

TEST(GatewayObjects, have_the_mended_object_codes) {
    const Dictionary dictionary = dictionary_of(test::empty_configuration());
    for (const std::uint16_t index : Indices{0x1018, 0x1200, 0x1400, 0x1600, 0x1800, 0x1A0F}) {
        EXPECT_EQ(dictionary.find(index)->code, ObjectCode::record) << std::hex << index;
    }
    for (const std::uint16_t index : Indices{0x1016, 0x2000, 0x2001, 0x2002, 0x2003, 0x2004}) {
        EXPECT_EQ(dictionary.find(index)->code, ObjectCode::array) << std::hex << index;
    }
    for (const std::uint16_t index : Indices{0x1000, 0x1001, 0x1017, 0x2005}) {
        EXPECT_EQ(dictionary.find(index)->code, ObjectCode::var) << std::hex << index;
        EXPECT_EQ(dictionary.find(index)->variables.size(), 1U);
    }
}

TEST(GatewayObjects, carry_the_identity_of_the_file) {
    config::Configuration configuration = test::empty_configuration();
    configuration.identity = {1234, 407, 12};
    const Dictionary dictionary = dictionary_of(configuration);
    EXPECT_EQ(value(dictionary, 0x1018, 0), 4U);
    EXPECT_EQ(value(dictionary, 0x1018, 1), 0x161U);
    EXPECT_EQ(value(dictionary, 0x1018, 2), 0x1B59U);
    EXPECT_EQ(value(dictionary, 0x1018, 3), 1234U);
    EXPECT_EQ(value(dictionary, 0x1018, 4), 407U << 16U | 12U);
    EXPECT_EQ(dictionary.device.revision_number, 1234U);
    EXPECT_EQ(dictionary.device.vendor_number, 0x161U);
    EXPECT_EQ(dictionary.device.product_number, 0x1B59U);
}

TEST(GatewayObjects, carry_effective_heartbeat_times) {
    const Dictionary dictionary = dictionary_of(test::manual_configuration());
    EXPECT_EQ(value(dictionary, 0x1016, 1), 127U << 16U | 96U);
    EXPECT_EQ(value(dictionary, 0x1017, 0), 992U);
    EXPECT_EQ(dictionary.find(0x1017, 0)->type, DataType::unsigned16);
}

TEST(GatewayObjects, have_no_heartbeat_consumer_without_monitoring_time) {
    config::Configuration configuration = test::manual_configuration();
    configuration.heartbeat_consumer = {};
    configuration.heartbeat_producer = {};
    const Dictionary dictionary = dictionary_of(configuration);
    EXPECT_EQ(value(dictionary, 0x1016, 1), 0U);
    EXPECT_EQ(value(dictionary, 0x1017, 0), 0U);
}

TEST(GatewayObjects, sdo_identifiers_follow_the_node_number) {
    const Dictionary dictionary = dictionary_of(test::empty_configuration());
    EXPECT_EQ(dictionary.find(0x1200, 1)->default_value, (dictionary::Value{0x600, true}));
    EXPECT_EQ(dictionary.find(0x1200, 2)->default_value, (dictionary::Value{0x580, true}));
}

TEST(GatewayOutputs, hold_the_engine_state_only_with_tpdo3) {
    config::Configuration configuration = test::empty_configuration();
    EXPECT_EQ(value(dictionary_of(configuration), 0x2000, 0), 6U);
    EXPECT_EQ(dictionary_of(configuration).find(0x2000, 7), nullptr);
    EXPECT_EQ(dictionary_of(configuration).find(0x2000, 6)->name, "Errors 80-95");

    configuration.send_status = true;
    EXPECT_EQ(value(dictionary_of(configuration), 0x2000, 0), 7U);
    EXPECT_EQ(dictionary_of(configuration).find(0x2000, 7)->name, "Engine State");
}

TEST(GatewayOutputs, are_named_after_their_parameters_by_sign) {
    const Dictionary dictionary = dictionary_of(test::manual_configuration());
    EXPECT_EQ(entry_names(dictionary, 0x2001),
              (Names{"Speed", "SpeedSetp", "ActPos", "ActPosSetpoint", "OilPressure", "CurrentLoad"}));
    EXPECT_EQ(entry_names(dictionary, 0x2002), (Names{"ChargeAirTemp"}));
    EXPECT_EQ(value(dictionary, 0x2001, 0), 6U);
    EXPECT_EQ(value(dictionary, 0x2002, 0), 1U);
}

TEST(GatewayOutputs, have_unique_ascii_names) {
    config::Configuration configuration = test::empty_configuration();
    const parameter::Row second = test::make_row(2991, "speed-2");
    const parameter::Row umlaut = test::make_row(2992, "Öldruck");
    const parameter::Row nameless = test::make_row(2993, "");
    for (const parameter::Row* const row :
         {&test::row::speed, &second, &test::row::speed, &umlaut, &nameless}) {
        test::add_output(configuration, 4 + configuration.analogue_outputs.size() / 4, *row);
    }
    // Code generators read "Speed 2" and "speed-2" as one identifier.
    EXPECT_EQ(entry_names(dictionary_of(configuration), 0x2001),
              (Names{"Speed", "speed-2", "Speed 3", "Oeldruck", "Parameter 2993"}));
}

TEST(GatewayOutputs, hold_52_words_at_most) {
    config::Configuration configuration = test::empty_configuration();
    for (std::size_t word = 0; word < 52; ++word) {
        test::add_output(configuration, 4 + word / 4, test::row::speed);
    }
    const Dictionary dictionary = dictionary_of(configuration);
    EXPECT_EQ(value(dictionary, 0x2001, 0), 52U);
    EXPECT_EQ(dictionary.find(0x2001, 0)->high_limit->number, 52U);
    EXPECT_EQ(dictionary.find(0x2001, 52)->name, "Speed 52");
    const Names names = entry_names(dictionary, 0x2001);
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), 52U);
}

TEST(GatewayInputs, exist_as_the_switches_and_sensors_need) {
    config::Configuration configuration = test::empty_configuration();
    EXPECT_EQ(entry_names(dictionary_of(configuration), 0x2003), Names{});
    EXPECT_EQ(value(dictionary_of(configuration), 0x2003, 0), 0U);
    configuration.switches_object = true;
    EXPECT_EQ(entry_names(dictionary_of(configuration), 0x2003), (Names{"Switch Functions"}));
    configuration.sensor_flags_object = true;
    EXPECT_EQ(entry_names(dictionary_of(configuration), 0x2003),
              (Names{"Switch Functions", "Sensor Error Flags"}));
    EXPECT_EQ(value(dictionary_of(configuration), 0x2003, 0), 2U);
}

TEST(GatewayInputs, have_an_entry_for_every_channel_up_to_the_highest) {
    config::Configuration configuration = test::empty_configuration();
    configuration.sensors = {
        {&test::row::setpoint_1, 1}, {&test::row::setpoint_2, 1}, {&test::row::unnamed_sensor, 3}};
    configuration.highest_channel = 3;
    const Dictionary dictionary = dictionary_of(configuration);
    EXPECT_EQ(entry_names(dictionary, 0x2004),
              (Names{"AssignIn_Setp1Ext", "Unused Channel 2", "Sensor 907"}));
    EXPECT_EQ(value(dictionary, 0x2004, 0), 3U);
    EXPECT_EQ(dictionary.find(0x2004, 0)->high_limit->number, 12U);
}

TEST(GatewayProcessData, has_types_and_access_of_the_rulings) {
    config::Configuration configuration = test::manual_configuration();
    configuration.send_status = true;
    const Dictionary dictionary = dictionary_of(configuration);
    struct Expected {
        std::uint16_t index;
        DataType type;
        Access access;
    };
    for (const Expected& expected : {Expected{0x2000, DataType::unsigned16, Access::ro},
                                     Expected{0x2001, DataType::unsigned16, Access::ro},
                                     Expected{0x2002, DataType::integer16, Access::ro},
                                     Expected{0x2003, DataType::unsigned16, Access::rww},
                                     Expected{0x2004, DataType::unsigned16, Access::rww}}) {
        const Object& object = *dictionary.find(expected.index);
        EXPECT_GT(object.variables.size(), 1U);
        for (const Variable& entry : object.variables) {
            const bool count = entry.sub_index == 0;
            EXPECT_EQ(entry.type, count ? DataType::unsigned8 : expected.type);
            EXPECT_EQ(entry.access, count ? Access::ro : expected.access);
            EXPECT_EQ(entry.pdo_mapping, !count);
            EXPECT_EQ(entry.high_limit.has_value(), count);
            EXPECT_TRUE(count || entry.default_value == dictionary::Value{});
        }
    }
    EXPECT_FALSE(dictionary.find(0x2005, 0)->pdo_mapping);
}

}  // namespace cgw::profile
