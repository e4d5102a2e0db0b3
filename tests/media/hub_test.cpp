#include "media/hub.hpp"

#include "media/hub_fixture.hpp"

namespace cgw::media {
namespace {

using test::HubBench;
using test::RawClient;

TEST(Hub, greets_opens_and_enters_raw_mode) {
    HubBench bench;
    RawClient client(bench, "one");
    EXPECT_EQ(client.hear(), "< hi >");
    EXPECT_EQ(client.ask("< open can0 >"), "< ok >");
    EXPECT_EQ(client.ask("< rawmode >"), "< ok >");
    EXPECT_EQ(client.ask("< rawmode >"), "< ok >");
    EXPECT_EQ(client.ask("< echo >"), "< echo >");
    EXPECT_EQ(bench.reports, std::vector<std::string>{"one joins bus can0"});
}

TEST(Hub, gives_a_frame_to_the_others_of_the_bus_and_not_to_its_sender) {
    HubBench bench;
    RawClient one(bench, "one");
    RawClient two(bench, "two");
    RawClient three(bench, "three");
    RawClient elsewhere(bench, "elsewhere");
    one.join("can0");
    two.join("can0");
    three.join("can0");
    elsewhere.join("can1");
    EXPECT_EQ(one.ask("< send 123 2 1 f1 >"), "");
    EXPECT_EQ(two.hear(), "< frame 123 23.424242 01F1 >");
    EXPECT_EQ(three.hear(), "< frame 123 23.424242 01F1 >");
    EXPECT_EQ(elsewhere.hear(), "");
    EXPECT_EQ(bench.hub.counters().frames, 1U);
}

TEST(Hub, carries_extended_and_remote_frames) {
    HubBench bench;
    RawClient one(bench, "one");
    RawClient two(bench, "two");
    one.join("can0");
    two.join("can0");
    EXPECT_EQ(one.ask("< send 00000123 0 >< send 1AAAAAAA 1 f >< sendrtr 705 4 >< sendrtr 1AAAAAAA 0 >"), "");
    EXPECT_EQ(two.hear(),
              "< frame 00000123 23.424242  >< frame 1AAAAAAA 23.424242 0F >< rtr 705 23.424242 4 >"
              "< rtr 1AAAAAAA 23.424242 0 >");
}

TEST(Hub, gives_no_frames_before_raw_mode_but_takes_them) {
    HubBench bench;
    RawClient one(bench, "one");
    RawClient two(bench, "two");
    one.ask("< open can0 >");
    two.join("can0");
    two.say("< send 1 0 >");
    EXPECT_EQ(one.hear(), "");
    one.say("< send 2 0 >");
    EXPECT_EQ(two.hear(), "< frame 002 23.424242  >");
}

TEST(Hub, takes_messages_that_come_in_pieces_or_all_at_once) {
    HubBench bench;
    RawClient one(bench, "one");
    RawClient two(bench, "two");
    two.join("can0");
    EXPECT_EQ(one.ask("< open can0 >< rawmode >< send 001 0 >< send 002 0 >< ec"), "< hi >< ok >< ok >");
    EXPECT_EQ(one.ask("ho >"), "< echo >");
    for (const char c : std::string("< send 003 1 a >")) {
        one.say(std::string(1, c));
    }
    EXPECT_EQ(two.hear(), "< frame 001 23.424242  >< frame 002 23.424242  >< frame 003 23.424242 0A >");
}

TEST(Hub, lets_the_answer_to_raw_mode_stand_alone) {
    HubBench bench;
    RawClient one(bench, "one");
    RawClient two(bench, "two");
    RawClient three(bench, "three");
    three.join("can0");
    for (RawClient* client : {&one, &two}) {
        client->ask("< open can0 >");
        client->say("< rawmode >");
    }
    three.say("< send 001 0 >");
    EXPECT_EQ(one.hear(), "< ok >");
    EXPECT_EQ(two.hear(), "< ok >");
    // Whoever says something has read the answer.
    EXPECT_EQ(two.ask("< send 002 0 >"), "< frame 001 23.424242  >");
    bench.pass(HubLimits{}.quiet_start - 1);
    EXPECT_EQ(one.hear(), "");
    bench.pass(1);
    EXPECT_EQ(one.hear(), "< frame 001 23.424242  >< frame 002 23.424242  >");
}

TEST(Hub, knows_only_the_buses_it_was_given) {
    HubBench bench({.buses = {"can1", "can2"}, .limits = {}});
    RawClient one(bench, "one");
    RawClient two(bench, "two");
    EXPECT_EQ(one.ask("< open can0 >"), "< hi >< error no bus can0; there is can1, can2 >");
    EXPECT_TRUE(one.closed());
    EXPECT_EQ(two.ask("< open can2 >"), "< hi >< ok >");
    EXPECT_EQ(bench.reports, (std::vector<std::string>{"one is gone: wants bus can0, which is not there",
                                                       "two joins bus can2"}));
}

TEST(Hub, answers_every_mistake_and_goes_on) {
    HubBench bench;
    RawClient client(bench, "one");
    EXPECT_EQ(client.ask("< send 1 0 >"), "< hi >< error open a bus first >");
    EXPECT_EQ(client.ask("< rawmode >"), "< error open a bus first >");
    for (const char* name :
         {"< open >", "< open can0 can1 >", "< open can/0 >", "< open 0123456789abcdefg >"}) {
        EXPECT_EQ(client.ask(name), "< error open one bus, whose name has 1..16 letters, digits, . _ or - >");
    }
    client.ask("< open can0 >");
    EXPECT_EQ(client.ask("< open can0 >"), "< error bus can0 is open already >");
    EXPECT_EQ(client.ask("< send 1 2 0 >"), "< error byte 2 of 2 is missing or wrong: '' >");
    EXPECT_EQ(client.ask("< sendrtr 1 9 >"), "< error no length 0..8: '9' >");
    EXPECT_EQ(client.ask("< subscribe 0 0 123 >"), "< error unknown message 'subscribe 0 0 123' >");
    EXPECT_EQ(client.ask("< " + std::string(100, 'x') + " >"),
              "< error unknown message 'xxxxxxxxxxxxxxxxxxxxxxxx...' >");
    EXPECT_EQ(client.ask("<>"), "< error unknown message '' >");
    EXPECT_EQ(client.ask("< Echo >< \x1b\xff >"),
              "< error unknown message 'Echo' >< error unknown message '?\?' >");
    EXPECT_EQ(client.ask("hello < echo > there"),
              "< error text outside a message >< echo >"
              "< error text outside a message >");
    EXPECT_EQ(bench.hub.counters().refused, 16U);
    EXPECT_EQ(bench.hub.clients(), 1U);
}

TEST(Hub, forgets_who_leaves) {
    HubBench bench;
    RawClient one(bench, "one");
    one.join("can0");
    {
        RawClient two(bench, "two");
        two.join("can0");
        EXPECT_EQ(bench.hub.clients(), 2U);
    }
    one.say("< send 1 0 >");
    EXPECT_EQ(bench.hub.clients(), 1U);
    EXPECT_EQ(bench.reports.back(), "two is gone: has closed the connection");
    EXPECT_EQ(one.ask("< echo >"), "< echo >");
}

TEST(Hub, takes_no_more_clients_than_its_limit) {
    HubBench bench({.buses = {}, .limits = {.clients = 2}});
    RawClient one(bench, "one");
    RawClient two(bench, "two");
    RawClient three(bench, "three");
    EXPECT_EQ(three.hear(), "< error the hub is full >");
    EXPECT_TRUE(three.closed());
    EXPECT_EQ(bench.hub.clients(), 2U);
    EXPECT_EQ(bench.reports.back(), "three is refused: there are 2 clients already");
    EXPECT_EQ(two.ask("< echo >"), "< hi >< echo >");
}

TEST(Hub, lets_go_who_opens_no_bus) {
    HubBench bench;
    RawClient one(bench, "one");
    RawClient two(bench, "two");
    two.ask("< open can0 >");
    bench.pass(HubLimits{}.opening - 1);
    EXPECT_FALSE(one.closed());
    EXPECT_EQ(bench.hub.deadline(), bench.now + 1);
    bench.pass(1);
    EXPECT_TRUE(one.closed());
    EXPECT_FALSE(two.closed());
    EXPECT_EQ(bench.reports.back(), "one is gone: has opened no bus for 30 s");
}

TEST(Hub, listens_on_a_free_port_and_says_which) {
    HubBench bench;
    ASSERT_TRUE(bench.hub.listen({"127.0.0.1", 0}));
    const auto where = parse_host_port(bench.hub.address());
    ASSERT_TRUE(where);
    EXPECT_EQ(where->host, "127.0.0.1");
    EXPECT_NE(where->port, 0);
    HubBench second;
    const auto refused = second.hub.listen(*where);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message,
              "cannot listen on " + bench.hub.address() + ": Address already in use");
    EXPECT_FALSE(second.hub.listen({"no host of that name", 0}));
}

}  // namespace
}  // namespace cgw::media
