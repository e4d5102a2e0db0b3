#include "object/object_table.hpp"

#include <gtest/gtest.h>

#include <array>
#include <span>

namespace cgw::object {
namespace {

ObjectEntry entry(std::uint16_t index, std::uint8_t sub_index) {
    ObjectEntry result;
    result.index = index;
    result.sub_index = sub_index;
    return result;
}

// Records of `record_size` bytes; what is beyond the layout's size is FFh. `lead` bytes stand before them.
std::vector<std::uint8_t> records_of(const std::vector<ObjectEntry>& entries,
                                     std::size_t record_size = object_record_size, std::size_t lead = 0) {
    std::vector<std::uint8_t> bytes(lead, 0xFF);
    for (const ObjectEntry& from : entries) {
        const auto record = encode(from);
        bytes.insert(bytes.end(), record.begin(), record.end());
        bytes.resize(bytes.size() + record_size - object_record_size, 0xFF);
    }
    return bytes;
}

const std::vector<ObjectEntry> sample = {entry(0x1000, 0), entry(0x1018, 0), entry(0x1018, 1),
                                         entry(0x1018, 4), entry(0x2000, 2), entry(0xFFFF, 255)};

TEST(ObjectRecord, stands_byte_by_byte_as_documented) {
    const ObjectEntry from{0x1A03, 0x04, DataType::unsigned32, Access::constant, flag_sdo_read_only, 0x1234,
                           4,      7};
    EXPECT_EQ(encode(from),
              (std::array<std::uint8_t, object_record_size>{0x03, 0x1A, 0x04, 0x07, 0x25, 0x07, 0x34, 0x12}));
}

TEST(ObjectRecord, comes_back_as_it_was) {
    const ObjectEntry from{0xFFFE, 0xFD, DataType::integer16, Access::rww, 3, 0xFFFC, 2, 255};
    EXPECT_EQ(decode_object_record(encode(from).data()), from);
}

TEST(ObjectTable, finds_every_entry) {
    const auto bytes = records_of(sample);
    const ObjectTable table(bytes);
    ASSERT_EQ(table.size(), sample.size());
    for (std::size_t i = 0; i < sample.size(); ++i) {
        EXPECT_EQ(table.entry(i), sample[i]);
        const ObjectTable::Lookup lookup = table.find(sample[i].index, sample[i].sub_index);
        EXPECT_EQ(lookup.found, Found::yes) << i;
        EXPECT_EQ(lookup.entry, sample[i]) << i;
    }
}

TEST(ObjectTable, tells_a_missing_sub_index_from_a_missing_object) {
    const auto bytes = records_of(sample);
    const ObjectTable table(bytes);
    EXPECT_EQ(table.find(0x1000, 1).found, Found::no_sub_index);
    EXPECT_EQ(table.find(0x1018, 2).found, Found::no_sub_index);
    EXPECT_EQ(table.find(0x1018, 255).found, Found::no_sub_index);
    EXPECT_EQ(table.find(0x2000, 0).found, Found::no_sub_index);
    EXPECT_EQ(table.find(0x2000, 3).found, Found::no_sub_index);
    EXPECT_EQ(table.find(0xFFFF, 0).found, Found::no_sub_index);
    EXPECT_EQ(table.find(0x0000, 0).found, Found::no_object);
    EXPECT_EQ(table.find(0x0FFF, 255).found, Found::no_object);
    EXPECT_EQ(table.find(0x1001, 0).found, Found::no_object);
    EXPECT_EQ(table.find(0x1FFF, 2).found, Found::no_object);
    EXPECT_EQ(table.find(0x2001, 0).found, Found::no_object);
}

TEST(ObjectTable, is_searched_to_the_same_place_with_any_guess) {
    const auto bytes = records_of(sample);
    const ObjectTable objects(bytes);
    for (std::size_t guess = 0; guess < objects.size() + 3; ++guess) {
        for (std::size_t position = 0; position < objects.size(); ++position) {
            const ObjectEntry entry = objects.entry(position);
            const ObjectTable::Place place = objects.locate(entry.index, entry.sub_index, guess);
            EXPECT_EQ(place.found, Found::yes);
            EXPECT_EQ(place.position, position);
        }
        EXPECT_EQ(objects.locate(0x7FFF, 0, guess).found, Found::no_object);
    }
    EXPECT_EQ(ObjectTable().locate(0x1000, 0, 0).found, Found::no_object);
}

TEST(ObjectTable, of_nothing_finds_nothing) {
    EXPECT_EQ(ObjectTable().size(), 0U);
    EXPECT_EQ(ObjectTable().find(0x1000, 0).found, Found::no_object);
    EXPECT_EQ(ObjectTable(std::span<const std::uint8_t>()).find(0x1000, 0).found, Found::no_object);
}

TEST(ObjectTable, reads_records_at_any_alignment) {
    for (std::size_t lead = 1; lead < 8; ++lead) {
        const auto bytes = records_of(sample, object_record_size, lead);
        const ObjectTable table(std::span<const std::uint8_t>(bytes).subspan(lead));
        EXPECT_EQ(table.find(0x1018, 4).entry, sample[3]) << lead;
    }
}

TEST(ObjectTable, reads_records_that_a_later_format_lengthened) {
    const auto bytes = records_of(sample, 15);
    const ObjectTable table(bytes, 15);
    EXPECT_EQ(table.size(), sample.size());
    EXPECT_EQ(table.find(0x2000, 2).entry, sample[4]);
    EXPECT_EQ(table.find(0x2000, 1).found, Found::no_sub_index);
}

TEST(ObjectTable, ignores_bytes_after_the_last_whole_record) {
    auto bytes = records_of(sample);
    bytes.resize(bytes.size() + object_record_size - 1);
    EXPECT_EQ(ObjectTable(bytes).size(), sample.size());
}

TEST(ObjectValues, are_little_endian_and_touch_nothing_else) {
    std::vector<std::uint8_t> values(8, 0xEE);
    ObjectEntry place = entry(0x2001, 1);
    place.offset = 1;
    place.length = 4;
    store_value(values, place, 0x89ABCDEF);
    EXPECT_EQ(values, (std::vector<std::uint8_t>{0xEE, 0xEF, 0xCD, 0xAB, 0x89, 0xEE, 0xEE, 0xEE}));
    EXPECT_EQ(load_value(values, place), 0x89ABCDEFU);
    place.offset = 6;
    place.length = 2;
    store_value(values, place, 0xFFFF1234);
    EXPECT_EQ(load_value(values, place), 0x1234U);
    EXPECT_EQ(values[5], 0xEE);
    place.offset = 7;
    place.length = 1;
    EXPECT_EQ(load_value(values, place), 0x12U);
}

TEST(DataTypes, have_the_size_and_sign_of_cia_301) {
    EXPECT_EQ(size_of(DataType::boolean), 1);
    EXPECT_EQ(size_of(DataType::integer8), 1);
    EXPECT_EQ(size_of(DataType::unsigned8), 1);
    EXPECT_EQ(size_of(DataType::integer16), 2);
    EXPECT_EQ(size_of(DataType::unsigned16), 2);
    EXPECT_EQ(size_of(DataType::integer32), 4);
    EXPECT_EQ(size_of(DataType::unsigned32), 4);
    EXPECT_EQ(size_of(static_cast<DataType>(0x08)), 0);
    EXPECT_TRUE(is_signed(DataType::integer16));
    EXPECT_FALSE(is_signed(DataType::unsigned16));
    EXPECT_FALSE(is_signed(DataType::boolean));
}

}  // namespace
}  // namespace cgw::object
