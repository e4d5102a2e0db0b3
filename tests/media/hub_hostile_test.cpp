// Clients that read slowly, not at all, or say what no client would say.
#include <random>

#include "media/fuzz_seeds.hpp"
#include "media/hub_fixture.hpp"

namespace cgw::media {
namespace {

using test::HubBench;
using test::RawClient;

std::size_t count(std::string_view text, std::string_view part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1)) {
        ++found;
    }
    return found;
}

// Identifiers of the frames in `heard` in order, and how many frames it says are lost; what it says of frames
// must be all there is.
struct Heard {
    std::vector<std::uint32_t> ids;
    std::uint64_t lost = 0;
};

Heard listen(std::string_view heard) {
    MessageStream stream;
    stream.append(heard);
    Heard result;
    std::string_view text;
    while (stream.next(text) == MessageStream::Item::message) {
        if (next_word(text) == "frame") {
            result.ids.push_back(parse_frame(text)->id);
            // The next one in order, with as many missing as the hub has said.
            EXPECT_EQ(result.ids.back(), result.ids.size() - 1 + result.lost);
        } else {
            result.lost += parse_lost(text).value_or(0);
        }
    }
    return result;
}

std::string numbered(std::uint32_t number) {
    frame::Frame frame;
    frame.id = number;
    frame.extended = true;
    return send_message(frame);
}

TEST(HubSlowClient, loses_the_newest_frames_is_told_how_many_and_disturbs_nobody) {
    HubBench bench({.buses = {}, .limits = {.queued_bytes = 4000}});
    RawClient sender(bench, "sender");
    RawClient fast(bench, "fast");
    RawClient slow(bench, "slow");
    for (RawClient* client : {&sender, &fast, &slow}) {
        client->join("can0");
    }
    constexpr std::uint32_t frames = 5000;
    std::string fast_heard;
    for (std::uint32_t number = 0; number < frames; ++number) {
        ASSERT_NE(sender.say(numbered(number)), 0U);
        fast_heard += fast.hear();
    }
    const std::uint64_t lost = bench.hub.counters().lost;
    EXPECT_GT(lost, 0U);
    EXPECT_LT(lost, frames);
    const Heard all = listen(fast_heard);
    EXPECT_EQ(all.ids.size(), frames);
    EXPECT_EQ(all.lost, 0U);
    const Heard some = listen(slow.hear());
    EXPECT_EQ(some.ids.size() + some.lost, frames);
    EXPECT_EQ(some.lost, lost);
    // Back again, nothing is lost any more.
    sender.say(numbered(frames));
    EXPECT_EQ(slow.hear(), fast.hear());
}

TEST(HubSlowClient, that_takes_a_little_is_told_of_losses_where_they_happened) {
    HubBench bench({.buses = {}, .limits = {.queued_bytes = 1000}});
    RawClient sender(bench, "sender");
    RawClient slow(bench, "slow");
    sender.join("can0");
    slow.join("can0");
    constexpr std::uint32_t frames = 8000;
    std::string heard;
    for (std::uint32_t number = 0; number < frames; ++number) {
        sender.say(numbered(number));
        if (number % 2000 == 1999) {
            heard += slow.hear();
        }
    }
    const Heard result = listen(heard + slow.hear());
    EXPECT_GT(result.lost, 0U);
    EXPECT_EQ(result.ids.size() + result.lost, frames);
}

TEST(HubSlowClient, that_is_stuck_is_let_go) {
    HubBench bench;
    RawClient sender(bench, "sender");
    RawClient dead(bench, "dead");
    sender.join("can0");
    dead.join("can0");
    std::uint32_t number = 0;
    while (bench.hub.counters().lost < 10) {
        sender.say(numbered(number++));
    }
    bench.pass(HubLimits{}.stuck - 1);
    EXPECT_EQ(bench.hub.clients(), 2U);
    bench.pass(1);
    EXPECT_EQ(bench.hub.clients(), 1U);
    EXPECT_EQ(bench.reports.back(), "dead is gone: has taken nothing for 10 s, 10 frames were lost for it");
    EXPECT_EQ(sender.ask("< echo >"), "< echo >");
}

TEST(HubSlowClient, that_takes_something_now_and_then_stays) {
    HubBench bench({.buses = {}, .limits = {.queued_bytes = 4000}});
    RawClient sender(bench, "sender");
    RawClient slow(bench, "slow");
    sender.join("can0");
    slow.join("can0");
    for (int round = 0; round < 5; ++round) {
        const std::uint64_t lost = bench.hub.counters().lost;
        while (bench.hub.counters().lost == lost) {
            sender.say(numbered(0));
        }
        bench.pass(HubLimits{}.stuck - 1);
        slow.hear();
    }
    EXPECT_EQ(bench.hub.clients(), 2U);
}

TEST(HubHostileClient, a_message_without_end_is_answered_and_the_client_let_go) {
    HubBench bench;
    RawClient client(bench, "one");
    const std::string megabytes(3'000'000, 'x');
    EXPECT_LT(client.say("< send " + megabytes), megabytes.size());
    EXPECT_EQ(client.hear(), "< hi >< error message too long >");
    EXPECT_TRUE(client.closed());
    EXPECT_EQ(bench.reports.back(), "one is gone: sends what is no message");
}

