#include "media/open_channel.hpp"

#include "media/hub.hpp"
#include "media/recording_listener.hpp"

namespace cgw::media {
namespace {

std::string refusal(std::string_view text) {
    const auto channel = open_channel(text);
    return channel ? "opened" : channel.error().message;
}

TEST(OpenChannel, opens_a_bus_of_a_hub) {
    for (const char* text : {"hub:127.0.0.1:29536", "hub:localhost:1/can1", "hub:[::1]:29536/vcan0"}) {
        EXPECT_EQ(refusal(text), "opened") << text;
    }
}

TEST(OpenChannel, joins_the_bus_that_is_named) {
    std::vector<std::string> reports;
    Hub hub(
        {}, [] { return 0U; }, [&](std::string_view line) { reports.emplace_back(line); });
    ASSERT_TRUE(hub.listen({"127.0.0.1", 0}));
    Loop loop;
    loop.add(hub);
    for (const std::string bus : {"", "/can7"}) {
        const auto channel = open_channel("hub:" + hub.address() + bus);
        ASSERT_TRUE(channel);
        test::RecordingListener listener;
        ChannelSource source(**channel, listener);
        Loop both;
        both.add(hub);
        both.add(source);
        for (const Time end = both.now() + 30'000'000; listener.links.empty() && both.now() < end;) {
            both.turn(end);
        }
        const std::string name = bus.empty() ? "can0" : "can7";
        EXPECT_EQ(listener.links,
                  std::vector<std::string>{"up hub:" + hub.address() + bus + ": on bus " + name});
    }
}

TEST(OpenChannel, says_how_a_bus_is_written) {
    const std::string forms =
        " is no CAN bus; write hub:HOST:PORT[/BUS] or socketcan:INTERFACE or slcan:TTY@KBIT";
    EXPECT_EQ(refusal(""), "''" + forms);
    EXPECT_EQ(refusal("can0"), "'can0'" + forms);
    EXPECT_EQ(refusal("tcp:127.0.0.1:1"), "'tcp:127.0.0.1:1'" + forms);
}

TEST(OpenChannel, says_what_is_wrong_with_a_hub) {
    const std::string write = "; write hub:HOST:PORT[/BUS]";
    EXPECT_EQ(refusal("hub:"), "'hub:': '' is not HOST:PORT" + write);
    EXPECT_EQ(refusal("hub:29536"), "'hub:29536': '29536' is not HOST:PORT" + write);
    EXPECT_EQ(refusal("hub::29536"), "'hub::29536': ':29536' is not HOST:PORT" + write);
    EXPECT_EQ(refusal("hub:[]:1"), "'hub:[]:1': '[]:1' is not HOST:PORT with a port 0..65535" + write);
    EXPECT_EQ(refusal("hub:h:"), "'hub:h:': 'h:' is not HOST:PORT with a port 0..65535" + write);
    EXPECT_EQ(refusal("hub:h:+1"), "'hub:h:+1': 'h:+1' is not HOST:PORT with a port 0..65535" + write);
    EXPECT_EQ(refusal("hub:h:65536"),
              "'hub:h:65536': 'h:65536' is not HOST:PORT with a port 0..65535" + write);
    EXPECT_EQ(refusal("hub:::1:1"),
              "'hub:::1:1': '::1:1': an IPv6 address stands in brackets: [::1]:29536" + write);
    EXPECT_EQ(refusal("hub:127.0.0.1:0"),
              "'hub:127.0.0.1:0': port 0 is nobody's; cgw hub says on which port it listens" + write);
    EXPECT_EQ(refusal("hub:127.0.0.1:1/"),
              "'hub:127.0.0.1:1/': a bus has a name of 1..16 letters, digits, '.', '_' or '-'" + write);
    EXPECT_EQ(refusal("hub:no host:1").substr(0, 33), "'hub:no host:1': host 'no host': ");
}

TEST(OpenChannel, says_what_is_wrong_with_an_interface_or_adapter) {
    EXPECT_EQ(refusal("socketcan:"), "'socketcan:': no interface is named; write socketcan:INTERFACE");
    EXPECT_TRUE(refusal("socketcan:nocan9").starts_with("nocan9: ")) << refusal("socketcan:nocan9");
    for (const char* text : {"slcan:/dev/ttyACM0", "slcan:@250", "slcan:/dev/ttyACM0@",
                             "slcan:/dev/ttyACM0@x", "slcan:/dev/ttyACM0@-1", "slcan:/dev/ttyACM0@99999"}) {
        EXPECT_EQ(refusal(text),
                  "'" + std::string(text) + "': a port and a bit rate are needed; write slcan:TTY@KBIT");
    }
    EXPECT_NE(refusal("slcan:/dev/null@250"), "opened");
    EXPECT_NE(refusal("slcan:/dev/no-such-tty@250"), "opened");
}

TEST(ChannelMistake, is_one_of_the_text_and_not_of_the_world) {
    for (const char* text : {"", "can0", "hub:", "hub:h:0", "socketcan:", "slcan:/dev/ttyACM0"}) {
        EXPECT_EQ(channel_mistake(text), refusal(text));
    }
    for (const char* text : {"hub:no host:1", "socketcan:nocan9", "slcan:/dev/no-such-tty@250"}) {
        EXPECT_EQ(channel_mistake(text), "");
    }
}

TEST(OpenChannel, has_a_row_for_every_kind) {
    for (const ChannelKind& kind : channel_kinds()) {
        EXPECT_TRUE(kind.form.starts_with(std::string(kind.name) + ":"));
        EXPECT_FALSE(kind.summary.empty());
    }
}

}  // namespace
}  // namespace cgw::media
