#include "dbc/read.hpp"

#include <gtest/gtest.h>

namespace cgw::dbc {
namespace {

struct Result {
    Database database;
    diagnostic::Findings findings;
};

Result read_text(std::string_view text) {
    Result result;
    result.database = read(text, "a.dbc", result.findings);
    return result;
}

// "code line:column" of the one finding.
std::string finding_of(std::string_view text) {
    const Result result = read_text(text);
    EXPECT_EQ(result.findings.all().size(), 1U);
    if (result.findings.all().empty()) {
        return "";
    }
    const diagnostic::Diagnostic& first = result.findings.all().front();
    return std::string(first.rule->code) + " " + std::to_string(first.where.range.start.line) + ":" +
           std::to_string(first.where.range.start.column);
}

Database database() {
    Database made;
    made.version = "cgw";
    made.nodes = {{"GW12", ""}, {"Node1", ""}};
    made.comment = "text with\nBO_ 1 in it";
    Signal speed;
    speed.name = "Speed";
    speed.is_signed = true;
    speed.factor = 0.0625;
    speed.offset = -40;
    speed.minimum = -1e-7;
    speed.maximum = 4000;
    speed.unit = "1/min";
    speed.values = {{0, "off"}, {3, "on"}};
    Signal bit;
    bit.name = "Bit";
    bit.start_bit = 16;
    bit.length = 1;
    bit.multiplexing = "m0";
    Message& message = made.messages.emplace_back();
    message.identifier = 0x18C;
    message.name = "GW12_TPDO1";
    message.length = 4;
    message.sender = "GW12";
    speed.receivers = {"Node1", "Master"};
    bit.receivers = {"Node1"};
    message.send_type = SendType::cyclic;
    message.cycle_ms = 125;
    message.signals = {speed, bit};
    return made;
}

constexpr std::string_view one_message = "BO_ 396 A: 8 GW12\n";

}  // namespace

TEST(DbcRead, what_was_printed_comes_back) {
    const Result result = read_text(print(database()));
    EXPECT_TRUE(result.findings.all().empty());
    EXPECT_EQ(result.database.version, "cgw");
    ASSERT_EQ(result.database.messages.size(), 1U);
    const Message& message = result.database.messages[0];
    EXPECT_EQ(message.identifier, 0x18C);
    EXPECT_EQ(message.name, "GW12_TPDO1");
    EXPECT_EQ(message.length, 4);
    EXPECT_EQ(message.sender, "GW12");
    EXPECT_EQ(message.signals[0].receivers, (std::vector<std::string>{"Node1", "Master"}));
    EXPECT_EQ(message.signals[1].receivers, std::vector<std::string>{"Node1"});
    EXPECT_EQ(message.send_type, SendType::cyclic);
    EXPECT_EQ(message.cycle_ms, 125U);
    ASSERT_EQ(message.signals.size(), 2U);
    const Signal& speed = message.signals[0];
    EXPECT_EQ(speed.name, "Speed");
    EXPECT_TRUE(speed.is_signed);
    EXPECT_FALSE(speed.big_endian);
    EXPECT_EQ(speed.length, 16U);
    EXPECT_EQ(speed.factor, 0.0625);
    EXPECT_EQ(speed.offset, -40);
    EXPECT_EQ(speed.minimum, -1e-7);
    EXPECT_EQ(speed.maximum, 4000);
    EXPECT_EQ(speed.unit, "1/min");
    ASSERT_EQ(speed.values.size(), 2U);
    EXPECT_EQ(speed.values[1].value, 3U);
    EXPECT_EQ(speed.values[1].text, "on");
    EXPECT_EQ(message.signals[1].multiplexing, "m0");
    EXPECT_EQ(message.signals[1].start_bit, 16U);
}

TEST(DbcRead, takes_what_other_tools_write) {
    const Result result = read_text(
        "VERSION \"\"\n\nNS_ : \n\tBA_DEF_\n\tBA_\n\tVAL_\n\tSG_MUL_VAL_\n\nBS_:\nBU_: A B\n"
        "VAL_TABLE_ Table 1 \"on\" 0 \"off\" ;\n"
        "BO_ 2566834709 Extended: 8 A\n SG_ S : 7|8@0- (0.1,0) [0|0] \"V\" A,B\n"
        "BO_ 100 Motor: 8 A\n SG_ Torque m1 : 7|16@0- (0.1,0) [0|0] \"Nm\" A,B\n"
        "EV_ Env: 0 [0|1] \"\" 0 1 DUMMY_NODE_VECTOR0 Vector__XXX;\n"
        "BA_DEF_ BO_ \"GenMsgCycleTime\" INT 0 65535;\n"
        "BA_ \"GenMsgCycleTime\" BO_ 100 20;\nBA_ \"Other\" BO_ 100 \"text\";\n"
        "VAL_ Env 0 \"off\" ;\nCM_ SG_ 100 Torque \"over\ntwo lines\";\n");
    EXPECT_TRUE(result.findings.all().empty());
    ASSERT_EQ(result.database.messages.size(), 1U);
    const Message& motor = result.database.messages[0];
    EXPECT_EQ(motor.cycle_ms, 20U);
    EXPECT_TRUE(motor.standard_format);
    ASSERT_EQ(result.database.nodes.size(), 2U);
    EXPECT_EQ(result.database.nodes[1].name, "B");
    ASSERT_EQ(motor.signals.size(), 1U);
    EXPECT_TRUE(motor.signals[0].big_endian);
    EXPECT_EQ(motor.signals[0].multiplexing, "m1");
}

TEST(DbcRead, send_types_count_the_words_of_the_file_and_have_its_default) {
    const std::string messages = "BO_ 1 A: 8 N\nBO_ 2 B: 8 N\nBO_ 3 C: 8 N\n";
    const Result result =
        read_text(messages +
                  "BA_DEF_ BO_ \"GenMsgSendType\" ENUM  \"OnChange\",\"spontaneous\",\"cyclic\";\n"
                  "BA_DEF_DEF_ \"GenMsgSendType\" \"Cyclic\";\n"
                  "BA_DEF_DEF_ \"GenMsgCycleTime\" 20;\n"
                  "BA_ \"GenMsgSendType\" BO_ 1 0;\nBA_ \"GenMsgSendType\" BO_ 2 1;\n"
                  "BA_ \"GenMsgCycleTime\" BO_ 2 0;\n");
    EXPECT_TRUE(result.findings.all().empty());
    ASSERT_EQ(result.database.messages.size(), 3U);
    EXPECT_EQ(result.database.messages[0].send_type, SendType::other);
    EXPECT_EQ(result.database.messages[1].send_type, SendType::spontaneous);
    EXPECT_EQ(result.database.messages[2].send_type, SendType::cyclic);
    EXPECT_EQ(result.database.messages[1].cycle_ms, std::nullopt);
    EXPECT_EQ(result.database.messages[2].cycle_ms, 20U);
    EXPECT_EQ(read_text(messages).database.messages[0].send_type, SendType::not_stated);
    EXPECT_EQ(read_text(messages + "BA_ \"GenMsgSendType\" BO_ 1 9;\n").database.messages[0].send_type,
              SendType::other);
    EXPECT_EQ(finding_of(messages + "BA_ \"GenMsgSendType\" BO_ 1 x;\n"), "E1002 4:28");
}

TEST(DbcRead, frame_formats_count_the_words_of_the_file_or_those_that_all_tools_have) {
    const auto is_standard = [](const std::string& attributes) {
        return read_text("BO_ 1 A: 8 N\n" + attributes).database.messages.at(0).standard_format;
    };
    EXPECT_TRUE(is_standard("BA_ \"VFrameFormat\" BO_ 1 0;\n"));
    EXPECT_FALSE(is_standard("BA_ \"VFrameFormat\" BO_ 1 1;\n"));
    EXPECT_FALSE(is_standard("BA_DEF_DEF_ \"VFrameFormat\" \"ExtendedCAN\";\n"));
    EXPECT_TRUE(
        is_standard("BA_DEF_ BO_ \"VFrameFormat\" ENUM \"ExtendedCAN\",\"StandardCAN\";\n"
                    "BA_ \"VFrameFormat\" BO_ 1 1;\n"));
}

TEST(DbcRead, tells_where_a_statement_cannot_be_read) {
    EXPECT_EQ(finding_of(""), "E1001 0:0");
    EXPECT_EQ(finding_of("BO_ 396 A: 8 GW12\nCM_ \"open\n"), "E1001 2:5");
    EXPECT_EQ(finding_of(std::string(one_message) + " SG_ S : 0|16@2+ (1,0) [0|1] \"\" B\n"), "E1002 2:15");
    EXPECT_EQ(finding_of(std::string(one_message) + " SG_ S : 0|16@1+ (1,x) [0|1] \"\" B\n"), "E1002 2:21");
    EXPECT_EQ(finding_of(std::string(one_message) + " SG_ S : 0|99999@1+ (1,0) [0|1] \"\" B\n"),
              "E1002 2:12");
    EXPECT_EQ(finding_of(std::string(one_message) + "BO_ 2048 B: 8 GW12\n"), "E1002 2:5");
    EXPECT_EQ(
        finding_of(std::string(one_message) + "BO_ 396 B: 8 GW12\n SG_ S : 0|1@1+ (1,0) [0|1] \"\" B\n"),
        "E1003 2:5");
    EXPECT_EQ(finding_of(std::string(one_message) + "BO_ 397"), "E1002 2:5");
}

TEST(DbcRead, reads_on_behind_a_mistake) {
    const Result result = read_text("BO_ x A: 8 GW12\nBO_ 397 B: 8 GW12\n");
    EXPECT_EQ(result.findings.all().size(), 1U);
    ASSERT_EQ(result.database.messages.size(), 1U);
    EXPECT_EQ(result.database.messages[0].name, "B");
}

TEST(DbcRead, no_prefix_and_no_changed_byte_of_a_file_does_harm) {
    const std::string text = print(database());
    for (std::size_t i = 0; i < text.size(); ++i) {
        read_text(std::string_view(text).substr(0, i));
        for (const char byte : {'\0', '"', '-', '9', '\n', '\xFF'}) {
            std::string changed = text;
            changed[i] = byte;
            read_text(changed);
        }
    }
}

}  // namespace cgw::dbc