TEST(HubHostileClient, megabytes_between_messages_are_answered_once) {
    HubBench bench;
    RawClient client(bench, "one");
    const std::string megabytes(3'000'000, '\0');
    EXPECT_EQ(client.say(megabytes), megabytes.size());
    EXPECT_EQ(client.ask("< echo >"), "< hi >< error text outside a message >< echo >");
}

TEST(HubHostileClient, who_does_not_read_answers_is_not_listened_to_until_he_does) {
    HubBench bench;
    RawClient client(bench, "one");
    RawClient other(bench, "two");
    client.ask("< open can0 >");
    std::string echoes;
    for (int i = 0; i < 100'000; ++i) {
        echoes += "<echo>";
    }
    std::size_t said = client.say(echoes);
    EXPECT_LT(said, echoes.size());
    EXPECT_EQ(other.ask("< echo >"), "< hi >< echo >");
    std::size_t answers = count(client.hear(), "< echo >");
    while (said < echoes.size()) {
        said += client.say(std::string_view(echoes).substr(said));
        answers += count(client.hear(), "< echo >");
    }
    EXPECT_EQ(answers, 100'000U);
}

TEST(HubHostileClient, what_was_not_listened_to_is_heard_as_soon_as_there_is_room) {
    HubBench bench({.buses = {}, .limits = {.queued_bytes = 1000}});
    RawClient client(bench, "one");
    std::string burst = "< open can0 >< rawmode >";
    for (int i = 0; i < 1000; ++i) {
        burst += "<echo>";
    }
    EXPECT_EQ(client.say(burst),
              burst.size());  // more answers than wait while the one to raw mode stands alone
    bench.pass(HubLimits{}.quiet_start);
    EXPECT_EQ(count(client.hear(), "< echo >"), 1000U);
}

TEST(HubHostileClient, who_neither_reads_answers_nor_stays_is_forgotten) {
    HubBench bench;
    {
        RawClient client(bench, "one");
        std::string echoes;
        for (int i = 0; i < 100'000; ++i) {
            echoes += "<echo>";
        }
        EXPECT_LT(client.say(echoes), echoes.size());
    }
    bench.settle();
    EXPECT_EQ(bench.hub.clients(), 0U);
}

// Pieces of the protocol and of what comes near it, in any order, cut anywhere.
std::string random_stream(std::mt19937& random, std::size_t pieces) {
    static const std::vector<std::string> parts = {"<",
                                                   ">",
                                                   " ",
                                                   "< ",
                                                   " >",
                                                   "open ",
                                                   "can0",
                                                   "can1",
                                                   "rawmode",
                                                   "< rawmode >",
                                                   "< open can0 >",
                                                   "send ",
                                                   "sendrtr ",
                                                   "123 ",
                                                   "1FFFFFFF ",
                                                   "20000000 ",
                                                   "8 1 2 3 4 5 6 7 8",
                                                   "0 ",
                                                   "9 ",
                                                   "-1 ",
                                                   "echo",
                                                   "< echo >",
                                                   "< send 123 2 1 f1 >",
                                                   "< sendrtr 7 8 >",
                                                   "frame ",
                                                   "error ",
                                                   "\n",
                                                   "99999999999999999999 "};
    std::string stream;
    for (std::size_t i = 0; i < pieces; ++i) {
        const std::uint32_t choice = random() % 64;
        if (choice < 48) {
            stream += parts[random() % parts.size()];
        } else if (choice < 63) {
            stream += static_cast<char>(random() % 256);
        } else {
            stream += std::string(random() % 300, static_cast<char>(random() % 256));
        }
    }
    return stream;
}

TEST(HubFuzz, no_stream_of_bytes_keeps_honest_clients_from_their_frames) {
    for (std::uint32_t seed = 1; seed <= test::fuzz_seeds(40); ++seed) {
        std::mt19937 random(seed);
        HubBench bench({.buses = {}, .limits = {.clients = 8, .queued_bytes = 2000}});
        RawClient honest(bench, "honest");
        RawClient listener(bench, "listener");
        honest.join("can9");
        listener.join("can9");
        std::vector<std::unique_ptr<RawClient>> others;
        for (int step = 0; step < 100; ++step) {
            if (others.size() < 4 || random() % 10 == 0) {
                others.push_back(std::make_unique<RawClient>(bench, "fuzz"));
            }
            RawClient& other = *others[random() % others.size()];
            other.say(random_stream(random, random() % 40));
            if (random() % 3 == 0) {
                other.hear();
            }
            if (others.size() > 6 || other.closed()) {
                others.erase(others.begin() + static_cast<std::ptrdiff_t>(random() % others.size()));
            }
            bench.pass(random() % 1'000'000);
            honest.say("< send 123 1 42 >");
            ASSERT_EQ(listener.hear(), "< frame 123 23.424242 42 >") << "seed " << seed << ", step " << step;
        }
        ASSERT_LE(bench.hub.clients(), 8U);
    }
}

}  // namespace
}  // namespace cgw::media
