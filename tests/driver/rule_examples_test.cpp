// The examples in the rules themselves, as every explanation shows them: `bad` gives the finding and `good`
// does not.
#include <gtest/gtest.h>

#include <algorithm>

#include "authoring/clone.hpp"
#include "check/findings_text.hpp"
#include "check/overlay.hpp"
#include "dbc/read.hpp"
#include "diagnostic/rules.hpp"
#include "driver/check_file.hpp"
#include "driver/plant.hpp"
#include "driver/scenario_file.hpp"
#include "driver/tables.hpp"
#include "driver/traffic_subject.hpp"
#include "eds/reader.hpp"
#include "eds_check/checks.hpp"
#include "emit/concerned.hpp"
#include "firmware_file/embed.hpp"
#include "media/log_reader.hpp"
#include "network/judge.hpp"
#include "network/sources.hpp"
#include "signals/encode.hpp"
#include "support/scratch_directory.hpp"
#include "support/valid_data_sheet.hpp"
#include "traffic/audit.hpp"
#include "traffic/typed_frame.hpp"
#include "xdd/reading_result.hpp"

namespace cgw::driver {
namespace {

using diagnostic::Example;
using diagnostic::Rule;
using parameter::Device;

// What copying the file with these lines on top finds, for a sister gateway on the same network.
diagnostic::Findings findings_of_copy(std::string_view fragment) {
    const std::string text = test::overlaid(test::valid_file, fragment);
    const CheckedFile file = check_text("example.toml", text);
    EXPECT_TRUE(file.findings.all().empty()) << test::findings_text(file.findings);
    diagnostic::Findings findings;
    authoring::clone_text(text, file.settings, file.configuration, {.node_id = 2}, findings);
    return findings;
}

// Every row of concern, as the valid file has it.
std::string complete_table(Device device) {
    const CheckedFile file = check_text("example.toml", std::string(test::valid_file));
    const parameter::ParameterSet& set = file.settings.of(device);
    std::string text = "Number;Parameter;Value;Unit\n";
    for (const parameter::Row* row : emit::concerned_rows(*file.catalogue, device, set)) {
        text += fmt::format("{};{};{};\n", row->number, row->name, set.value(row->number));
    }
    return text;
}

// As test::overlaid(), for rows.
std::string with_rows(std::string_view table, std::string_view rows) {
    const auto number_of = [](std::string_view row) {
        row.remove_prefix(row.starts_with("# ") ? 2 : 0);
        return row.substr(0, row.find(';'));
    };
    std::vector<std::string> lines = test::sections_of(table).front().lines;
    const std::vector<std::string> replacing = test::sections_of(rows).front().lines;
    for (const std::string& row : replacing) {
        const auto same = std::find_if(lines.begin(), lines.end(), [&](const std::string& line) {
            return number_of(line) == number_of(row);
        });
        EXPECT_NE(same, lines.end()) << row;
        *same = row;
    }
    return fmt::format("{}\n", fmt::join(lines, "\n"));
}

// What reading the governor's table finds, beside a complete one of the gateway.
diagnostic::Findings findings_in_table(const std::string& table, bool is_to_be_complete) {
    const parameter::Catalogue catalogue(catalogue::shipped_rows());
    const test::ScratchDirectory directory;
    const TablePaths paths{directory.write("governor.csv", table),
                           directory.write("gateway.csv", complete_table(Device::gateway))};
    ReadTables tables = read_tables(paths, catalogue);
    if (is_to_be_complete) {
        note_absent_rows(tables, paths, catalogue);
    }
    diagnostic::Findings findings;
    for (const diagnostic::FileReport& report : tables.reports) {
        for (const diagnostic::Diagnostic& finding : report.findings) {
            findings.report(finding);
        }
    }
    return findings;
}

// What reading these steps finds, and looking up what they name in the sample.
diagnostic::Findings findings_in_scenario(const std::string& steps) {
    const CheckedFile plant = check_file(CGW_SAMPLES "/genset.toml");
    const base::Result<base::Bytes> bytes = image_bytes(plant);
    image::Image image;
    EXPECT_EQ(image::Image::open(*bytes, image), image::Status::ok);
    ScenarioFile file = read_scenario_text("example.toml", "format = 1\nduration = 10\n" + steps);
    scenario::bind(file.scenario, image, file.findings);
    return file.findings;
}

// What putting the sample's image into this Intel HEX file finds.
diagnostic::Findings findings_in_firmware(const std::string& text) {
    const base::Result<base::Bytes> bytes = image_bytes(check_file(CGW_SAMPLES "/genset.toml"));
    image::Image image;
    EXPECT_EQ(image::Image::open(*bytes, image), image::Status::ok);
    const auto embedded = firmware_file::embed(base::to_bytes(text), image, {{"", 0x08010000}});
    diagnostic::Findings findings;
    if (!embedded) {
        findings.report(embedded.error());
    }
    return findings;
}

// What reading these sections as an EDS finds.
diagnostic::Findings findings_in_data_sheet(const std::string& text) {
    diagnostic::Findings findings;
    eds::read(eds::Document(text), "example.eds", findings);
    return findings;
}

// What giving these values to a frame of the sample finds.
diagnostic::Findings findings_of_arguments(std::string_view example) {
    const std::vector<std::string> arguments = test::sections_of(example).front().lines;
    const CheckedFile plant = check_file(CGW_SAMPLES "/genset.toml");
    const auto frames = signals::frames_of(plant.settings, *plant.catalogue, plant.configuration);
    diagnostic::Findings findings;
    if (traffic::begins_frame(arguments.front())) {
        traffic::read_typed_frame(arguments, findings);
        return findings;
    }
    if (const signals::Frame* const frame = signals::demand_frame(frames, arguments.front(), findings)) {
        signals::encode(*frame, std::span(arguments).subspan(1), findings);
    }
    return findings;
}

// What holding this log against the sample finds.
diagnostic::Findings findings_in_log(std::string_view log) {
    const CheckedFile file = check_file(CGW_SAMPLES "/genset.toml");
    const auto plant = Plant::make(file);
    const emit::Plant view = plant->view();
    const traffic::Subject subject = traffic_subject(file, view);
    const traffic::Owners owners(subject);
    traffic::Audit audit(subject, owners);
    media::LogReader reader;
    reader.feed(log);
    reader.finish();
    using Kind = media::LogReader::Kind;
    for (const media::LogReader::Item* item = &reader.next(); item->kind != Kind::end;
         item = &reader.next()) {
        if (item->kind == Kind::frame) {
            audit.take({item->number, item->logged.time_us, item->has_time, item->logged.frame});
        } else if (item->kind == Kind::fault) {
            audit.take_fault(item->number, item->fault);
        }
    }
    audit.finish(true);
    return audit.findings("example.log");
}

// What judging the bus of the file with these lines on top finds.
diagnostic::Findings findings_on_bus(std::string_view fragment) {
    const CheckedFile file = check_text("example.toml", test::overlaid(test::valid_file, fragment));
    EXPECT_FALSE(file.findings.has_errors()) << test::findings_text(file.findings);
    diagnostic::Findings findings;
    const std::vector<network::Member> members{network::member_of(file.settings, file.configuration)};
    const auto messages = network::messages_of(file.settings, file.configuration, 0);
    network::judge_owners(members, messages, findings);
    if (const auto bit_rate = network::judge_bit_rate(members, findings)) {
        network::judge(network::analyse(network::merged(messages), {.bit_rate = *bit_rate}), {},
                       members.front().rate_where, findings);
    }
    return findings;
}

// What reading this CAN database finds.
diagnostic::Findings findings_in_database(std::string_view text) {
    diagnostic::Findings findings;
    dbc::read(text, "example.dbc", findings);
    return findings;
}

// The same of a whole EDS, with what the checks find.
diagnostic::Findings findings_in_checked_sheet(const std::string& text) {
    diagnostic::Findings findings;
    const std::string path = "example.eds";
    const eds::Document document(text);
    const eds::Sheet sheet = eds::read(document, path, findings);
    eds_check::check(document, sheet, path, {.file_name = path}, findings);
    return findings;
}

// What reading these parameters, the objects behind them, and the transport layers behind those, as an
// XDD finds.
diagnostic::Findings findings_in_device_description(const std::string& text) {
    constexpr std::string_view identity_end = "</DeviceIdentity>";
    const std::size_t identity = text.find(identity_end);
    const std::size_t parameters = identity == std::string::npos ? 0 : identity + identity_end.size();
    const std::size_t objects = text.find("<CANopenObject");
    const std::size_t network = std::min(text.find("<TransportLayers"), text.size());
    diagnostic::Findings findings;
    xdd::read(test::device_description(text.substr(parameters, objects - parameters),
                                       text.substr(objects, network - objects), text.substr(network),
                                       text.substr(0, parameters)),
              "example.xdd", findings);
    return findings;
}

diagnostic::Findings findings_of(Example kind, std::string_view example) {
    switch (kind) {
        case Example::none:
            break;
        case Example::parameter_file:
            return test::findings_with(example);
        case Example::copied_file:
            return findings_of_copy(example);
        case Example::network:
            return findings_on_bus(example);
        case Example::table:
            return findings_in_table(std::string(example), false);
        case Example::table_rows:
            return findings_in_table(with_rows(complete_table(Device::governor), example), true);
        case Example::scenario:
            return findings_in_scenario(std::string(example));
        case Example::firmware:
            return findings_in_firmware(std::string(example));
        case Example::data_sheet:
            return findings_in_data_sheet(std::string(example));
        case Example::database:
            return findings_in_database(example);
        case Example::frame_arguments:
            return findings_of_arguments(example);
        case Example::frame_log:
            return findings_in_log(example);
        case Example::data_sheet_lines:
            return findings_in_checked_sheet(test::data_sheet_with(example));
        case Example::device_description:
            return findings_in_device_description(std::string(example));
    }
    return {};
}

class RuleExamples : public testing::TestWithParam<const Rule*> {};

TEST_P(RuleExamples, show_the_rule_broken_and_kept) {
    const Rule& rule = *GetParam();
    if (rule.example == Example::none) {
        EXPECT_EQ(rule.bad, "");
        EXPECT_EQ(rule.good, "");
        return;
    }
    const diagnostic::Findings bad = findings_of(rule.example, rule.bad);
    ASSERT_EQ(bad.all().size(), 1U) << rule.bad << test::findings_text(bad);
    EXPECT_EQ(bad.all().front().rule, &rule) << rule.bad << test::findings_text(bad);
    const diagnostic::Findings good = findings_of(rule.example, rule.good);
    EXPECT_EQ(test::findings_text(good), "") << rule.good;
    EXPECT_NE(rule.good, "") << rule.name;
}

INSTANTIATE_TEST_SUITE_P(Rules, RuleExamples, testing::ValuesIn(diagnostic::all_rules()),
                         [](const auto& test) {
                             std::string name(test.param->name);
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

TEST(RuleExampleFile, has_no_findings_itself) {
    EXPECT_EQ(test::findings_text(test::findings_with("")), "");
}

TEST(RuleExampleTables, have_no_findings_themselves) {
    EXPECT_EQ(test::findings_text(findings_in_table(complete_table(Device::governor), true)), "");
}

TEST(RuleExampleDataSheet, has_no_findings_itself) {
    EXPECT_EQ(test::findings_text(findings_in_checked_sheet(std::string(test::valid_data_sheet))), "");
}

TEST(RuleExampleKinds, without_examples_are_the_rules_that_nothing_printed_can_break) {
    std::string names;
    for (const Rule* rule : diagnostic::all_rules()) {
        names += rule->example == Example::none ? fmt::format("{} ", rule->name) : "";
    }
    EXPECT_EQ(names,
              "file-unreadable file-too-large file-not-utf8 elf-structure firmware-section firmware-address "
              "image-alignment image-room image-refused image-model image-elsewhere eds-text eds-too-much "
              "eds-byte-order-mark eds-line-ends xdd-text xdd-root bit-rates-differ node-shared "
              "message-not-counted message-told-twice bit-rate-not-offered ");
}

}  // namespace
}  // namespace cgw::driver
