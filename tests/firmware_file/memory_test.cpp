#include "firmware_file/memory.hpp"

#include <gtest/gtest.h>

namespace cgw::firmware_file {
namespace {

using Blocks = std::vector<Block>;

Memory two_blocks() {
    Memory memory(0x10, base::Bytes{1, 2, 3, 4});
    memory.append(0x20, base::Bytes{5, 6});
    return memory;
}

TEST(Memory, joins_what_touches) {
    Memory memory = two_blocks();
    memory.append(0x22, base::Bytes{7});
    EXPECT_EQ(memory.blocks(), (Blocks{{0x10, {1, 2, 3, 4}}, {0x20, {5, 6, 7}}}));
    memory.put(0x14, base::Bytes(12, 9));
    ASSERT_EQ(memory.blocks().size(), 1U);
    EXPECT_EQ(memory.blocks()[0].end(), 0x23U);
}

TEST(Memory, puts_bytes_over_and_beside_others) {
    Memory memory = two_blocks();
    memory.put(0x12, base::Bytes{0xAA});
    EXPECT_EQ(memory.blocks()[0], (Block{0x10, {1, 2, 0xAA, 4}}));
    memory.put(0x13, base::Bytes{0xBB, 0xCC});
    EXPECT_EQ(memory.blocks()[0], (Block{0x10, {1, 2, 0xAA, 0xBB, 0xCC}}));
    memory.put(0x0E, base::Bytes{0xD, 0xE, 0xF});
    EXPECT_EQ(memory.blocks()[0], (Block{0x0E, {0xD, 0xE, 0xF, 2, 0xAA, 0xBB, 0xCC}}));
    memory.put(0x18, base::Bytes{1});
    EXPECT_EQ(memory.blocks().size(), 3U);
    memory.put(0x0C, base::Bytes(0x20, 0));
    EXPECT_EQ(memory.blocks(), (Blocks{{0x0C, base::Bytes(0x20, 0)}}));
}

TEST(Memory, gives_the_bytes_from_an_address_to_the_end_of_its_block) {
    const Memory memory = two_blocks();
    EXPECT_EQ(memory.from(0x10).size(), 4U);
    EXPECT_EQ(memory.from(0x13)[0], 4);
    EXPECT_TRUE(memory.from(0x14).empty());
    EXPECT_TRUE(memory.from(0x0F).empty());
    EXPECT_EQ(memory.from(0x21).size(), 1U);
    EXPECT_TRUE(memory.from(0x22).empty());
    EXPECT_TRUE(Memory().from(0).empty());
}

}  // namespace
}  // namespace cgw::firmware_file
