#include "media/slcan_channel.hpp"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>

#include <array>
#include <filesystem>

#include "channel_events.hpp"
#include "support/recording_port.hpp"
#include "support/scratch_directory.hpp"

namespace cgw::media {
namespace {

using test::ChannelEvents;
using test::Events;
using test::make_frame;

constexpr int patience_ms = 5'000;

bool wait_for(int descriptor, short events) {
    pollfd entry{descriptor, events, 0};
    return ::poll(&entry, 1, patience_ms) == 1;
}

// An adapter that does nothing by itself: the far end of a pseudo terminal, under a name that stays.
class Adapter {
  public:
    Adapter() {
        path = scratch_.write("adapter", "");
        plug_in();
    }

    void plug_in() {
        int own = -1;
        int other = -1;
        std::array<char, 256> name{};
        ASSERT_EQ(::openpty(&own, &other, name.data(), nullptr, nullptr), 0);
        ::close(other);
        own_ = Descriptor(own);
        ASSERT_EQ(::fcntl(own, F_SETFL, O_NONBLOCK), 0);
        std::filesystem::remove(path);
        std::filesystem::create_symlink(name.data(), path);
    }
    void unplug() { own_.close(); }

    void say(std::string_view text) {
        ASSERT_EQ(::write(own_.get(), text.data(), text.size()), static_cast<ssize_t>(text.size()));
    }

    // What it was told, once that ends with `end` or nothing more comes.
    std::string hear(std::string_view end) {
        std::string heard;
        while (!heard.ends_with(end) && wait_for(own_.get(), POLLIN)) {
            heard += hear_now();
        }
        return heard;
    }
    std::string hear_now() {
        std::array<char, 4096> buffer{};
        const ssize_t count = ::read(own_.get(), buffer.data(), buffer.size());
        return {buffer.data(), static_cast<std::size_t>(count < 0 ? 0 : count)};
    }

    std::string path;

  private:
    test::ScratchDirectory scratch_;
    Descriptor own_;
};

class Slcan : public testing::Test {
  protected:
    void SetUp() override {
        base::Result<std::unique_ptr<Channel>> opened = open_slcan(adapter.path, 250);
        ASSERT_TRUE(opened.has_value()) << opened.error().message;
        channel = std::move(*opened);
    }

