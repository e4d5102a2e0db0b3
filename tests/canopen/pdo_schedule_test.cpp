// One transmit PDO, 185h with two bytes, under each transmission type.
#include "canopen/pdo_schedule.hpp"

#include "support/recording_port.hpp"

namespace cgw::canopen {
namespace {

using test::make_frame;
using test::RecordingPort;

class PdoScheduleTest : public testing::Test {
  protected:
    void start(const PdoTiming& timing, Time now = 0) {
        timings_[0] = timing;
        schedule_.start(now);
    }
    // What a device does: frames sent, and the next deadline in next_.
    std::size_t run(Time now) {
        schedule_.request_due(now, transmitter_);
        transmitter_.send_pending(port_);
        schedule_.send_samples(port_);
        next_ = schedule_.note_sent(now, transmitter_);
        return port_.take().size();
    }
    std::size_t sync(Time now, std::uint8_t counter = 0) {
        schedule_.sync(counter);
        return run(now);
    }
    static frame::Frame remote(std::uint32_t id = 0x185) {
        frame::Frame frame = make_frame(id, {});
        frame.remote = true;
        return frame;
    }

    std::array<std::uint8_t, 2> values_{1, 2};
    std::array<MappedValue, 1> mapping_{{{0, 2, false}}};
    std::array<PdoRow, 1> rows_{{{0x185, 2, mapping_}}};
    std::array<PdoTiming, 1> timings_;
    std::array<PdoScheduleState, 1> schedule_states_;
    std::array<TransmitState, 1> states_;
    PdoTransmitter transmitter_{rows_, states_, values_};
    PdoSchedule schedule_{rows_, timings_, schedule_states_, values_};
    RecordingPort port_;
    Time next_ = 0;
};

TEST_F(PdoScheduleTest, sends_an_event_driven_pdo_on_entry_and_with_each_event) {
    for (const std::uint8_t type : {std::uint8_t{254}, std::uint8_t{255}}) {
        start({.type = type});
        EXPECT_EQ(run(0), 1U);
        EXPECT_EQ(next_, never);
        EXPECT_EQ(run(10), 0U);
        schedule_.event(0);
        EXPECT_EQ(run(20), 1U);
        EXPECT_EQ(sync(30), 0U);
    }
}

TEST_F(PdoScheduleTest, keeps_the_inhibit_time_between_two_frames) {
    start({.inhibit = 500});
    EXPECT_EQ(run(0), 1U);
    schedule_.event(0);
    EXPECT_EQ(run(100), 0U);
    EXPECT_EQ(next_, 500U);
    schedule_.event(0);
    EXPECT_EQ(run(499), 0U);
    EXPECT_EQ(run(500), 1U);
    EXPECT_EQ(run(1000), 0U);
}

TEST_F(PdoScheduleTest, sends_without_an_event_when_its_timer_has_run_down) {
    start({.event_period = 1000});
    EXPECT_EQ(run(0), 1U);
    EXPECT_EQ(next_, 1000U);
    schedule_.event(0);
    EXPECT_EQ(run(400), 1U);
    EXPECT_EQ(next_, 1400U);  // counted from the last frame
    EXPECT_EQ(run(1399), 0U);
    EXPECT_EQ(run(1400), 1U);
}

TEST_F(PdoScheduleTest, lets_the_inhibit_time_hold_back_the_timer_too) {
    start({.inhibit = 2000, .event_period = 1000});
    EXPECT_EQ(run(0), 1U);
    EXPECT_EQ(run(1000), 0U);
    EXPECT_EQ(next_, 2000U);
    EXPECT_EQ(run(2000), 1U);
}

TEST_F(PdoScheduleTest, counts_inhibit_time_from_the_moment_the_port_took_the_frame) {
    start({.inhibit = 500});
    port_.room = 0;
    run(0);
    EXPECT_EQ(next_, never);  // the port is waited for, not time
    schedule_.event(0);       // is told of by the frame that waits
    run(300);
    port_.room = RecordingPort::unlimited;
    EXPECT_EQ(run(1000), 1U);
    schedule_.event(0);
    EXPECT_EQ(run(1499), 0U);
    EXPECT_EQ(run(1500), 1U);
    EXPECT_EQ(run(2000), 0U);
}

TEST_F(PdoScheduleTest, loses_no_event_that_comes_right_after_the_frame_left) {
    start({.inhibit = 500});
    schedule_.request_due(0, transmitter_);
    transmitter_.send_pending(port_);
    schedule_.event(0);
    schedule_.note_sent(0, transmitter_);
    EXPECT_EQ(port_.take().size(), 1U);
    EXPECT_EQ(run(500), 1U);
}

TEST_F(PdoScheduleTest, sends_an_acyclic_synchronous_pdo_at_the_sync_after_an_event) {
    start({.type = 0});
    EXPECT_EQ(sync(0), 0U);
    schedule_.event(0);
    EXPECT_EQ(run(10), 0U);
    EXPECT_EQ(sync(20), 1U);
    EXPECT_EQ(sync(30), 0U);
}

TEST_F(PdoScheduleTest, sends_a_cyclic_synchronous_pdo_at_every_nth_sync) {
    start({.type = 1});
    EXPECT_EQ(run(0), 0U);
    EXPECT_EQ(sync(1), 1U);
    EXPECT_EQ(sync(2), 1U);
    start({.type = 3});
    std::vector<std::size_t> sent;
    for (Time now = 0; now < 7; ++now) {
        schedule_.event(0);  // means nothing to it
        sent.push_back(sync(now));
    }
    EXPECT_EQ(sent, (std::vector<std::size_t>{0, 0, 1, 0, 0, 1, 0}));
    start({.type = 240});
    std::size_t count = 0;
    for (Time now = 0; now < 480; ++now) {
        count += sync(now);
    }
    EXPECT_EQ(count, 2U);
}

TEST_F(PdoScheduleTest, begins_to_count_at_its_sync_start_value) {
    start({.type = 2, .sync_start = 4});
    std::vector<std::size_t> sent;
    for (std::uint8_t counter = 1; counter < 9; ++counter) {
        sent.push_back(sync(counter, counter));
    }
    EXPECT_EQ(sent, (std::vector<std::size_t>{0, 0, 0, 1, 0, 1, 0, 1}));
}

TEST_F(PdoScheduleTest, ignores_the_start_value_when_sync_has_no_counter) {
    start({.type = 2, .sync_start = 4});
    EXPECT_EQ(sync(0), 0U);
    EXPECT_EQ(sync(1), 1U);
}

TEST_F(PdoScheduleTest, answers_a_remote_request_of_type_252_with_what_the_last_sync_found) {
    start({.type = 252, .remote_allowed = true});
    EXPECT_TRUE(schedule_.remote_request(remote()));
    EXPECT_EQ(run(0), 0U);  // nothing was sampled yet
    EXPECT_EQ(sync(1), 0U);
    values_ = {8, 9};
    schedule_.remote_request(remote());
    port_.room = 0;
    EXPECT_FALSE(schedule_.send_samples(port_));
    port_.room = 1;
    EXPECT_TRUE(schedule_.send_samples(port_));
    EXPECT_EQ(port_.take(), (std::vector{make_frame(0x185, {1, 2})}));
    EXPECT_EQ(run(2), 0U);
}

TEST_F(PdoScheduleTest, answers_a_remote_request_of_type_253_with_the_values_of_now) {
    start({.type = 253, .remote_allowed = true});
    schedule_.event(0);
    EXPECT_EQ(run(0), 0U);
    EXPECT_EQ(sync(0), 0U);
    EXPECT_TRUE(schedule_.remote_request(remote()));
    values_ = {8, 9};
    schedule_.request_due(0, transmitter_);
    transmitter_.send_pending(port_);
    EXPECT_EQ(port_.take(), (std::vector{make_frame(0x185, {8, 9})}));
}

TEST_F(PdoScheduleTest, answers_remote_requests_of_event_driven_pdos_within_their_inhibit_time) {
    start({.remote_allowed = true, .inhibit = 100});
    run(0);
    EXPECT_TRUE(schedule_.remote_request(remote()));
    EXPECT_EQ(run(50), 0U);
    EXPECT_EQ(run(100), 1U);
}

TEST_F(PdoScheduleTest, answers_no_remote_request_where_none_is_allowed) {
    start({.type = 253});
    EXPECT_FALSE(schedule_.remote_request(remote()));
    start({.type = 253, .remote_allowed = true});
    EXPECT_FALSE(schedule_.remote_request(remote(0x186)));
    EXPECT_FALSE(schedule_.remote_request(make_frame(0x185, {})));
    frame::Frame extended = remote();
    extended.extended = true;
    EXPECT_FALSE(schedule_.remote_request(extended));
    EXPECT_EQ(run(0), 0U);
}

TEST_F(PdoScheduleTest, forgets_everything_when_operational_ends) {
    start({.event_period = 100});
    schedule_.stop();
    EXPECT_EQ(run(1000), 0U);
    EXPECT_EQ(next_, never);
}

TEST_F(PdoScheduleTest, never_wakes_for_a_pdo_that_is_not_active) {
    rows_[0].length = 0;
    start({.event_period = 100});
    EXPECT_EQ(run(0), 0U);
    EXPECT_EQ(next_, never);
    EXPECT_EQ(run(1000), 0U);
}

}  // namespace
}  // namespace cgw::canopen
