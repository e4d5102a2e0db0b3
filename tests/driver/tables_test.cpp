// Entry sheets read back as tables give the plant they were printed from, and copies differ as announced.
#include "driver/tables.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "authoring/clone.hpp"
#include "catalogue/catalogue.hpp"
#include "diagnostic/rules/files.hpp"
#include "diagnostic/rules/tables.hpp"
#include "driver/check_file.hpp"
#include "driver/plant.hpp"
#include "emit/emitter.hpp"
#include "support/scratch_directory.hpp"

namespace cgw::driver {
namespace {

using Directory = test::ScratchDirectory;

std::string sheet_of(const CheckedFile& file, const std::string& format) {
    const base::Result<Plant> plant = Plant::make(file);
    emit::Options options;
    options.format = format;
    const base::Bytes bytes = emit::find_emitter("entry-sheet")->emit(plant->view(), options);
    return {bytes.begin(), bytes.end()};
}

// What a sheet says of `file`, read back; what sheets do not carry is put back.
std::string round_trip_id(const CheckedFile& file, const std::string& format, const Directory& directory) {
    const std::string path = directory.write("sheet." + format, sheet_of(file, format));
    const TablePaths paths{path, path};
    const ReadTables tables = read_tables(paths, *file.catalogue);
    EXPECT_TRUE(tables.valid() && tables.reports.empty())
        << (tables.reports.empty() ? "" : tables.reports[0].findings[0].message);
    CheckedFile back = check_text("back.toml", text_of_tables(tables, paths, "", *file.catalogue));
    back.settings.identity = file.settings.identity;
    EXPECT_EQ(back.settings.title, file.settings.title);
    EXPECT_EQ(back.settings.main_cycle_us, file.settings.main_cycle_us);
    back.settings.declarations = file.settings.declarations;
    return short_configuration_id(back.settings);
}

class Sample : public testing::TestWithParam<const char*> {
  protected:
    static CheckedFile sample() { return check_file(fmt::format("{}/{}.toml", CGW_SAMPLES, GetParam())); }
};

TEST_P(Sample, comes_back_from_its_entry_sheets) {
    const CheckedFile file = sample();
    ASSERT_TRUE(file.valid());
    const Directory directory;
    for (const std::string format : {"md", "csv"}) {
        EXPECT_EQ(round_trip_id(file, format, directory), short_configuration_id(file.settings)) << format;
    }
}

TEST_P(Sample, agrees_with_its_own_sheet_as_found) {
    const CheckedFile file = sample();
    const Directory directory;
    const std::string path = directory.write("sheet.csv", sheet_of(file, "csv"));
    const TableSide found = side_of_tables(file, read_tables({path, path}, *file.catalogue));
    EXPECT_TRUE(found.absent.empty());
    const compare::Comparison comparison =
        compare::compare({file.settings, file.configuration, *file.catalogue},
                         {found.settings, found.configuration, *file.catalogue});
    EXPECT_TRUE(comparison.same());
}

// For every node id: the copy is valid TOML, and nothing but 427, shifted identifiers and the title differs.
TEST_P(Sample, copies_differ_in_node_id_and_title_only) {
    const CheckedFile file = sample();
    for (const int node : {2, 17, 126}) {
        diagnostic::Findings findings;
        const authoring::CloneRequest request{static_cast<std::uint8_t>(node), "another", true};
        const auto text = authoring::clone_text(file.sources.at(file.path), file.settings, file.configuration,
                                                request, findings);
        ASSERT_TRUE(text);
        const CheckedFile copy = check_text(file.path, *text);
        ASSERT_TRUE(copy.valid()) << copy.findings.all()[0].message;
        const compare::Comparison comparison =
            compare::compare({file.settings, file.configuration, *file.catalogue},
                             {copy.settings, copy.configuration, *copy.catalogue});
        ASSERT_EQ(comparison.parameters.size(), 1U);
        EXPECT_EQ(comparison.parameters[0].row->number, 427);
        EXPECT_EQ(comparison.parameters[0].b, node);
        ASSERT_EQ(comparison.otherwise.size(), 1U);
        EXPECT_EQ(comparison.otherwise[0].kind, "title");
        for (const compare::Difference& difference : comparison.consequences) {
            EXPECT_TRUE(difference.kind == "node-id" || difference.kind == "node-identifier" ||
                        difference.kind == "pdo-identifier")
                << difference.kind;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Samples, Sample, testing::Values("minimal", "genset", "manual-example"),
                         [](const auto& instance) {
                             std::string name = instance.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

// Values of every kind, fractions with three decimals among them, come back as they were.
TEST(EntrySheets, of_random_plants_come_back) {
    const Directory directory;
    std::mt19937 random(20261122);
    const auto upto = [&random](unsigned highest) { return static_cast<unsigned>(random() % (highest + 1)); };
    for (int run = 0; run < 10; ++run) {
        std::string text = "format = 1\n[governor.parameters]\n401 = 1\n403 = 1\n416 = 500\n4406 = 1\n";
        text += fmt::format("400 = {}.{:03}\n984 = {}\n980 = 1{}.{:03}\n", upto(99), upto(999), upto(2000),
                            upto(9), upto(999));
        text += fmt::format("827 = {}\n4827 = {}\n16472 = {}\n16483 = {}\n", static_cast<int>(upto(32)) - 16,
                            upto(2), upto(3999), upto(3999));
        text += fmt::format(
            "[gateway.parameters]\n401 = 1\n402 = 1\n416 = 500\n4400 = 1\n426 = 125\n427 = {}\n"
            "429 = {}\n16410 = 0x{:X}\n",
            1 + upto(126), upto(65535), upto(0x7FF));
        const CheckedFile file = check_text("random.toml", text);
        ASSERT_TRUE(file.valid()) << text << file.findings.all()[0].message;
        for (const std::string format : {"md", "csv"}) {
            EXPECT_EQ(round_trip_id(file, format, directory), short_configuration_id(file.settings)) << text;
        }
    }
}

// Registers instead of rates: a rate that is not used cannot be 0, and is not on the sheet.
constexpr std::string_view manual_timing =
    "format = 1\n[governor.parameters]\n401 = 1\n403 = 1\n4406 = 1\n4416 = 1\n410 = 1\n413 = 6\n414 = 7\n"
    "[gateway.parameters]\n401 = 1\n402 = 1\n4400 = 1\n427 = 1\n429 = 1000\n4416 = 1\n4426 = 1\n"
    "410 = 1\n413 = 6\n414 = 7\n415 = 0\n420 = 1\n423 = 6\n424 = 7\n425 = 0\n";

TEST(EntrySheets, with_manual_timing_come_back_without_bit_rates) {
    const CheckedFile file = check_text("manual.toml", std::string(manual_timing));
    ASSERT_TRUE(file.valid()) << file.findings.all()[0].message;
    const Directory directory;
    for (const std::string format : {"md", "csv"}) {
        EXPECT_EQ(round_trip_id(file, format, directory), short_configuration_id(file.settings)) << format;
        EXPECT_EQ(sheet_of(file, format).find("kbit/s"), std::string::npos);
    }
}

TEST(EntrySheets, print_a_rate_that_is_set_beside_manual_timing) {
    const CheckedFile file = check_text("manual.toml", std::string(manual_timing) + "426 = 250\n");
    ASSERT_TRUE(file.valid()) << file.findings.all()[0].message;
    const std::string sheet = sheet_of(file, "csv");
    EXPECT_NE(sheet.find("gateway,426,CanOpenBaudrate,250,kbit/s"), std::string::npos) << sheet;
    EXPECT_EQ(sheet.find(",416,"), std::string::npos) << sheet;
    EXPECT_EQ(round_trip_id(file, "csv", Directory()), short_configuration_id(file.settings));
}

TEST(EntrySheets, list_what_is_0_in_the_second_table_only) {
    const CheckedFile file = check_text("manual.toml", std::string(manual_timing));
    const std::string sheet = sheet_of(file, "md");
    const std::size_t all = sheet.find("## Gateway: all that concern CANopen");
    EXPECT_LT(sheet.find("| gateway | 414 |"), all);
    EXPECT_GT(sheet.find("| gateway | 415 | HzmCanPropSegment | 0 |"), all);
    const std::string csv = sheet_of(file, "csv");
    EXPECT_GT(csv.find("gateway,415,HzmCanPropSegment,0,"), csv.rfind(",yes,")) << csv;
    EXPECT_GT(sheet.find("| gateway | 411 |"), sheet.find("## Gateway: all that concern CANopen"));
    EXPECT_NE(sheet.find("the manuals print no defaults"), std::string::npos);
    EXPECT_EQ(sheet.find("Main cycle"), std::string::npos);
}

TEST(EntrySheets, say_the_main_cycle_when_it_is_not_the_usual_one) {
    std::string text(manual_timing);
    text.replace(text.find("[governor.parameters]"), 0, "[governor]\nmain_cycle_us = 10000\n");
    const CheckedFile file = check_text("manual.toml", text);
    ASSERT_TRUE(file.valid()) << file.findings.all()[0].message;
    for (const std::string format : {"md", "html"}) {
        EXPECT_NE(sheet_of(file, format).find("Main cycle of the governor: 10000 us."), std::string::npos);
    }
    EXPECT_EQ(round_trip_id(file, "md", Directory()), short_configuration_id(file.settings));
}

// Whatever in a title is markup in one of the forms; and the main cycle, on which effective times depend.
TEST(EntrySheets, carry_title_and_main_cycle) {
    for (const std::string title :
         {"Genset 2, starboard", R"(=1+1 <b>|\ *a* `b` "c"; #3_~ & d)", "\xC2\xA0 x"}) {
        CheckedFile file = check_text("manual.toml", std::string(manual_timing));
        file.settings.title = title;
        file.settings.main_cycle_us = 20000;
        const Directory directory;
        for (const std::string format : {"md", "csv"}) {
            EXPECT_EQ(round_trip_id(file, format, directory), short_configuration_id(file.settings))
                << format;
        }
    }
}

TEST(EntrySheets, with_another_title_or_a_sheet_resaved_on_windows) {
    CheckedFile file = check_text("manual.toml", std::string(manual_timing));
    file.settings.title = "Genset 2";
    std::string sheet = sheet_of(file, "md");
    for (std::size_t at = 0; (at = sheet.find('\n', at)) != std::string::npos; at += 2) {
        sheet.replace(at, 1, "\r\n");
    }
    const Directory directory;
    const std::string path = directory.write("sheet.md", sheet);
    const ReadTables tables = read_tables({path, path}, *file.catalogue);
    EXPECT_EQ(tables.governor.title, "Genset 2");
    EXPECT_EQ(tables.governor.main_cycle_us, std::nullopt);
    const std::string text = text_of_tables(tables, {path, path}, "Genset 3", *file.catalogue);
    EXPECT_NE(text.find("\ntitle = \"Genset 3\"\n"), std::string::npos) << text;
}

TEST(Tables, with_a_main_cycle_that_is_no_number_are_refused) {
    const parameter::Catalogue catalogue(catalogue::shipped_rows());
    const Directory directory;
    for (const std::string cycle : {"fast us", "0 us", "4294967296 us", "1.5 us", ""}) {
        const std::string path =
            directory.write("governor.md", "401 1\nMain cycle of the governor: " + cycle + "\n");
        const ReadTables tables = read_tables({path, directory.write("gateway.txt", "401 1\n")}, catalogue);
        ASSERT_EQ(tables.reports.size(), 1U) << cycle;
        EXPECT_EQ(tables.reports[0].findings[0].rule, &diagnostic::rules::table_row);
    }
}

TEST(Tables, say_which_numbers_of_concern_they_do_not_print) {
    const CheckedFile file = check_file(CGW_SAMPLES "/genset.toml");
    const Directory directory;
    const std::string whole = directory.write("whole.csv", sheet_of(file, "csv"));
    const ReadTables complete = read_tables({whole, whole}, *file.catalogue);
    EXPECT_EQ(absent_numbers(complete, parameter::Device::governor, *file.catalogue), "");
    EXPECT_EQ(absent_numbers(complete, parameter::Device::gateway, *file.catalogue), "");
    const std::string governor = directory.write("governor.txt", "401 1\n403 1\n416 250\n4416 0\n900 2\n");
    const std::string gateway = directory.write("gateway.txt", "4416 1\n4426 0\n402 1\n");
    const TablePaths paths{governor, gateway};
    const ReadTables tables = read_tables(paths, *file.catalogue);
    EXPECT_EQ(absent_numbers(tables, parameter::Device::governor, *file.catalogue),
              "400, 4406, 4900, 14401..14402, 16400..16451, 16460..16472, 16480..16483");
    EXPECT_EQ(absent_numbers(tables, parameter::Device::gateway, *file.catalogue),
              "400, 410..415, 428..430, 4400, 16404..16415");
    const std::string text = text_of_tables(tables, paths, "", *file.catalogue);
    EXPECT_NE(text.find("# Gateway: not printed, taken as 0: 400, 410..415, 428..430, 4400, 16404..16415\n"),
              std::string::npos)
        << text;
}

TEST(Tables, that_do_not_print_every_row_of_concern_get_a_note_each) {
    const parameter::Catalogue catalogue(catalogue::shipped_rows());
    const Directory directory;
    const TablePaths paths{directory.write("governor.txt", "401 1\n403 1\n2000 1500\n"),
                           directory.write("gateway.txt", "401 1\n402 1\n")};
    ReadTables tables = read_tables(paths, catalogue);
    ASSERT_EQ(tables.reports.size(), 1U);
    note_absent_rows(tables, paths, catalogue);
    ASSERT_EQ(tables.reports.size(), 2U);
    ASSERT_EQ(tables.reports[0].findings.size(), 2U);  // behind the skipped measurement
    EXPECT_EQ(tables.reports[0].findings[1].message,
              "not printed for the governor, taken as 0: 400, 4406, 4416, 14401..14402, 16400..16451, "
              "16460..16472, 16480..16483");
    EXPECT_EQ(tables.reports[1].path, paths.gateway);
    EXPECT_EQ(tables.reports[1].findings[0].rule, &diagnostic::rules::table_row_absent);
    EXPECT_TRUE(tables.valid());
}

TEST(Tables, that_are_one_file_get_their_notes_in_one_report) {
    const parameter::Catalogue catalogue(catalogue::shipped_rows());
    const Directory directory;
    const std::string path =
        directory.write("both.csv", "Device;Number;Value\ngovernor;401;1\ngateway;401;1\n");
    const TablePaths paths{path, path};
    ReadTables tables = read_tables(paths, catalogue);
    note_absent_rows(tables, paths, catalogue);
    ASSERT_EQ(tables.reports.size(), 1U);
    EXPECT_EQ(tables.reports[0].findings.size(), 2U);
}

TEST(Tables, that_cannot_be_read_are_a_finding_of_their_own) {
    const parameter::Catalogue catalogue(catalogue::shipped_rows());
    const Directory directory;
    const std::string gateway =
        directory.write("gateway.txt", "401 CanMyNodeNumber 1\n402 CanDCNodeNumber 1\n");
    const ReadTables tables = read_tables({"/nonexistent/governor.txt", gateway}, catalogue);
    EXPECT_TRUE(tables.unreadable);
    ASSERT_EQ(tables.reports.size(), 1U);
    EXPECT_EQ(tables.reports[0].findings[0].rule, &diagnostic::rules::file_unreadable);
    EXPECT_EQ(tables.gateway.values.size(), 2U);
}

TEST(Tables, leave_what_they_do_not_print_as_the_file_has_it) {
    const CheckedFile file = check_file(CGW_SAMPLES "/manual-example.toml");
    const Directory directory;
    const std::string governor =
        directory.write("governor.txt", "403 CanCMNodeNumber 1\n16400 CanOpTPDO4Assign(0) 2031\n");
    const std::string gateway = directory.write("gateway.txt", "402 CanDCNodeNumber 1\n");
    const TableSide side = side_of_tables(file, read_tables({governor, gateway}, *file.catalogue));
    EXPECT_EQ(side.settings.governor.value(16400), 2031);
    EXPECT_EQ(side.settings.governor.value(16401), 2031);
    EXPECT_FALSE(side.absent.empty());
    for (const compare::ParameterDifference& absent : side.absent) {
        EXPECT_NE(absent.a, 0) << absent.row->number;
        EXPECT_NE(absent.row->number, 16400);
    }
}

}  // namespace
}  // namespace cgw::driver
