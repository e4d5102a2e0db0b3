// Catalogue files: every mistake is a finding with its place.
#include "catalogue/read_catalogue.hpp"

namespace {

using cgw::parameter::Device;
using cgw::test::governor;
using cgw::test::torque;

using ReadCatalogueFindings = cgw::test::ReadCatalogue;

TEST_F(ReadCatalogueFindings, refuses_what_is_not_a_catalogue) {
    EXPECT_EQ(file("[[row]]\nnumber = 1\n"), "0:0 key-missing: `device` is missing\n");
    EXPECT_EQ(file("device = 1\n"), "1:10 key-type: `device` is a string, not an integer\n");
    EXPECT_EQ(file("device = \"motor\"\n"),
              "1:10 key-value: device `motor` is neither \"governor\" nor \"gateway\"\n");
    EXPECT_EQ(file(governor + "profile = \"native\"\n"),
              "2:11 key-value: unknown profile `native` of a governor\n");
    EXPECT_EQ(file(governor + "profile = 2\n"), "2:11 key-type: `profile` is a string, not an integer\n");
    EXPECT_EQ(file(governor + "rows = []\n"), "2:1 key-unknown: unknown key `rows`\n");
    EXPECT_EQ(findings.all()[0].help, "did you mean `row`?");
    EXPECT_EQ(file(governor + "row = 1\n"), "2:7 key-type: `row` is a list, not an integer\n");
    EXPECT_EQ(file(governor + "row = [1]\n"), "2:8 key-type: a row is a table, not an integer\n");
}

TEST_F(ReadCatalogueFindings, places_findings_in_the_file_it_was_told) {
    row("number = 0");
    ASSERT_EQ(findings.all().size(), 1U);
    EXPECT_EQ(findings.all()[0].where.path, "more.toml");
    EXPECT_EQ(findings.all()[0].where.range.end.column, 11U);
}

TEST_F(ReadCatalogueFindings, names_unknown_cells_with_the_nearest_known_one) {
    EXPECT_EQ(row(torque + "bit = true\nuint = \"%\""), "7:1 key-unknown: unknown key `uint`\n");
    EXPECT_EQ(findings.all()[0].help, "did you mean `unit`?");
}

TEST_F(ReadCatalogueFindings, refuses_cells_of_a_wrong_type) {
    EXPECT_EQ(row("number = \"2990\""), "3:10 key-type: `number` is an integer, not a string\n");
    EXPECT_EQ(row(torque + "width = 16.0\nsigned = 1"),
              "6:9 key-type: `width` is an integer, not a decimal number\n"
              "7:10 key-type: `signed` is a boolean, not an integer\n");
    EXPECT_EQ(row("number = 2991\nname = 5\nkind = \"parameter\""),
              "4:8 key-type: `name` is a string, not an integer\n");
    EXPECT_EQ(row("number = 2992\nkind = \"parameter\"\nrange = 5"),
              "5:9 key-type: `range` is a list, not an integer\n");
    EXPECT_EQ(row("number = 2993\nkind = \"parameter\"\nrange = [\"a\", 2]"),
              "5:10 key-type: a limit of `range` is a number, not a string\n");
    EXPECT_EQ(row("number = 2994\nkind = \"parameter\"\nname = \"X\"\naliases = [1]"),
              "6:12 key-type: an alias is a string, not an integer\n");
}

TEST_F(ReadCatalogueFindings, asks_for_what_is_missing) {
    EXPECT_EQ(row("name = \"X\""), "2:1 key-missing: `number` is missing\n");
    EXPECT_EQ(row("number = 2990\nname = \"X1\""), "2:1 key-missing: `kind` of 2990 is missing\n");
    EXPECT_EQ(row("number = 2991\nkind = \"measurement\"\nbit = true"),
              "2:1 key-missing: `name` of 2991 is missing\n");
    EXPECT_EQ(row("number = 2992\nkind = \"measurement\"\nname = \"X2\""),
              "2:1 key-missing: `width` of 2992 is missing\n");
    EXPECT_EQ(row("number = 2993\nkind = \"measurement\"\nname = \"X3\"\nwidth = 8"),
              "2:1 key-missing: `signed` of 2993 is missing\n");
    EXPECT_EQ(row("number = 2994\nkind = \"measurement\"\nname = \"X4\"\nwidth = 8\nsigned = false\nexternal "
                  "= [0, 1]"),
              "2:1 key-missing: `internal` of 2994 is missing\n");
    EXPECT_EQ(row("number = 2995\nkind = \"measurement\"\nname = \"X5\"\nbit = false"),
              "2:1 key-missing: `width` of 2995 is missing\n");
}

TEST_F(ReadCatalogueFindings, refuses_numbers_outside_1_to_29999) {
    EXPECT_EQ(row("number = 0"), "3:10 declaration-invalid: number 0 is outside 1..29999\n");
    EXPECT_EQ(row("number = 30000"), "3:10 declaration-invalid: number 30000 is outside 1..29999\n");
    EXPECT_EQ(row("number = -1"), "3:10 declaration-invalid: number -1 is outside 1..29999\n");
    EXPECT_EQ(row("number = 9223372036854775807"),
              "3:10 declaration-invalid: number 9223372036854775807 is outside 1..29999\n");
    EXPECT_EQ(row("number = 29999\nname = \"Last\"\nkind = \"parameter\""), "");
    EXPECT_EQ(row("number = 1\nname = \"First\"\nkind = \"parameter\""), "");
}

TEST_F(ReadCatalogueFindings, refuses_a_number_that_stands_twice_and_shows_both_places) {
    EXPECT_EQ(file(governor + "[[row]]\nnumber = 7000\nname = \"A\"\ncount = 3\nkind = \"curve\"\n"
                              "[[row]]\nnumber = 7002\nname = \"B\"\nkind = \"curve\"\n"),
              "8:10 declaration-invalid: number 7002 stands here twice\n");
    ASSERT_EQ(findings.all()[0].related.size(), 1U);
    EXPECT_EQ(findings.all()[0].related[0].where.range.start.line, 3U);
    EXPECT_EQ(file(governor + "[[row]]\nnumber = 7100\nlast = 7110\nkind = \"curve\"\n"
                              "[[row]]\nnumber = 7110\nlast = 7120\nkind = \"curve\"\n"),
              "7:10 declaration-invalid: number 7110 stands here twice\n");
}

TEST_F(ReadCatalogueFindings, refuses_a_name_that_another_number_has) {
    EXPECT_EQ(row("number = 7000\nname = \"speed\"\nkind = \"curve\""),
              "4:8 declaration-invalid: the name speed belongs to 2000 already\n");
    EXPECT_EQ(row("number = 7001\nname = \"Fine\"\nkind = \"curve\"\naliases = [\"CanBaudrate\"]"),
              "6:11 declaration-invalid: the name CanBaudrate belongs to 416 already\n");
    EXPECT_EQ(row("number = 7002\nname = \"Speed\"\ncount = 2\nkind = \"curve\""),
              "4:8 declaration-invalid: the name Speed belongs to 2000 already\n");
    EXPECT_EQ(row("number = 7005\nname = \"CanOpRPDO1-4Cyc\"\nkind = \"curve\""),
              "4:8 declaration-invalid: the name CanOpRPDO1-4Cyc belongs to 16480 already\n");
    EXPECT_EQ(find(7000)->name, "");  // its number stays usable
    EXPECT_EQ(find(7002), nullptr);
    EXPECT_EQ(row("number = 401\naliases = [\"CanBaudrate\"]"),
              "4:11 declaration-invalid: the name CanBaudrate belongs to 416 already\n");
    EXPECT_EQ(find(401)->name, "CanMyNodeNumber");
}

TEST_F(ReadCatalogueFindings, refuses_names_that_could_be_taken_for_something_else) {
    for (const std::string name : {"", "401", "4Fine", "Two Words", "Element(1)", "Größe", "a\\\"b"}) {
        row("number = 7000\nkind = \"curve\"\nname = \"" + name + "\"");
        ASSERT_EQ(findings.all().size(), 1U) << name;
        EXPECT_EQ(findings.all()[0].rule->name, "declaration-invalid");
    }
    EXPECT_EQ(row("number = 7001\nkind = \"curve\"\nname = \"CanOp:TPDO1-4_x.y/z\""), "");
    EXPECT_EQ(row("number = 7002\nkind = \"curve\"\nname = \"" + std::string(64, 'n') + "\""), "");
    EXPECT_NE(row("number = 7003\nkind = \"curve\"\nname = \"" + std::string(65, 'n') + "\""), "");
}

TEST_F(ReadCatalogueFindings, refuses_words_it_does_not_know) {
    EXPECT_EQ(row("number = 7000\nkind = \"meassurement\"\nwidth = 16\nname = \"X\""),
              "4:8 key-value: unknown kind `meassurement`\n");
    EXPECT_EQ(row("number = 7001\nkind = \"curve\"\nbase = \"octal\""),
              "5:8 key-value: base `octal` is neither \"decimal\" nor \"hexadecimal\"\n");
}

TEST_F(ReadCatalogueFindings, knows_switches_and_sensors_by_their_numbers) {
    EXPECT_EQ(row("number = 850\nname = \"FunctX\"\nkind = \"switch\""),
              "5:8 declaration-invalid: 850 is no switch: its numbers are 810..849 and 4810..4849 of the "
              "governor\n");
    EXPECT_EQ(file("device = \"gateway\"\n[[row]]\nnumber = 815\nname = \"FunctX\"\nkind = \"switch\"\n"),
              "5:8 declaration-invalid: 815 is no switch: its numbers are 810..849 and 4810..4849 of the "
              "governor\n");
}

TEST_F(ReadCatalogueFindings, refuses_levels_units_and_texts_that_cannot_be) {
    const std::string curve = "number = 7000\nkind = \"curve\"\n";
    EXPECT_EQ(row(curve + "level = 8"), "5:9 declaration-invalid: level 8 is outside 1..7\n");
    EXPECT_EQ(row("number = 7001\nkind = \"curve\"\nunit = \"\""),
              "5:8 declaration-invalid: a unit has 1 to 16 bytes and no control characters\n");
    EXPECT_EQ(row("number = 7002\nkind = \"curve\"\nunit = \"a\\tb\""),
              "5:8 declaration-invalid: a unit has 1 to 16 bytes and no control characters\n");
    EXPECT_EQ(row("number = 7003\nkind = \"curve\"\nunit = \"12345678901234567\""),
              "5:8 declaration-invalid: a unit has 1 to 16 bytes and no control characters\n");
    EXPECT_EQ(row("number = 7004\nkind = \"curve\"\ntext = \"two\\nlines\""),
              "5:8 declaration-invalid: the text is empty or has control characters\n");
    EXPECT_EQ(row("number = 7005\nkind = \"curve\"\nsection = \"\""),
              "5:11 declaration-invalid: the text is empty or has control characters\n");
}

TEST_F(ReadCatalogueFindings, refuses_ranges_and_choices_that_cannot_be) {
    EXPECT_EQ(row("number = 7000\nkind = \"curve\"\nrange = [5, 1]"),
              "5:9 declaration-invalid: `range` runs backwards: 5 is above 1\n");
    EXPECT_EQ(row("number = 7001\nkind = \"curve\"\nrange = [1]"),
              "5:9 declaration-invalid: `range` has 1 elements, not two: [lowest, highest]\n");
    EXPECT_EQ(row("number = 7002\nkind = \"curve\"\nrange = [0, inf]"),
              "5:13 key-type: a limit of `range` is a number, not a decimal number\n");
    EXPECT_EQ(row("number = 7003\nkind = \"curve\"\nchoices = [-1]"),
              "5:12 declaration-invalid: a choice is an integer from 0 to 4294967295\n");
    EXPECT_EQ(row("number = 7004\nkind = \"curve\"\nrange = [0, 10]\nchoices = [5, 11]"),
              "6:11 declaration-invalid: choice 11 is outside the range of 7004\n");
    EXPECT_EQ(row("number = 7005\nkind = \"curve\"\npages = [27, -1]"),
              "5:14 declaration-invalid: a page is an integer from 0 to 4294967295\n");
}

TEST_F(ReadCatalogueFindings, refuses_widths_and_limits_that_do_not_fit) {
    EXPECT_EQ(row(torque + "width = 1\nsigned = false"),
              "6:9 declaration-invalid: width 1 is neither 8 nor 16\n");
    EXPECT_EQ(findings.all()[0].help, "write `bit = true` for a measurement of one bit");
    EXPECT_EQ(file(governor +
                   "[[row]]\nnumber = 2981\nname = \"A\"\nkind = \"measurement\"\nwidth = 8\nsigned = false\n"
                   "internal = [0, 256]\n"),
              "8:12 declaration-invalid: internal [0, 256] does not fit 8 bits, unsigned\n");
    EXPECT_EQ(file(governor +
                   "[[row]]\nnumber = 2982\nname = \"B\"\nkind = \"measurement\"\nwidth = 16\nsigned = true\n"
                   "internal = [0, 65535]\n"),
              "8:12 declaration-invalid: internal [0, 65535] does not fit 16 bits, signed\n");
    EXPECT_EQ(
        file(governor +
             "[[row]]\nnumber = 2983\nname = \"C\"\nkind = \"measurement\"\nwidth = 16\nsigned = false\n"
             "internal = [-1, 100]\n"),
        "8:12 declaration-invalid: internal [-1, 100] does not fit 16 bits, unsigned\n");
    EXPECT_EQ(file(governor +
                   "[[row]]\nnumber = 2984\nname = \"D\"\nkind = \"measurement\"\nwidth = 8\nsigned = true\n"
                   "internal = [-128, 127]\n"),
              "");
}

TEST_F(ReadCatalogueFindings, refuses_scalings_that_cannot_be) {
    const std::string u16 = torque + "width = 16\nsigned = false\n";
    EXPECT_EQ(
        row(u16 + "internal = [0.5, 10]"),
        "8:12 declaration-invalid: internal [0.5, 10] is not a range of integers within -32768..65535\n");
    EXPECT_EQ(row("number = 2990\ninternal = [7, 7]"),
              "4:12 declaration-invalid: internal [7, 7] is not a range of integers within -32768..65535\n");
    EXPECT_EQ(
        row("number = 2990\ninternal = [0, 65536]"),
        "4:12 declaration-invalid: internal [0, 65536] is not a range of integers within -32768..65535\n");
    EXPECT_EQ(row("number = 2990\ninternal = [0, 100]\nexternal = [3, 3]"),
              "5:12 declaration-invalid: `external` does not ascend: 3 to 3\n");
    EXPECT_EQ(row("number = 2330\nexternal = [0, \"x\"]"),
              "4:16 declaration-invalid: an external limit is a number or the parameter that holds it: "
              "{ parameter = 980 }\n");
    EXPECT_EQ(row("number = 2330\nexternal = [0, { parameter = 0 }]"),
              "4:16 declaration-invalid: an external limit is a number or the parameter that holds it: "
              "{ parameter = 980 }\n");
    EXPECT_EQ(row("number = 2330\nexternal = [0, { parameter = 2000 }]"),
              "4:30 declaration-invalid: 2000 is no settable parameter of the governor\n");
}

TEST_F(ReadCatalogueFindings, may_refer_to_a_parameter_that_stands_later) {
    EXPECT_EQ(
        file(governor +
             "[[row]]\nnumber = 2990\nname = \"A\"\nkind = \"measurement\"\nwidth = 16\nsigned = false\n"
             "internal = [0, 65535]\nexternal = [0, { parameter = 7000 }]\n"
             "[[row]]\nnumber = 7000\nname = \"AHigh\"\nkind = \"parameter\"\n"),
        "");
}

TEST_F(ReadCatalogueFindings, keeps_bits_simple) {
    EXPECT_EQ(row(torque + "bit = true\nwidth = 16\nsigned = false"),
              "6:7 declaration-invalid: a bit has neither width nor sign\n");
    EXPECT_EQ(row("number = 2991\nname = \"B\"\nkind = \"measurement\"\nbit = true\ninternal = [0, 1]"),
              "7:12 declaration-invalid: a bit has no internal range\n");
}

TEST_F(ReadCatalogueFindings, refuses_cells_of_measurements_elsewhere) {
    EXPECT_EQ(row("number = 812\nwidth = 16\nexternal = [0, 1]"),
              "4:9 declaration-invalid: `width` describes measurements, and 812 is a switch\n"
              "5:12 declaration-invalid: `external` describes measurements, and 812 is a switch\n");
}

TEST_F(ReadCatalogueFindings, refuses_arrays_and_ranges_that_cannot_be) {
    const std::string curve = "number = 7000\nkind = \"curve\"\n";
    EXPECT_EQ(row(curve + "count = 2"), "5:9 declaration-invalid: an array has a `name` and no `last`\n");
    EXPECT_EQ(row(curve + "name = \"X\"\ncount = 1"),
              "6:9 declaration-invalid: an array has 2 elements or more and ends by 29999\n");
    EXPECT_EQ(row("number = 29999\nkind = \"curve\"\nname = \"Y\"\ncount = 2"),
              "6:9 declaration-invalid: an array has 2 elements or more and ends by 29999\n");
    EXPECT_EQ(row(curve + "last = 6999"), "5:8 declaration-invalid: last 6999 is outside 7000..29999\n");
    EXPECT_EQ(row(curve + "name = \"X\"\nlast = 7001"),
              "6:8 declaration-invalid: rows number..last have no name; an array has `count`\n");
    EXPECT_EQ(row("number = 7010\nkind = \"curve\"\nname = \"X\"\nlist_end = 7020"),
              "6:12 declaration-invalid: list_end belongs to an array and is not before its end\n");
    EXPECT_EQ(row("number = 7020\nkind = \"curve\"\nname = \"X\"\ncount = 4\nlist_end = 7022"),
              "7:12 declaration-invalid: list_end belongs to an array and is not before its end\n");
    EXPECT_EQ(row("number = 7030\nkind = \"curve\"\nname = \"X\"\ncount = 4\nmisprints = [\"70 X\"]"),
              "7:13 declaration-invalid: misprints belong to single rows\n");
}

TEST_F(ReadCatalogueFindings, takes_misprints_as_number_and_name_only) {
    EXPECT_EQ(row("number = 7000\nkind = \"curve\"\nname = \"X\"\nmisprints = [\"700 X\"]"), "");
    EXPECT_EQ(catalogue.find_misprint(Device::governor, 700, "x")->number, 7000);
    for (const std::string text : {"\"700\"", "\"X\"", "\"X 700\"", "\"0 X\"", "700", "\"+1 X\""}) {
        EXPECT_EQ(
            row("number = 7001\nkind = \"curve\"\nname = \"Y\"\nmisprints = [" + text + "]"),
            "6:14 declaration-invalid: a misprint is a string of a number and a name: \"409 CanBaudrate\"\n")
            << text;
    }
}

TEST_F(ReadCatalogueFindings, reports_every_mistake_of_a_file_and_keeps_the_good_rows) {
    EXPECT_EQ(
        file(governor +
             "[[row]]\nnumber = 0\n"
             "[[row]]\nnumber = 2990\nname = \"Good\"\nkind = \"measurement\"\nbit = true\n"
             "[[row]]\nnumber = 2991\nname = \"Bad\"\nkind = \"measurement\"\nwidth = 12\nsigned = false\n"),
        "3:10 declaration-invalid: number 0 is outside 1..29999\n"
        "13:9 declaration-invalid: width 12 is neither 8 nor 16\n");
    EXPECT_EQ(find(2990)->name, "Good");
    EXPECT_EQ(find(2991)->width, 16);  // known after all, so that its use is no second finding
}

}  // namespace
