// Values of parameters: types, ranges, lists, what must be there.
#include "input/support.hpp"

namespace cgw {
namespace {

using test::gateway;
using test::gateway_findings;
using test::governor;
using test::governor_findings;
using test::head;
using test::Outcome;
using test::read;
using test::show;

TEST(InputValues, a_value_is_a_number) {
    EXPECT_EQ(governor_findings("4406 = true\n"),
              "E0110 13:8 4406 CanCommCMOn takes a number, not a boolean | write 1");
    EXPECT_EQ(governor_findings("4406 = false\n"),
              "E0110 13:8 4406 CanCommCMOn takes a number, not a boolean | write 0");
    EXPECT_EQ(governor_findings("400 = \"1,0\"\n"),
              "E0110 13:7 400 CanStartTimeOutDelay takes a number, not a string | write 1.0 without quotes");
    EXPECT_EQ(governor_findings("400 = \"soon\"\n"),
              "E0110 13:7 400 CanStartTimeOutDelay takes a number, not a string");
    EXPECT_EQ(governor_findings("400 = 2026-03-01\n"),
              "E0110 13:7 400 CanStartTimeOutDelay takes a number, not a date");
    EXPECT_EQ(governor_findings("400 = {}\n"),
              "E0110 13:7 400 CanStartTimeOutDelay takes a number, not a table");
    EXPECT_EQ(governor_findings("400.5 = 1\n"),
              "E0110 13:1 400 CanStartTimeOutDelay takes a number, not a table");
    EXPECT_EQ(governor_findings("16400 = [2000, [1]]\n"),
              "E0110 13:16 16401 CanOpTPDO4Assign(1) takes a number, not a list");
}

TEST(InputValues, an_integer_may_stand_for_a_decimal_but_not_the_reverse) {
    EXPECT_EQ(governor_findings("400 = 1\n"), "fine");
    EXPECT_EQ(governor_findings("400 = 1.5\n"), "fine");
    EXPECT_EQ(governor_findings("4406 = 1.0\n"), "E0110 13:8 4406 CanCommCMOn takes a whole number, not 1.0");
}

TEST(InputValues, ranges_are_printed_with_their_unit) {
    EXPECT_EQ(governor_findings("400 = 100.5\n"),
              "E0111 13:7 400 CanStartTimeOutDelay is 100.5, outside 0..100 s");
    EXPECT_EQ(governor_findings("400 = -1\n"), "E0111 13:7 400 CanStartTimeOutDelay is -1, outside 0..100 s");
    EXPECT_EQ(governor_findings("4406 = 2\n"), "E0111 13:8 4406 CanCommCMOn is 2, outside 0..1");
    EXPECT_EQ(governor_findings("16460 = 65536\n"),
              "E0111 13:9 16460 CanOpTPDO4-16Cyc(0) is 65536, outside 0..65535");
    EXPECT_EQ(gateway_findings("16404 = 0x800\n"),
              "E0111 13:9 16404 CanOpTPDO5-16ID(0) is 0x800, outside 0..0x7FF");
    EXPECT_EQ(governor_findings("4406 = 9223372036854775807\n"),
              "E0111 13:8 4406 CanCommCMOn is 9223372036854775807, outside 0..1");
}

TEST(InputValues, limits_belong_to_the_range) {
    EXPECT_EQ(governor_findings("400 = 100\n16460 = 65535\n16461 = 0\n"), "fine");
    EXPECT_EQ(gateway_findings("16404 = 0x7FF\n16405 = 0x0\n"), "fine");
}

TEST(InputValues, infinities_and_nan_are_out_of_range) {
    EXPECT_EQ(governor_findings("400 = inf\n"),
              "E0111 13:7 400 CanStartTimeOutDelay is inf, outside 0..100 s");
    EXPECT_EQ(governor_findings("400 = nan\n"),
              "E0111 13:7 400 CanStartTimeOutDelay is nan, outside 0..100 s");
    EXPECT_EQ(governor_findings("4406 = -inf\n"), "E0111 13:8 4406 CanCommCMOn is -inf, outside 0..1");
}

TEST(InputValues, rows_with_one_limit_or_none_are_checked_as_far_as_known) {
    std::vector<parameter::Row> rows = test::make_rows();
    for (parameter::Row& row : rows) {
        if (row.device == parameter::Device::governor && row.number == 400) {
            row.minimum.reset();
        }
        if (row.device == parameter::Device::governor && row.number == 4406) {
            row.maximum.reset();
        }
        if (row.device == parameter::Device::governor && row.number == 4900) {
            row.minimum.reset();
            row.maximum.reset();
            row.decimal = true;
        }
    }
    EXPECT_EQ(show(read(head + gateway + governor + "400 = 101\n4406 = -1\n4900 = inf\n", {}, rows).findings),
              "E0111 13:7 400 CanStartTimeOutDelay is 101, above 100 s\n"
              "E0111 14:8 4406 CanCommCMOn is -1, below 0\n"
              "E0111 15:8 4900 ChanType_Setp1Ext is inf, not a finite number");
}

TEST(InputValues, bit_rates_are_exactly_the_four) {
    const auto rate = [](const char* value) {
        return show(
            read(head + gateway + "[governor.parameters]\n401 = 1\n403 = 1\n416 = " + value + "\n").findings);
    };
    EXPECT_EQ(rate("125"), "fine");
    EXPECT_EQ(rate("1000"), "fine");
    EXPECT_EQ(rate("200"), "E0111 12:7 416 CanBaudrate is 200, none of 125, 250, 500 or 1000 kbit/s");
    EXPECT_EQ(rate("nan"), "E0111 12:7 416 CanBaudrate is nan, none of 125, 250, 500 or 1000 kbit/s");
}

TEST(InputValues, a_list_fills_consecutive_numbers) {
    for (const char* key :
         {"16400", "CanOpTPDO4Assign", "\"CanOpTPDO4Assign(0)\"", "\"16400 CanOpTPDO4Assign(0)\""}) {
        const Outcome outcome = read(head + gateway + governor + key + " = [\n 2000,\n 0x7,\n]\n");
        EXPECT_EQ(show(outcome.findings), "fine") << key;
        EXPECT_EQ(outcome.settings().governor.value(16400), 2000) << key;
        EXPECT_EQ(outcome.settings().governor.value(16401), 7) << key;
        EXPECT_FALSE(outcome.settings().governor.find(16401)->decimal_typed) << key;
        EXPECT_EQ(outcome.settings().governor.find(16401)->where.range.start, (diagnostic::Position{15, 2}))
            << key;
        EXPECT_EQ(outcome.settings().governor.find(16401)->key.range.start, (diagnostic::Position{13, 1}))
            << key;
        EXPECT_EQ(outcome.settings().governor.find(16402), nullptr) << key;
    }
}

TEST(InputValues, a_list_may_begin_in_the_middle_of_its_array) {
    const Outcome outcome = read(head + gateway + governor + "\"CanOpTPDO4-16Cyc(1)\" = [200, 100]\n");
    EXPECT_EQ(show(outcome.findings), "fine");
    EXPECT_EQ(outcome.settings().governor.value(16461), 200);
    EXPECT_EQ(outcome.settings().governor.value(16462), 100);
}

TEST(InputValues, a_list_ends_with_its_array) {
    EXPECT_EQ(governor_findings("16460 = [1, 2, 3, 4, 5]\n"),
              "E0112 13:19 the list has 5 values, but 16460 CanOpTPDO4-16Cyc(0) to 16462 are only 3");
    EXPECT_EQ(governor_findings("16462 = [1,\n2]\n"),
              "E0112 14:1 the list has 2 values, but 16462 CanOpTPDO4-16Cyc(2) to 16462 are only 1");
    const Outcome outcome = read(head + gateway + governor + "16460 = [1, 2, 3, 4]\n");
    EXPECT_EQ(outcome.settings().governor.value(16462), 3);
}

TEST(InputValues, lists_of_tpdo_assignments_run_on_into_the_next_arrays) {
    const Outcome outcome = read(head + gateway + governor + "16400 = [1, 2, 3, 4, 5, 6, 7, 8]\n");
    EXPECT_EQ(show(outcome.findings), "fine");
    EXPECT_EQ(outcome.settings().governor.value(16407), 8);
    EXPECT_EQ(governor_findings("16402 = [1, 2, 3, 4, 5, 6, 7]\n"),
              "E0112 13:28 the list has 7 values, but 16402 CanOpTPDO4Assign(2) to 16407 are only 6");
}

TEST(InputValues, each_element_of_a_list_is_checked) {
    EXPECT_EQ(governor_findings("16400 = [30000, \"x\", 1.5, 4]\n"),
              "E0111 13:10 16400 CanOpTPDO4Assign(0) is 30000, outside 0..29999\n"
              "E0110 13:17 16401 CanOpTPDO4Assign(1) takes a number, not a string\n"
              "E0110 13:22 16402 CanOpTPDO4Assign(2) takes a whole number, not 1.5");
}

TEST(InputValues, a_single_parameter_takes_no_list_and_no_list_is_empty) {
    EXPECT_EQ(governor_findings("4406 = [1]\n"),
              "E0110 13:8 4406 CanCommCMOn takes a single value, not a list");
    EXPECT_EQ(governor_findings("16400 = []\n"), "E0110 13:9 16400 CanOpTPDO4Assign(0) has an empty list");
}

TEST(InputValues, what_is_required_is_missed_at_the_table) {
    EXPECT_EQ(show(read(head + gateway + "\n[governor.parameters]\n400 = 1\n").findings),
              "E0109 10:1 401 CanMyNodeNumber of the governor is missing and has no default | "
              "below [governor.parameters] write 401 = VALUE, where VALUE is 1..31\n"
              "E0109 10:1 403 CanCMNodeNumber of the governor is missing and has no default | "
              "below [governor.parameters] write 403 = VALUE, where VALUE is 1..31\n"
              "E0109 10:1 416 CanBaudrate of the governor is missing and has no default | "
              "set it, or 4416 CanSegmentOrBaudrate = 1 and the bit timing by hand");
    EXPECT_EQ(show(read(head + governor + "[gateway]\nparameters = { 401 = 1 }\n").findings),
              "E0109 8:14 402 CanDCNodeNumber of the gateway is missing and has no default | "
              "below [gateway.parameters] write 402 = VALUE, where VALUE is 1..31\n"
              "E0109 8:14 416 HzmCanBaudrate of the gateway is missing and has no default | "
              "set it, or 4416 HzmCanSegmOrBaudrate = 1 and the bit timing by hand\n"
              "E0109 8:14 426 CanOpenBaudrate of the gateway is missing and has no default | "
              "set it, or 4426 CanOpSegmOrBaudrate = 1 and the bit timing by hand\n"
              "E0109 8:14 427 CanOpenMyNodeID of the gateway is missing and has no default | "
              "below [gateway.parameters] write 427 = VALUE, where VALUE is 1..127");
}

TEST(InputValues, manual_timing_makes_a_bit_rate_optional) {
    EXPECT_EQ(show(read(head + gateway + "[governor.parameters]\n401 = 1\n403 = 1\n4416 = 1\n").findings),
              "fine");
    EXPECT_EQ(
        show(read(head + governor + "[gateway.parameters]\n401 = 1\n402 = 1\n427 = 1\n4416 = 1\n4426 = 1\n")
                 .findings),
        "fine");
    EXPECT_NE(show(read(head + gateway + "[governor.parameters]\n401 = 1\n403 = 1\n4416 = 0\n").findings),
              "fine");
}

TEST(InputValues, a_wrong_value_is_not_reported_as_missing_too) {
    EXPECT_EQ(show(read(head + gateway + "[governor.parameters]\n401 = 32\n403 = 1\n4416 = 2\n").findings),
              "E0111 10:7 401 CanMyNodeNumber is 32, outside 1..31\n"
              "E0111 12:8 4416 CanSegmentOrBaudrate is 2, outside 0..1");
}

TEST(InputValues, a_wrong_value_counts_as_the_first_of_two) {
    EXPECT_EQ(governor_findings("4406 = 2\nCanCommCMOn = 1\n"),
              "E0111 13:8 4406 CanCommCMOn is 2, outside 0..1\n"
              "E0108 14:1 4406 CanCommCMOn is set twice [first set here 13:1]");
}

TEST(InputValues, parameters_must_be_a_table) {
    EXPECT_EQ(show(read(head + gateway + "[governor]\nparameters = [401]\n").findings).substr(0, 57),
              "E0109 0:0 401 CanMyNodeNumber of the governor is missing ");
    EXPECT_NE(show(read(head + gateway + "[governor]\nparameters = [401]\n").findings)
                  .find("E0102 10:14 `parameters` must be a table, not a list"),
              std::string::npos);
}

}  // namespace
}  // namespace cgw
