#include "eds/number.hpp"

#include <gtest/gtest.h>

namespace cgw::eds {
namespace {

using Reading = Number::Reading;

struct Row {
    std::string_view text;
    std::uint64_t magnitude;
};

}  // namespace

TEST(EdsNumber, reads_decimal_hexadecimal_and_octal) {
    for (const Row& row : {Row{"0", 0}, Row{"9", 9}, Row{"255", 255}, Row{"0x1a", 26}, Row{"0XFF", 255},
                           Row{"001", 1}, Row{"017", 15}, Row{"18446744073709551615", ~std::uint64_t{0}},
                           Row{"0xFFFFFFFFFFFFFFFF", ~std::uint64_t{0}}}) {
        const Number number = parse_number(row.text);
        EXPECT_EQ(number.reading, Reading::number) << row.text;
        EXPECT_EQ(number.magnitude, row.magnitude) << row.text;
        EXPECT_FALSE(number.loose || number.misplaced || number.negative || number.node_id_relative)
            << row.text;
    }
    EXPECT_TRUE(parse_number("-128").negative);
    EXPECT_EQ(parse_number("-128").magnitude, 128U);
}

TEST(EdsNumber, tells_what_is_no_number) {
    for (const std::string_view text : {"",
                                        "-",
                                        "+",
                                        "0x",
                                        "x",
                                        "08",
                                        "1 2",
                                        "5,0",
                                        "1.5",
                                        "0xG",
                                        "LL",
                                        "0x0x",
                                        "$",
                                        "$NODE",
                                        "$NODEID+",
                                        "+$NODEID",
                                        "$NODEID$NODEID",
                                        "$NODEID+$NODEID",
                                        "$NODEID-1",
                                        "$NODEID+-1",
                                        "1+2$"}) {
        EXPECT_EQ(parse_number(text).reading, Reading::none) << text;
    }
}

TEST(EdsNumber, tells_what_is_too_large) {
    for (const std::string_view text : {"18446744073709551616", "0x10000000000000000",
                                        "99999999999999999999999999", "$NODEID+0xFFFFFFFFFFFFFFFF+1"}) {
        EXPECT_EQ(parse_number(text).reading, Reading::too_large) << text;
    }
}

TEST(EdsNumber, reads_loose_forms_and_says_so) {
    for (const Row& row : {Row{"0x0x00001B59", 0x1B59}, Row{"0x12LL", 0x12}, Row{"5u", 5}, Row{"+7", 7}}) {
        const Number number = parse_number(row.text);
        EXPECT_EQ(number.reading, Reading::number) << row.text;
        EXPECT_EQ(number.magnitude, row.magnitude) << row.text;
        EXPECT_TRUE(number.loose) << row.text;
    }
}

TEST(EdsNumber, reads_formulas_wherever_the_node_number_stands) {
    EXPECT_FALSE(parse_number("$NODEID").misplaced);
    EXPECT_FALSE(parse_number("$NODEID+0x180").misplaced);
    for (const std::string_view text :
         {"0x180+$NODEID", "$NodeID + 0x180", "$NODEID +384", "$nodeid+0x180", "0x80+$NODEID+0x100"}) {
        const Number number = parse_number(text);
        EXPECT_EQ(number.reading, Reading::number) << text;
        EXPECT_TRUE(number.node_id_relative && number.misplaced) << text;
        EXPECT_EQ(number.magnitude, 0x180U) << text;
    }
}

}  // namespace cgw::eds
