#include "dictionary/data_types.hpp"

#include <gtest/gtest.h>

namespace cgw::dictionary {

TEST(DataTypes, are_found_by_their_numbers_and_by_no_others) {
    std::size_t found = 0;
    for (std::uint64_t number = 0; number < 0x400; ++number) {
        if (const TypeRow* const row = find_type(number)) {
            ++found;
            EXPECT_EQ(static_cast<std::uint64_t>(row->type), number);
            EXPECT_EQ(&row_of(row->type), row);
        }
    }
    EXPECT_EQ(found, data_types().size());
    for (const std::uint64_t number : {0x00U, 0x0EU, 0x17U, 0x1CU, 0x24U, 0xFFFFFFFFU}) {
        EXPECT_EQ(find_type(number), nullptr) << number;
    }
}

TEST(DataTypes, agree_with_the_core_on_the_length_of_those_it_carries) {
    for (const TypeRow& row : data_types()) {
        const std::size_t carried = object::size_of(row.type);
        EXPECT_TRUE(carried == 0 || carried == (row.bits + 7) / 8) << row.name;
    }
    EXPECT_EQ(row_of(object::DataType::unsigned24).bits, 24U);
}

}  // namespace cgw::dictionary
