// Everything but the parameters: format, title, [document], [governor], [gateway], [network].
#include "input/sections.hpp"

#include <algorithm>

#include "input/support.hpp"

namespace cgw {
namespace {

using test::gateway;
using test::governor;
using test::head;
using test::Outcome;
using test::read;
using test::show;
using test::top_findings;

TEST(InputFormat, a_missing_format_is_a_finding_and_the_rest_is_read) {
    const Outcome outcome = read("title = 't'\n" + governor + gateway);
    EXPECT_EQ(show(outcome.findings),
              "E0007 0:0 the file does not say its format | begin it with format = 1");
    EXPECT_TRUE(outcome.result.usable);
    EXPECT_EQ(outcome.settings().governor.value(416), 250);
}

TEST(InputFormat, a_higher_format_ends_the_reading) {
    const Outcome outcome = read("title = 1\nformat = 2\nsurprise = true\n");
    EXPECT_EQ(show(outcome.findings),
              "E0008 2:10 the file is written in format 2, and this cgw reads format 1 | use a newer cgw");
    EXPECT_FALSE(outcome.result.usable);
}

TEST(InputFormat, a_format_that_never_was_is_refused) {
    EXPECT_EQ(show(read("format = 0\n").findings),
              "E0008 1:10 the file is written in format 0, and this cgw reads format 1 | write format = 1");
    EXPECT_EQ(show(read("format = -1\n").findings),
              "E0008 1:10 the file is written in format -1, and this cgw reads format 1 | write format = 1");
}

TEST(InputFormat, a_format_of_another_type_is_refused) {
    EXPECT_EQ(show(read("format = \"1\"\ntitle = 't'\n" + governor + gateway).findings),
              "E0102 1:10 `format` must be an integer, not a string");
    EXPECT_EQ(show(read("format = 1.0\ntitle = 't'\n" + governor + gateway).findings),
              "E0102 1:10 `format` must be an integer, not a decimal number");
}

TEST(InputFormat, a_misspelt_format_is_one_finding) {
    const Outcome outcome = read("fomat = 1\n" + governor + gateway);
    EXPECT_EQ(show(outcome.findings),
              "E0101 1:1 unknown key `fomat` at the top of the file | did you mean `format`?");
    EXPECT_TRUE(outcome.result.usable);
    EXPECT_EQ(outcome.settings().governor.value(416), 250);
}

TEST(InputFormat, a_misspelt_format_is_still_judged) {
    const Outcome outcome = read("fomat = 2\n" + governor + gateway);
    EXPECT_EQ(show(outcome.findings),
              "E0008 1:9 the file is written in format 2, and this cgw reads format 1 | use a newer cgw");
    EXPECT_FALSE(outcome.result.usable);
}

TEST(InputSections, a_header_without_its_dot_is_read_as_the_one_that_was_meant) {
    const std::string keys = gateway.substr(gateway.find('\n'));
    for (const std::string name : {"gateway6parameters", "gatewayparameters", "gateway_parameters"}) {
        const Outcome outcome = read(head + governor + "[" + name + "]" + keys);
        EXPECT_EQ(show(outcome.findings),
                  "E0101 7:2 unknown table `" + name +
                      "` at the top of the file | did you mean [gateway.parameters]?");
        EXPECT_EQ(outcome.settings().gateway.value(426), 125);
    }
}

TEST(InputSections, parameters_without_their_header_are_one_finding) {
    const std::string keys = "401 = 1\n403 = 1\n416 = 250\n";
    EXPECT_EQ(show(read(head + keys + gateway).findings),
              "E0101 3:1 unknown key `401` at the top of the file | parameters of the governor stand in "
              "[governor.parameters], and the file has no such header");
    EXPECT_EQ(show(read(head + "[governor]\n" + keys + gateway).findings),
              "E0101 4:1 unknown key `401` in [governor] | parameters of the governor stand in "
              "[governor.parameters], and the file has no such header");
    EXPECT_EQ(show(read(head + governor + "402 = 1\n426 = 125\n427 = 1\n").findings),
              "E0105 7:1 the governor has no parameter `402` | 402 CanDCNodeNumber belongs to the gateway: "
              "write it in [gateway.parameters]");
}

TEST(InputFormat, a_text_that_is_not_toml_is_not_usable) {
    const Outcome outcome = read("format = \n");
    EXPECT_EQ(show(outcome.findings), "E0004 1:10 there is no value after '='");
    EXPECT_FALSE(outcome.result.usable);
    EXPECT_EQ(outcome.settings().path, "f.toml");
}

TEST(InputSections, a_complete_file_is_read_without_a_finding) {
    const Outcome outcome = read(
        "#:schema ../schemas/parameter-file.schema.json\nformat = 1\ntitle = \"Genset 2, st\xC3\xA4rboard\"\n"
        "[document]\ncreated = 2026-03-01\nauthor = \"A. N. Engineer\"\nrevision = 2\n"
        "[governor]\nprofile = \"digital-governor\"\nmain_cycle_us = 16000\n" +
        governor +
        "[gateway]\nidentity = { software_version = 1, serial_date = 407, serial_number = 12 }\n"
        "bit_timing = { can1 = { clock_hz = 16000000, family = \"mcp2515\" }, "
        "can2 = { clock_hz = 8000000, family = \"at90can\" } }\n" +
        gateway + "[network]\nnodes = [2, 127]\n");
    EXPECT_EQ(show(outcome.findings), "fine");
    EXPECT_TRUE(outcome.result.usable);
    const parameter::Settings& settings = outcome.settings();
    EXPECT_EQ(settings.title, "Genset 2, st\xC3\xA4rboard");
    EXPECT_EQ(settings.document.created, (parameter::Date{2026, 3, 1}));
    EXPECT_EQ(settings.document.author, "A. N. Engineer");
    EXPECT_EQ(settings.document.revision, 2U);
    EXPECT_EQ(settings.main_cycle_us, 16000U);
    EXPECT_EQ(settings.identity.software_version, 1U);
    EXPECT_EQ(settings.identity.serial_date, 407U);
    EXPECT_EQ(settings.identity.serial_number, 12U);
    ASSERT_TRUE(settings.can1_bit_timing && settings.can2_bit_timing);
    EXPECT_EQ(settings.can1_bit_timing->clock_hz, 16000000U);
    EXPECT_EQ(settings.can1_bit_timing->controller, bit_timing::find_controller("mcp2515"));
    EXPECT_EQ(settings.can1_bit_timing->where.range.start, (diagnostic::Position{17, 23}));
    EXPECT_EQ(settings.can2_bit_timing->controller, bit_timing::find_controller("at90can"));
    ASSERT_EQ(settings.network_nodes.size(), 2U);
    EXPECT_EQ(settings.network_nodes[1].node_id, 127);
    EXPECT_EQ(settings.network_nodes[1].where.range.start, (diagnostic::Position{25, 13}));
    EXPECT_EQ(settings.governor_table.range.start, (diagnostic::Position{11, 1}));
    EXPECT_EQ(settings.gateway_table.range.start, (diagnostic::Position{18, 1}));
}

TEST(InputSections, the_main_cycle_that_editors_show_as_preset_is_the_one_that_holds) {
    const input::Table* governor_table = nullptr;
    for (const input::Key& key : input::file_table().keys) {
        governor_table = key.name == "governor" ? key.below : governor_table;
    }
    ASSERT_NE(governor_table, nullptr);
    const auto key = std::find_if(governor_table->keys.begin(), governor_table->keys.end(),
                                  [](const input::Key& k) { return k.name == "main_cycle_us"; });
    ASSERT_NE(key, governor_table->keys.end());
    EXPECT_EQ(key->preset, std::to_string(parameter::Settings{}.main_cycle_us));
}

TEST(InputSections, defaults_hold_for_what_is_left_out) {
    const Outcome outcome = read(head + governor + gateway);
    EXPECT_EQ(show(outcome.findings), "fine");
    const parameter::Settings& settings = outcome.settings();
    EXPECT_FALSE(settings.document.created);
    EXPECT_EQ(settings.document.author, "");
    EXPECT_EQ(settings.document.revision, 0U);
    EXPECT_EQ(settings.main_cycle_us, 15625U);
    EXPECT_EQ(settings.identity.software_version, 0U);
    EXPECT_FALSE(settings.can1_bit_timing);
    EXPECT_FALSE(settings.can2_bit_timing);
    EXPECT_TRUE(settings.network_nodes.empty());
    EXPECT_TRUE(settings.declarations.empty());
}

TEST(InputSections, a_title_is_optional_short_and_one_line) {
    EXPECT_EQ(show(read("format = 1\n" + governor + gateway).findings), "fine");
    const auto title = [](const std::string& value) {
        return show(read("format = 1\ntitle = " + value + "\n" + governor + gateway).findings);
    };
    EXPECT_EQ(title("''"), "E0104 2:9 `title` is empty");
    EXPECT_EQ(title("'" + std::string(200, 'x') + "'"), "fine");
    EXPECT_EQ(title("'" + std::string(201, 'x') + "'"), "E0104 2:9 `title` has 201 bytes, more than 200");
    EXPECT_EQ(title("\"a\\nb\""), "E0104 2:9 `title` contains a control character");
    EXPECT_EQ(title("\"a\\u007F\""), "E0104 2:9 `title` contains a control character");
    EXPECT_EQ(title("7"), "E0102 2:9 `title` must be a string, not an integer");
}

TEST(InputSections, the_document_table_is_checked) {
    EXPECT_EQ(top_findings("[document]\ncreated = \"2026-03-01\"\nauthor = 1\nrevision = 256\n"),
              "E0102 4:11 `created` must be a date, not a string\n"
              "E0102 5:10 `author` must be a string, not an integer\n"
              "E0104 6:12 `revision` is 256, outside 0..255");
    EXPECT_EQ(top_findings("[document]\ncreated = 2026-03-01T10:00:00Z\nauthor = \"\\t\"\nrevision = -1\n"),
              "E0102 4:11 `created` must be a date, not a date with time\n"
              "E0104 5:10 `author` contains a control character\n"
              "E0104 6:12 `revision` is -1, outside 0..255");
    EXPECT_EQ(top_findings("[document]\nauthor = '" + std::string(245, 'x') + "'\nrevision = 255\n"), "fine");
    EXPECT_EQ(top_findings("[document]\nauthor = '" + std::string(246, 'x') + "'\n"),
              "E0104 4:10 `author` has 246 bytes, more than 245");
    EXPECT_EQ(top_findings("document = 1\n"), "E0102 3:12 `document` must be a table, not an integer");
}

TEST(InputSections, the_governor_table_is_checked) {
    EXPECT_EQ(top_findings("[governor]\nprofile = \"digital-govenor\"\nmain_cycle_us = 999\n"),
              "E0104 4:11 unknown profile `digital-govenor` | the profile is \"digital-governor\"\n"
              "E0104 5:17 `main_cycle_us` is 999, outside 1000..1000000");
    EXPECT_EQ(top_findings("[governor]\nmain_cycle_us = 1000000\n"), "fine");
    EXPECT_EQ(top_findings("[governor]\nmain_cycle_us = 15.625\nprofile = true\n"),
              "E0102 4:17 `main_cycle_us` must be an integer, not a decimal number\n"
              "E0102 5:11 `profile` must be a string, not a boolean");
}

TEST(InputSections, the_identity_is_checked) {
    EXPECT_EQ(
        top_findings(
            "[gateway]\nidentity = { software_version = 65536, serial_date = 9913, serial_number = -1 }\n"),
        "E0104 4:33 `software_version` is 65536, outside 0..65535\n"
        "E0104 4:54 `serial_date` is 9913, outside 0..9912\n"
        "E0104 4:76 `serial_number` is -1, outside 0..65535");
    EXPECT_EQ(top_findings("[gateway.identity]\nsoftware_version = 65535\nserial_date = 9912\n"), "fine");
    EXPECT_EQ(top_findings("[gateway.identity]\nserial = 5\n"),
              "E0101 4:1 unknown key `serial` in [gateway.identity]");
}

TEST(InputSections, the_bit_timing_is_checked) {
    EXPECT_EQ(
        top_findings("[gateway.bit_timing]\ncan1 = { clock_hz = 0, family = \"mcp2551\" }\ncan3 = {}\n"),
        "E0104 4:21 `clock_hz` is 0, outside 1..1000000000\n"
        "E0104 4:33 unknown controller family `mcp2551` | did you mean `mcp2515`?\n"
        "E0101 5:1 unknown table `can3` in [gateway.bit_timing] | did you mean `can1`?");
    EXPECT_EQ(
        top_findings("[gateway.bit_timing]\ncan1 = { clock_hz = 1 }\ncan2 = { family = \"sja1000\" }\n"),
        "E0103 4:8 `family` is missing in [gateway.bit_timing.can1]\n"
        "E0103 5:8 `clock_hz` is missing in [gateway.bit_timing.can2]\n"
        "E0104 5:19 unknown controller family `sja1000` | the families are \"mcp2515\" and \"at90can\"");
    const Outcome outcome =
        read(head + "[gateway.bit_timing]\ncan1 = { clock_hz = 1000000001, family = \"mcp2515\" }\n" +
             governor + gateway);
    EXPECT_TRUE(outcome.findings.has_errors());
    EXPECT_FALSE(outcome.settings().can1_bit_timing);
}

TEST(InputSections, nodes_are_checked_one_by_one) {
    const Outcome outcome =
        read(head + "[network]\nnodes = [2, 0, 128, \"3\", 5, 2, 127, 2]\n" + governor + gateway);
    EXPECT_EQ(show(outcome.findings),
              "E0104 4:13 a node id is 0, outside 1..127\n"
              "E0104 4:16 a node id is 128, outside 1..127\n"
              "E0102 4:21 a node id must be an integer, not a string\n"
              "E0115 4:29 node 2 is listed twice [first listed here 4:10]\n"
              "E0115 4:37 node 2 is listed twice [first listed here 4:10]");
    ASSERT_EQ(outcome.settings().network_nodes.size(), 3U);
    EXPECT_EQ(outcome.settings().network_nodes[2].node_id, 127);
    EXPECT_EQ(top_findings("[network]\nnodes = 2\n"), "E0102 4:9 `nodes` must be a list, not an integer");
}

TEST(InputSections, unknown_keys_and_tables_are_errors_everywhere) {
    EXPECT_EQ(top_findings("titel = 'x'\n"),
              "E0101 3:1 unknown key `titel` at the top of the file | did you mean `title`?");
    EXPECT_EQ(top_findings("[gatway]\n"),
              "E0101 3:2 unknown table `gatway` at the top of the file | did you mean `gateway`?");
    EXPECT_EQ(top_findings("[document]\nvendor = 1\n"), "E0101 4:1 unknown key `vendor` in [document]");
    EXPECT_EQ(top_findings("[governor]\nmain_cycle = 1000\n"),
              "E0101 4:1 unknown key `main_cycle` in [governor] | did you mean `main_cycle_us`?");
    EXPECT_EQ(top_findings("[gateway]\nidentiy = {}\n"),
              "E0101 4:1 unknown table `identiy` in [gateway] | did you mean `identity`?");
    EXPECT_EQ(top_findings("[network]\nnode = [1]\n"),
              "E0101 4:1 unknown key `node` in [network] | did you mean `nodes`?");
    EXPECT_EQ(top_findings("[[network]]\n"), "E0102 3:1 `network` must be a table, not a list");
}

TEST(InputSections, a_slip_in_a_key_is_one_finding) {
    EXPECT_EQ(show(read("format = 1\ntitel = 't'\n" + governor + gateway).findings),
              "E0101 2:1 unknown key `titel` at the top of the file | did you mean `title`?");
    EXPECT_EQ(show(read(head + "[govenor.parameters]\n401 = 1\n403 = 1\n416 = 250\n" + gateway).findings),
              "E0101 3:2 unknown table `govenor` at the top of the file | did you mean `governor`?");
    EXPECT_EQ(show(read(head +
                        "[governor]\nmain_cycle_us = 1000\n[governor.paramters]\n401 = 1\n403 = 1\n"
                        "416 = 250\n" +
                        gateway)
                       .findings),
              "E0101 5:11 unknown table `paramters` in [governor] | did you mean `parameters`?");
}

TEST(InputSections, two_slips_in_required_keys_are_two_findings) {
    EXPECT_EQ(test::top_findings("[gateway.bit_timing]\ncan1 = { clok_hz = 1, famly = \"mcp2515\" }\n"),
              "E0101 4:10 unknown key `clok_hz` in [gateway.bit_timing.can1] | did you mean `clock_hz`?\n"
              "E0101 4:23 unknown key `famly` in [gateway.bit_timing.can1] | did you mean `family`?");
}

TEST(InputSections, a_table_under_two_names_is_read_whole) {
    EXPECT_EQ(show(read(head + "[governer.parameters]\n401 = 1\n[governor.parameters]\n403 = 1\n416 = 250\n" +
                        gateway)
                       .findings),
              "E0101 3:2 unknown table `governer` at the top of the file | did you mean `governor`?");
}

TEST(InputSections, parameters_outside_their_table_get_advice) {
    EXPECT_EQ(top_findings("[governor]\n4406 = 1\n"),
              "E0101 4:1 unknown key `4406` in [governor] | parameters of the governor stand in "
              "[governor.parameters]");
    EXPECT_EQ(top_findings("[gateway]\nCanOpenMyNodeID = 1\n"),
              "E0101 4:1 unknown key `CanOpenMyNodeID` in [gateway] | "
              "parameters of the gateway stand in [gateway.parameters]");
}

TEST(InputSections, all_mistakes_are_reported_in_one_run) {
    const Outcome outcome = read(
        "format = 1\n[document]\nrevision = -1\n[governor.parameters]\n401 = 0\n[network]\nnodes = [0]\n");
    EXPECT_EQ(show(outcome.findings),
              "E0109 0:0 401 CanMyNodeNumber of the gateway is missing and has no default | "
              "below [gateway.parameters] write 401 = VALUE, where VALUE is 1..31\n"
              "E0109 0:0 402 CanDCNodeNumber of the gateway is missing and has no default | "
              "below [gateway.parameters] write 402 = VALUE, where VALUE is 1..31\n"
              "E0109 0:0 416 HzmCanBaudrate of the gateway is missing and has no default | "
              "set it, or 4416 HzmCanSegmOrBaudrate = 1 and the bit timing by hand\n"
              "E0109 0:0 426 CanOpenBaudrate of the gateway is missing and has no default | "
              "set it, or 4426 CanOpSegmOrBaudrate = 1 and the bit timing by hand\n"
              "E0109 0:0 427 CanOpenMyNodeID of the gateway is missing and has no default | "
              "below [gateway.parameters] write 427 = VALUE, where VALUE is 1..127\n"
              "E0104 3:12 `revision` is -1, outside 0..255\n"
              "E0109 4:1 403 CanCMNodeNumber of the governor is missing and has no default | "
              "below [governor.parameters] write 403 = VALUE, where VALUE is 1..31\n"
              "E0109 4:1 416 CanBaudrate of the governor is missing and has no default | "
              "set it, or 4416 CanSegmentOrBaudrate = 1 and the bit timing by hand\n"
              "E0111 5:7 401 CanMyNodeNumber is 0, outside 1..31\n"
              "E0104 7:10 a node id is 0, outside 1..127");
}

}  // namespace
}  // namespace cgw
