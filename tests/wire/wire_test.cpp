#include <gtest/gtest.h>

#include <array>
#include <string_view>

#include "wire/crc32.hpp"
#include "wire/little_endian.hpp"
#include "wire/search.hpp"

namespace cgw::wire {
namespace {

std::uint32_t crc_of(std::string_view text) {
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    return crc32(bytes);
}

TEST(Crc32, gives_the_published_check_value) {
    EXPECT_EQ(crc_of("123456789"), 0xCBF43926U);
}

TEST(Crc32, of_nothing_is_0) {
    EXPECT_EQ(crc32({}), 0U);
}

TEST(Crc32, agrees_with_known_values) {
    EXPECT_EQ(crc_of("a"), 0xE8B7BE43U);
    EXPECT_EQ(crc_of("The quick brown fox jumps over the lazy dog"), 0x414FA339U);
    EXPECT_EQ(crc32(std::vector<std::uint8_t>(32, 0x00)), 0x190A55ADU);
    EXPECT_EQ(crc32(std::vector<std::uint8_t>(32, 0xFF)), 0xFF6CAB0BU);
}

TEST(Crc32, agrees_with_the_definition_bit_by_bit) {
    std::vector<std::uint8_t> bytes;
    for (unsigned i = 0; i < 256; ++i) {
        bytes.push_back(static_cast<std::uint8_t>(i * 7));
        std::uint32_t crc = 0xFFFFFFFF;
        for (const std::uint8_t byte : bytes) {
            crc ^= byte;
            for (int bit = 0; bit < 8; ++bit) {
                crc = (crc >> 1) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
            }
        }
        ASSERT_EQ(crc32(bytes), ~crc) << bytes.size();
    }
}

TEST(LittleEndian, loads_the_low_byte_first) {
    const std::array<std::uint8_t, 4> bytes{0x78, 0x56, 0x34, 0xF2};
    EXPECT_EQ(load_u16(bytes.data()), 0x5678);
    EXPECT_EQ(load_u32(bytes.data()), 0xF2345678U);
}

TEST(LittleEndian, stores_the_low_byte_first) {
    std::array<std::uint8_t, 6> bytes{};
    store_u16(bytes.data(), 0xF234);
    store_u32(bytes.data() + 2, 0x89ABCDEF);
    EXPECT_EQ(bytes, (std::array<std::uint8_t, 6>{0x34, 0xF2, 0xEF, 0xCD, 0xAB, 0x89}));
}

TEST(LittleEndian, needs_no_alignment) {
    alignas(8) std::array<std::uint8_t, 12> bytes{};
    for (std::size_t offset = 0; offset < 8; ++offset) {
        store_u32(&bytes[offset], 0xDEADBEEF);
        EXPECT_EQ(load_u32(&bytes[offset]), 0xDEADBEEFU) << offset;
        store_u16(&bytes[offset], 0x8001);
        EXPECT_EQ(load_u16(&bytes[offset]), 0x8001) << offset;
    }
}

TEST(LittleEndian, works_at_compile_time) {
    constexpr std::uint8_t bytes[] = {1, 2, 3, 4};
    static_assert(load_u16(bytes) == 0x0201);
    static_assert(load_u32(bytes) == 0x04030201);
    SUCCEED();
}

TEST(Search, finds_a_value_where_it_is) {
    constexpr std::array<std::uint8_t, 3> bytes = {3, 1, 2};
    EXPECT_TRUE(contains(bytes, 3));
    EXPECT_TRUE(contains(bytes, 2));
    EXPECT_FALSE(contains(bytes, 0));
    EXPECT_FALSE(contains(std::array<std::uint8_t, 0>{}, 0));
}

TEST(Search, sees_one_byte_that_is_not_zero) {
    EXPECT_TRUE(all_zero(std::array<std::uint8_t, 0>{}));
    for (std::size_t i = 0; i < 5; ++i) {
        std::array<std::uint8_t, 5> bytes{};
        EXPECT_TRUE(all_zero(bytes));
        bytes[i] = 0x80;
        EXPECT_FALSE(all_zero(bytes)) << i;
    }
}

}  // namespace
}  // namespace cgw::wire