    void service(Time now) { channel->service(now, events); }
    // What the adapter says arrives a moment later.
    void service_after(std::string_view said, Time now) {
        adapter.say(said);
        ASSERT_TRUE(wait_for(channel->descriptor(), POLLIN));
        service(now);
    }
    void open() {
        service(0);
        service(100'000);
        service_after("\r", 110'000);
        service_after("\r", 120'000);
        adapter.hear("O\r");
        events.take();
    }
    std::string line(LinkState state, const std::string& reason) const {
        return (state == LinkState::up ? "up " : "down ") + adapter.path + ": " + reason;
    }

    Adapter adapter;
    ChannelEvents events;
    std::unique_ptr<Channel> channel;
};

TEST_F(Slcan, sets_the_adapter_up_before_it_says_that_it_is_up) {
    EXPECT_EQ(channel->deadline(), 0U);
    EXPECT_FALSE(channel->send(make_frame(1, {})));
    service(0);
    EXPECT_EQ(adapter.hear("C\r"), "\r\r\rC\r");
    EXPECT_EQ(channel->deadline(), 100'000U);
    service_after("\a\a\r", 50'000);  // it was closed, and says so
    EXPECT_EQ(channel->deadline(), 100'000U);
    service(100'000);
    EXPECT_EQ(adapter.hear("\r"), "S5\r");
    service_after("\r", 110'000);
    EXPECT_EQ(adapter.hear("\r"), "O\r");
    EXPECT_FALSE(channel->send(make_frame(1, {})));
    EXPECT_EQ(events.take(), Events{});
    service_after("\r", 120'000);
    EXPECT_EQ(events.take(), Events{line(LinkState::up, "the adapter is open at 250 kbit/s")});
    EXPECT_EQ(channel->deadline(), never);
    EXPECT_EQ(channel->events(), POLLIN);
}

TEST_F(Slcan, takes_an_adapter_that_answers_nothing_as_one_that_obeys) {
    service(0);
    for (const Time now : {Time{100'000}, Time{400'000}}) {
        EXPECT_EQ(channel->deadline(), now);
        service(now);
    }
    EXPECT_EQ(events.take(), Events{});
    service(700'000);
    EXPECT_EQ(adapter.hear("O\r"), "\r\r\rC\rS5\rO\r");
    EXPECT_EQ(events.take(), Events{line(LinkState::up, "the adapter is open at 250 kbit/s")});
}

TEST_F(Slcan, takes_no_frames_of_a_channel_that_it_has_not_opened_yet) {
    service(0);
    service_after("t7050\rt705\r", 50'000);
    service(100'000);
    service_after("t7050\rt705\r", 110'000);
    EXPECT_EQ(events.take(), Events{});
}

TEST_F(Slcan, takes_frames) {
    open();
    service_after("t181211A2\rT000123450\rr7050\r", 200'000);
    EXPECT_EQ(events.take(), (Events{"frame 181#11A2", "frame 00012345#", "frame 705#R"}));
}

TEST_F(Slcan, takes_a_frame_that_comes_in_pieces) {
    open();
    service_after("t1812", 200'000);
    EXPECT_EQ(events.take(), Events{});
    service_after("11A2\rt18", 210'000);
    EXPECT_EQ(events.take(), Events{"frame 181#11A2"});
}

TEST_F(Slcan, counts_damaged_frames_and_passes_over_other_junk) {
    open();
    service_after("t18121\rhello\r\rz\rt7050\r", 200'000);
    EXPECT_EQ(events.take(), (Events{"lost 1", "frame 705#"}));
}

TEST_F(Slcan, sends_a_line_for_a_frame) {
    open();
    EXPECT_TRUE(channel->send(make_frame(0x701, {5})));
    EXPECT_EQ(adapter.hear("\r"), "t701105\r");
}

TEST_F(Slcan, says_not_now_when_the_adapter_takes_nothing_and_loses_nothing) {
    open();
    std::size_t sent = 0;
    const auto send_all = [&] {
        while (sent < 1'000'000 && channel->send(make_frame(static_cast<std::uint32_t>(sent % 0x800),
                                                            {1, 2, 3, 4, 5, 6, 7, 8}))) {
            ++sent;
        }
    };
    send_all();
    ASSERT_LT(sent, 1'000'000U);
    EXPECT_EQ(channel->events(), POLLIN | POLLOUT);
    EXPECT_EQ(channel->deadline(), never);

    std::string heard;
    const std::size_t first = sent;
    for (Time now = 200'000; sent < first + 10 && now < 10'000'000; now += 1'000) {
        heard += adapter.hear_now();
        ::poll(nullptr, 0, 1);
        service(now);
        send_all();
    }
    EXPECT_GE(sent, first + 10);
    std::size_t expected = 0;
    for (std::size_t begin = 0, end = 0; (end = heard.find('\r', begin)) != std::string::npos;
         begin = end + 1) {
        EXPECT_EQ(heard.substr(begin, end - begin),
                  fmt::format("t{:03X}80102030405060708", expected++ % 0x800));
    }
    EXPECT_GT(expected, 10U);
}

TEST_F(Slcan, tells_once_a_second_that_the_adapter_refuses_frames) {
    open();
    const std::string refused = line(LinkState::up, "the adapter refused a frame, which is lost");
    service_after("\a\a", 1'000'000);
    service_after("\a", 1'999'999);
    EXPECT_EQ(events.take(), Events{refused});
    service_after("\a", 2'000'000);
    EXPECT_EQ(events.take(), Events{refused});
}

TEST_F(Slcan, is_down_when_the_adapter_refuses_the_bit_rate_and_tries_again) {
    service(0);
    service(100'000);
    service_after("\a", 110'000);
    EXPECT_EQ(events.take(), Events{line(LinkState::down, "the adapter refuses 250 kbit/s")});
    EXPECT_EQ(channel->descriptor(), -1);
    adapter.hear_now();
    const Time again = channel->deadline();
    EXPECT_GT(again, 110'000U);
    EXPECT_LE(again, 1'110'000U);
    service(again);
    EXPECT_EQ(adapter.hear("C\r"), "\r\r\rC\r");
    service(again + 100'000);
    service_after("\a", again + 110'000);
    EXPECT_EQ(events.take(), Events{});  // nothing new
}

TEST_F(Slcan, is_down_when_the_adapter_refuses_to_open) {
    service(0);
    service(100'000);
    service_after("\r", 110'000);
    service_after("\a", 120'000);
    EXPECT_EQ(events.take(), Events{line(LinkState::down, "the adapter refuses to open its channel")});
}

TEST_F(Slcan, is_down_while_the_adapter_is_unplugged_and_comes_back) {
    open();
    service_after("t18", 200'000);
    adapter.unplug();
    service(210'000);
    EXPECT_EQ(events.take(), Events{line(LinkState::down, "the adapter is gone")});
    EXPECT_EQ(channel->descriptor(), -1);
    EXPECT_FALSE(channel->send(make_frame(1, {})));
    service(channel->deadline());
    service(channel->deadline());
    EXPECT_EQ(events.take(), Events{line(LinkState::down, "there is no such serial port")});

    adapter.plug_in();
    for (int i = 0; i < 4; ++i) {
        service(channel->deadline());
    }
    EXPECT_EQ(adapter.hear("O\r"), "\r\r\rC\rS5\rO\r");
    EXPECT_EQ(events.take(), Events{line(LinkState::up, "the adapter is open at 250 kbit/s")});
    service_after("t7050\r", 60'000'000);
    EXPECT_EQ(events.take(), Events{"frame 705#"});
}

TEST_F(Slcan, finds_an_unplugged_adapter_when_it_sends) {
    open();
    service(200'000);
    adapter.unplug();
    EXPECT_FALSE(channel->send(make_frame(1, {})));
    EXPECT_LE(channel->deadline(), 200'000U);
    service(200'000);
    EXPECT_EQ(events.take(), Events{line(LinkState::down, "the adapter is gone")});
}

TEST_F(Slcan, closes_the_adapter_behind_itself) {
    open();
    channel.reset();
    EXPECT_EQ(adapter.hear("\r"), "C\r");
}

TEST(OpenSlcan, refuses_a_bit_rate_that_slcan_has_not) {
    const auto opened = open_slcan("/dev/ttyACM0", 300);
    ASSERT_FALSE(opened.has_value());
    EXPECT_EQ(opened.error().message,
              "/dev/ttyACM0: slcan has no 300 kbit/s; it has 10, 20, 50, 100, 125, 250, 500, 800, 1000");
}

TEST(OpenSlcan, says_clearly_why_it_cannot_be_opened) {
    const auto missing = open_slcan("/dev/no-such-adapter", 250);
    ASSERT_FALSE(missing.has_value());
    EXPECT_EQ(missing.error().message, "/dev/no-such-adapter: there is no such serial port");
    const auto other = open_slcan("/dev/null", 250);
    ASSERT_FALSE(other.has_value());
    EXPECT_EQ(other.error().message, "/dev/null: it is no serial port");
}

}  // namespace
}  // namespace cgw::media
