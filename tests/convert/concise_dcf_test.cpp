#include "convert/concise_dcf.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace cgw::convert {
namespace {

using dictionary::Dictionary;
using dictionary::Value;
using object::Access;
using object::DataType;

struct Entry {
    std::uint8_t sub_index;
    DataType type;
    std::optional<Value> default_value;
    std::optional<Value> value;
    Access access = Access::rw;
};

void add(Dictionary& dictionary, std::uint16_t index, const std::vector<Entry>& entries) {
    dictionary::Object& object = dictionary.objects.emplace_back();
    object.index = index;
    object.code = entries.size() > 1 ? object::ObjectCode::record : object::ObjectCode::var;
    for (const Entry& entry : entries) {
        dictionary::Variable& variable = object.variables.emplace_back();
        variable.sub_index = entry.sub_index;
        variable.type = entry.type;
        variable.access = entry.access;
        variable.no_default = !entry.default_value;
        variable.default_value = entry.default_value.value_or(Value{});
        variable.parameter_value = entry.value;
    }
}

// "1800:1=80000185", least significant byte last.
std::string told(const Dictionary& dictionary, std::uint8_t node_id = 5) {
    std::string text;
    for (const Download& download : downloads(dictionary, node_id)) {
        text += fmt::format("{:04X}:{}=", download.index, download.sub_index);
        for (auto byte = download.data.rbegin(); byte != download.data.rend(); ++byte) {
            text += fmt::format("{:02X}", *byte);
        }
        text += ' ';
    }
    return text;
}

}  // namespace

TEST(ConciseDcf, has_what_can_be_written_and_differs_from_its_default) {
    Dictionary dictionary;
    add(dictionary, 0x1000, {{0, DataType::unsigned32, Value{1}, Value{2}, Access::ro}});
    add(dictionary, 0x1008, {{0, DataType::visible_string, Value{0, false, "a"}, Value{0, false, "bc"}}});
    add(dictionary, 0x1014, {{0, DataType::unsigned32, Value{0x80, true}, Value{0x85}}});
    add(dictionary, 0x1017, {{0, DataType::unsigned16, Value{0}, Value{1000}}});
    add(dictionary, 0x1018, {{0, DataType::unsigned16, Value{0}, Value{7}, Access::constant}});
    add(dictionary, 0x2000, {{0, DataType::integer24, std::nullopt, Value{0xFFFFFE}, Access::wo}});
    add(dictionary, 0x2001, {{0, DataType::unsigned8, Value{3}, std::nullopt}});
    add(dictionary, 0x2002, {{0, DataType::unsigned8, Value{3}, Value{4}}});
    dictionary.objects.back().variables.front().flags = 1;  // not for a download
    EXPECT_EQ(told(dictionary), "1008:0=6362 1017:0=03E8 2000:0=FFFFFE ");
}

TEST(ConciseDcf, switches_a_pdo_off_while_it_changes) {
    Dictionary dictionary;
    add(dictionary, 0x1800,
        {{0, DataType::unsigned8, Value{5}, Value{5}, Access::ro},
         {1, DataType::unsigned32, Value{0x180, true}, Value{0x185}},
         {2, DataType::unsigned8, Value{255}, Value{254}},
         {5, DataType::unsigned16, Value{0}, Value{100}}});
    add(dictionary, 0x1A00,
        {{0, DataType::unsigned8, Value{1}, Value{2}},
         {1, DataType::unsigned32, Value{0x60000108}, Value{0x60000108}},
         {2, DataType::unsigned32, Value{0}, Value{0x60000208}},
         {3, DataType::unsigned32, Value{0}, Value{0x60000308}}});
    EXPECT_EQ(told(dictionary),
              "1800:1=80000185 1A00:0=00 1A00:1=60000108 1A00:2=60000208 1A00:0=02 1800:2=FE 1800:5=0064 "
              "1800:1=00000185 ");
}

TEST(ConciseDcf, leaves_a_pdo_alone_that_does_not_change) {
    Dictionary dictionary;
    add(dictionary, 0x1400,
        {{0, DataType::unsigned8, Value{2}, Value{2}, Access::ro},
         {1, DataType::unsigned32, Value{0x200, true}, Value{0x205}}});
    add(dictionary, 0x1600,
        {{0, DataType::unsigned8, Value{1}, Value{1}},
         {1, DataType::unsigned32, Value{0x62000108}, Value{0x62000108}}});
    EXPECT_EQ(told(dictionary), "");
    dictionary.objects[0].variables[1].parameter_value = Value{0x80000205};
    EXPECT_EQ(told(dictionary), "1400:1=80000205 ") << "switched off and not on again";
}

TEST(ConciseDcf, writes_a_mapping_of_which_nothing_else_can_be_written) {
    Dictionary dictionary;
    add(dictionary, 0x1A01,
        {{0, DataType::unsigned8, Value{1}, Value{1}, Access::ro},
         {1, DataType::unsigned32, Value{0}, Value{0x60000108}}});
    EXPECT_EQ(told(dictionary), "1A01:1=60000108 ");
    add(dictionary, 0x1801,
        {{0, DataType::unsigned8, Value{1}, Value{1}, Access::ro},
         {1, DataType::unsigned32, Value{0x280}, Value{0x280}, Access::ro}});
    std::swap(dictionary.objects[0], dictionary.objects[1]);
    EXPECT_EQ(told(dictionary), "1A01:1=60000108 ");
}

TEST(ConciseDcf, empties_a_mapping) {
    Dictionary dictionary;
    add(dictionary, 0x1400,
        {{0, DataType::unsigned8, Value{2}, Value{2}, Access::ro},
         {1, DataType::unsigned32, Value{0x200, true}, std::nullopt}});
    add(dictionary, 0x1600,
        {{0, DataType::unsigned8, Value{1}, Value{0}},
         {1, DataType::unsigned32, Value{0x62000108}, Value{0}}});
    EXPECT_EQ(told(dictionary), "1400:1=80000205 1600:0=00 1400:1=00000205 ");
}

TEST(ConciseDcf, lays_its_bytes_out_as_object_1F22h_has_them) {
    const std::vector<Download> two{{0x1017, 0, {0xE8, 0x03}}, {0x2A0B, 0x10, {0x55}}};
    const base::Bytes expected{2,    0,    0,    0,    0x17, 0x10, 0, 2, 0, 0,   0,
                               0xE8, 0x03, 0x0B, 0x2A, 0x10, 1,    0, 0, 0, 0x55};
    EXPECT_EQ(concise_dcf(two), expected);
    EXPECT_EQ(concise_dcf({}), (base::Bytes{0, 0, 0, 0}));
}

}  // namespace cgw::convert
