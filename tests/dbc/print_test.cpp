#include <gtest/gtest.h>

#include "dbc/database.hpp"

namespace cgw::dbc {
namespace {

Database small() {
    Signal speed;
    speed.name = "Speed";
    speed.start_bit = 16;
    speed.is_signed = true;
    speed.factor = 0.5;
    speed.offset = -100;
    speed.minimum = -100;
    speed.maximum = 16283.5;
    speed.unit = "°C";
    speed.comment = "say \"a\\b\"\nagain";
    speed.values = {{0, "off"}, {1, "on"}};
    speed.receivers = {"Master"};
    Message message;
    message.identifier = 0x181;
    message.name = "TPDO1";
    message.length = 4;
    message.sender = "GW1";
    message.signals = {speed};
    message.send_type = SendType::cyclic;
    message.cycle_ms = 15;
    message.comment = "first";
    return {"v1", "all", {{"GW1", "the gateway"}, {"Master", ""}}, {message}};
}

bool has_line(const std::string& text, const std::string& line) {
    return text.find("\r\n" + line + "\r\n") != std::string::npos;
}

}  // namespace

TEST(DbcPrint, writes_nodes_messages_and_signals) {
    const std::string text = print(small());
    EXPECT_EQ(text.rfind("VERSION \"v1\"\r\n", 0), 0U);
    EXPECT_TRUE(has_line(text, "BU_: GW1 Master"));
    EXPECT_TRUE(has_line(text, "BO_ 385 TPDO1: 4 GW1"));
    EXPECT_TRUE(has_line(text, " SG_ Speed : 16|16@1- (0.5,-100) [-100|16283.5] \"degC\" Master"));
}

TEST(DbcPrint, writes_texts_as_ascii_without_quotes_and_backslashes) {
    const std::string text = print(small());
    EXPECT_TRUE(has_line(text, "CM_ SG_ 385 Speed \"say 'a/b' again\";"));
    EXPECT_TRUE(has_line(text, "CM_ \"all\";"));
    EXPECT_TRUE(has_line(text, "CM_ BU_ GW1 \"the gateway\";"));
    EXPECT_TRUE(has_line(text, "CM_ BO_ 385 \"first\";"));
    EXPECT_EQ(text.find("CM_ BU_ Master"), std::string::npos);
}

TEST(DbcPrint, writes_enumerations_as_indices_and_their_default_as_text) {
    const std::string text = print(small());
    EXPECT_TRUE(
        has_line(text, "BA_DEF_ BO_ \"GenMsgSendType\" ENUM \"Cyclic\",\"Spontaneous\",\"NoMsgSendType\";"));
    EXPECT_TRUE(has_line(text, "BA_DEF_DEF_ \"GenMsgSendType\" \"NoMsgSendType\";"));
    EXPECT_TRUE(has_line(text, "BA_ \"GenMsgSendType\" BO_ 385 0;"));
    EXPECT_TRUE(has_line(text, "BA_ \"GenMsgCycleTime\" BO_ 385 15;"));
    EXPECT_TRUE(has_line(text, "BA_ \"VFrameFormat\" BO_ 385 0;"));
    EXPECT_TRUE(has_line(text, "BA_ \"BusType\" \"CAN\";"));
}

TEST(DbcPrint, writes_value_tables_last) {
    const std::string text = print(small());
    const std::string last = "VAL_ 385 Speed 0 \"off\" 1 \"on\" ;\r\n";
    ASSERT_GT(text.size(), last.size());
    EXPECT_EQ(text.substr(text.size() - last.size()), last);
}

TEST(DbcPrint, names_nobody_where_sender_or_receiver_is_not_known) {
    Database database = small();
    database.messages[0].sender.clear();
    database.messages[0].signals[0].receivers.clear();
    database.messages[0].cycle_ms.reset();
    const std::string text = print(database);
    EXPECT_TRUE(has_line(text, "BO_ 385 TPDO1: 4 Vector__XXX"));
    EXPECT_NE(text.find("\"degC\" Vector__XXX\r\n"), std::string::npos);
    EXPECT_EQ(text.find("\"GenMsgCycleTime\" BO_ 385"), std::string::npos);
}

TEST(DbcPrint, is_ascii_only) {
    Database database = small();
    database.comment = "Größe – \x01 \xFF";
    for (const char c : print(database)) {
        EXPECT_TRUE((c >= ' ' && c <= '~') || c == '\r' || c == '\n' || c == '\t') << static_cast<int>(c);
    }
}

}  // namespace cgw::dbc
