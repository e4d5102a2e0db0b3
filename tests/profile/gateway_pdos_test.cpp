// 1400h–1A0Fh: identifiers, times and mappings (D20–D31, D43).
#include <gtest/gtest.h>

#include "profile/gateway.hpp"
#include "support/sample_configuration.hpp"

namespace cgw::profile {
namespace {

using dictionary::Dictionary;
using dictionary::Value;

Dictionary dictionary_of(const config::Configuration& configuration) {
    return gateway_dictionary(configuration, GatewayDocument{});
}

Value value(const Dictionary& dictionary, std::uint16_t index, std::uint8_t sub_index) {
    const dictionary::Variable* const variable = dictionary.find(index, sub_index);
    return variable != nullptr ? variable->default_value : Value{0xDEADBEEF, false};
}

// Sub 0 and all entries of a mapping object.
std::vector<std::uint64_t> mapping(const Dictionary& dictionary, std::uint16_t index) {
    std::vector<std::uint64_t> values;
    for (const dictionary::Variable& entry : dictionary.find(index)->variables) {
        values.push_back(entry.default_value.number);
    }
    return values;
}

using Values = std::vector<std::uint64_t>;

}  // namespace

TEST(GatewayPdoIdentifiers, keep_bit_31_while_inactive) {
    const Dictionary dictionary = dictionary_of(test::empty_configuration());
    EXPECT_EQ(value(dictionary, 0x1400, 1), (Value{0x80000200, true}));
    EXPECT_EQ(value(dictionary, 0x1403, 1), (Value{0x80000500, true}));
    EXPECT_EQ(value(dictionary, 0x1800, 1), (Value{0x80000180, true}));
    EXPECT_EQ(value(dictionary, 0x1803, 1), (Value{0x80000480, true}));
    EXPECT_EQ(value(dictionary, 0x1804, 1), (Value{0x80000000, false}));
}

TEST(GatewayPdoIdentifiers, are_relative_when_predefined_and_absolute_when_set) {
    const Dictionary dictionary = dictionary_of(test::manual_configuration());
    EXPECT_EQ(value(dictionary, 0x1400, 1), (Value{0x200, true}));
    EXPECT_EQ(value(dictionary, 0x1800, 1), (Value{0x180, true}));
    EXPECT_EQ(value(dictionary, 0x1802, 1), (Value{0x80000380, true}));
    EXPECT_EQ(value(dictionary, 0x1803, 1), (Value{0x480, true}));
    EXPECT_EQ(value(dictionary, 0x1804, 1), (Value{0x80000282, false}));
    EXPECT_EQ(value(dictionary, 0x180B, 1), (Value{0x80000003, false}));
    EXPECT_EQ(value(dictionary, 0x180F, 1), (Value{0x57F, false}));
}

TEST(GatewayPdoParameters, are_those_of_the_printed_eds) {
    const Dictionary dictionary = dictionary_of(test::manual_configuration());
    const dictionary::Object& object = *dictionary.find(0x180C);
    EXPECT_EQ(object.name, "TPDO13 Communication Parameter");
    const std::vector<std::string> names{"Number of Entries",   "COB-ID",
                                         "Transmission Type",   "Inhibit Time",
                                         "Compatibility Entry", "Event Timer"};
    ASSERT_EQ(object.variables.size(), names.size());
    for (std::size_t sub = 0; sub < names.size(); ++sub) {
        EXPECT_EQ(object.variables[sub].name, names[sub]);
        EXPECT_EQ(object.variables[sub].sub_index, sub);
        EXPECT_EQ(object.variables[sub].access, object::Access::ro);
    }
    EXPECT_EQ(value(dictionary, 0x180C, 0).number, 5U);
    EXPECT_EQ(value(dictionary, 0x180C, 2).number, 254U);
    EXPECT_EQ(dictionary.find(0x1603)->name, "RPDO4 Mapping Parameter");
}

TEST(GatewayPdoTimes, are_floored_milliseconds_of_active_pdos) {
    const Dictionary dictionary = dictionary_of(test::manual_configuration());
    EXPECT_EQ(value(dictionary, 0x1803, 5).number, 15U);
    EXPECT_EQ(value(dictionary, 0x1805, 5).number, 0U) << "TPDO6 has a time and is inactive";
    EXPECT_EQ(value(dictionary, 0x180F, 5).number, 93U);
    EXPECT_EQ(value(dictionary, 0x1800, 5).number, 0U);
    EXPECT_EQ(value(dictionary, 0x1400, 5).number, 0U);
    EXPECT_EQ(value(dictionary, 0x1401, 5).number, 93U);
    EXPECT_EQ(value(dictionary, 0x1402, 5).number, 187U);
    EXPECT_EQ(value(dictionary, 0x1403, 5).number, 1000U);
}

TEST(GatewayPdoTimes, leave_out_the_monitoring_of_inactive_rpdos) {
    config::Configuration configuration = test::empty_configuration();
    test::rpdo(configuration, 2).time = {100, 6, 93750};
    EXPECT_EQ(value(dictionary_of(configuration), 0x1401, 5).number, 0U);
}

TEST(GatewayPdoMapping, has_all_entries_with_unused_ones_0) {
    const Dictionary dictionary = dictionary_of(test::empty_configuration());
    EXPECT_EQ(mapping(dictionary, 0x1600), (Values{0, 0, 0, 0}));
    EXPECT_EQ(mapping(dictionary, 0x1601), (Values{0, 0, 0, 0, 0}));
    EXPECT_EQ(mapping(dictionary, 0x1A00), (Values{0, 0, 0, 0, 0}));
    EXPECT_EQ(mapping(dictionary, 0x1A01), (Values{0, 0, 0}));
    EXPECT_EQ(mapping(dictionary, 0x1A02), (Values{0, 0}));
    EXPECT_EQ(mapping(dictionary, 0x1A0F), (Values{0, 0, 0, 0, 0}));
    EXPECT_EQ(dictionary.find(0x1A0F, 4)->name, "Mapped Object 4");
    EXPECT_EQ(dictionary.find(0x1600, 0)->high_limit->number, 3U);
    EXPECT_EQ(dictionary.find(0x1A01, 0)->high_limit->number, 2U);
}

TEST(GatewayPdoMapping, holds_the_manuals_example) {
    const Dictionary dictionary = dictionary_of(test::manual_configuration());
    EXPECT_EQ(mapping(dictionary, 0x1A00), (Values{4, 0x20000110, 0x20000210, 0x20000310, 0x20000410}));
    EXPECT_EQ(mapping(dictionary, 0x1A01), (Values{2, 0x20000510, 0x20000610}));
    EXPECT_EQ(mapping(dictionary, 0x1A02), (Values{0, 0}));
    EXPECT_EQ(mapping(dictionary, 0x1A03), (Values{4, 0x20010110, 0x20010210, 0x20010310, 0x20010410}));
    EXPECT_EQ(mapping(dictionary, 0x1A0F), (Values{3, 0x20010510, 0x20020110, 0x20010610, 0}));
    EXPECT_EQ(mapping(dictionary, 0x1600), (Values{3, 0x20030110, 0x00060010, 0x20030210}));
    EXPECT_EQ(mapping(dictionary, 0x1601), (Values{2, 0x20040110, 0x20040210, 0, 0}));
    EXPECT_EQ(mapping(dictionary, 0x1602), (Values{3, 0x00060010, 0x00060010, 0x20040710, 0}));
    EXPECT_EQ(mapping(dictionary, 0x1603), (Values{4, 0x00060010, 0x00060010, 0x00060010, 0x20040C10}));
}

TEST(GatewayPdoMapping, holds_the_engine_state_in_tpdo3) {
    config::Configuration configuration = test::empty_configuration();
    configuration.send_status = true;
    test::tpdo(configuration, 3).active = true;
    test::tpdo(configuration, 3).mapping = {
        {config::WordKind::engine_state, config::object::errors, config::object::engine_state_sub, nullptr}};
    const Dictionary dictionary = dictionary_of(configuration);
    EXPECT_EQ(mapping(dictionary, 0x1A02), (Values{1, 0x20000710}));
    EXPECT_EQ(value(dictionary, 0x1802, 1), (Value{0x380, true}));
}

}  // namespace cgw::profile
