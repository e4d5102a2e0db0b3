// A device as later ones will be: a slave with SYNC, scheduled PDOs, synchronous receive PDOs, node guarding,
// emergencies and a say in its objects. Shows how the parts are put together, and that they keep out of each
// other's way. Node 5; TPDO 185h event-driven with 1 ms inhibit time, TPDO 285h at every second SYNC, RPDO
// 205h synchronous, RPDO 305h at once.
#include "canopen/emergency.hpp"
#include "canopen/nmt.hpp"
#include "canopen/node_guarding.hpp"
#include "canopen/pdo_schedule.hpp"
#include "canopen/slave.hpp"
#include "canopen/sync.hpp"
#include "canopen/synchronous_receiver.hpp"
#include "canopen/table.hpp"
#include "support/recording_port.hpp"

namespace cgw::canopen {
namespace {

using object::AbortCode;
using test::make_frame;

class Device final : public ObjectHandler {
  public:
    explicit Device(frame::FramePort& port) : port_(&port), slave_(port) {
        using object::Access;
        using object::DataType;
        table_.add(0x1003, 0, DataType::unsigned8, Access::rw, 0, 0, history_objects)
            .add(0x1003, 1, DataType::unsigned32, Access::ro, 0, 0, history_objects)
            .add(0x1017, 0, DataType::unsigned16, Access::rw, 0, 0, heartbeat_time)
            .add(0x2000, 1, DataType::unsigned16, Access::ro, 0)
            .add(0x2000, 2, DataType::unsigned16, Access::ro, 0)
            .add(0x2001, 1, DataType::unsigned16, Access::rww, 0)
            .add(0x2001, 2, DataType::unsigned16, Access::rww, 0);
        for (std::size_t word = 0; word < mapping_.size(); ++word) {
            mapping_[word] = {static_cast<std::uint16_t>(first_word + 2 * word), 2, false};
        }
        const std::span<const MappedValue> words(mapping_);
        transmit_ = {{{0x185, 2, words.subspan(0, 1)}, {0x285, 2, words.subspan(1, 1)}}};
        synchronous_ = {{{0x205, 2, words.subspan(2, 1)}}};
        receive_ = {{{0x305, 2, words.subspan(3, 1)}}};
        schedule_ = PdoSchedule(transmit_, timings_, schedule_states_, table_.values);
        synchronous_receiver_ = SynchronousReceiver(synchronous_, waiting_, table_.values);
        Slave::Tables tables;
        tables.node_id = 5;
        tables.objects = table_.objects();
        tables.values = table_.values;
        tables.handler = this;
        tables.transmit = transmit_;
        tables.transmit_states = transmit_states_;
        tables.receive = receive_;
        tables.receive_monitors = monitors_;
        slave_.configure(tables);
    }

    void boot_up() {
        slave_.boot_up();
        guarded_.boot_up();
        emergencies_.clear();
    }
    void fail(std::uint16_t code) {
        emergencies_.report({code, 1, {}});
        history_.add(code, 0);
    }
    void set(std::uint8_t value) {
        table_.values[first_word] = value;
        table_.values[first_word + 2U] = value;
        schedule_.event(0);
    }
    std::uint8_t received(std::size_t pdo) const { return table_.values[first_word + 4 + 2 * pdo]; }

    void receive(const frame::Frame& frame, Time now) {
        now_ = now;
        if (guarded_.receive(frame, now) || schedule_.remote_request(frame)) {
            return;
        }
        const NmtState before = slave_.state();
        if (before == NmtState::operational) {
            const SyncConsumer::Sync sync = sync_.receive(frame);
            if (sync.kind == SyncConsumer::Sync::Kind::sync) {
                synchronous_receiver_.sync();
                schedule_.sync(sync.counter);
            }
            synchronous_receiver_.receive(frame);
        }
        const Slave::Event event = slave_.receive(frame, now);
        if (event.kind == Slave::Event::Kind::reset) {
            boot_up();
        }
        if (slave_.state() == NmtState::operational && before != NmtState::operational) {
            schedule_.start(now);
        } else if (slave_.state() != NmtState::operational && before == NmtState::operational) {
            schedule_.stop();
            synchronous_receiver_.cancel();
        }
    }

    Time poll(Time now) {
        now_ = now;
        const bool operational = slave_.state() == NmtState::operational;
        if (operational) {
            schedule_.request_due(now, slave_.transmitter());
        }
        Time next = slave_.poll(now);
        if (slave_.pending()) {
            return next;  // what the port refuses the slave it refuses the others too
        }
        guarded_.send_due(slave_.state(), *port_);
        if (slave_.state() != NmtState::stopped) {
            next = std::min(next, emergencies_.poll(now, *port_));
        }
        if (operational) {
            schedule_.send_samples(*port_);
            next = std::min(next, schedule_.note_sent(now, slave_.transmitter()));
        }
        return std::min(next, guarded_.poll(now));
    }

    AbortCode read(const object::ObjectEntry& entry, std::uint32_t& value) override {
        return entry.handler == history_objects ? history_.read(entry.sub_index, value) : AbortCode::none;
    }
    AbortCode write(const object::ObjectEntry& entry, std::uint32_t value) override {
        if (entry.handler == history_objects) {
            return history_.write(entry.sub_index, value);
        }
        if (value > 5000) {
            return AbortCode::value_too_high;
        }
        slave_.set_heartbeat_period(value * 1000, now_);
        return AbortCode::none;
    }

  private:
    static constexpr std::uint8_t history_objects = 1;
    static constexpr std::uint8_t heartbeat_time = 2;
    static constexpr std::size_t first_word = 1 + 4 + 2;

    frame::FramePort* port_;
    Time now_ = 0;
    test::Table table_;
    std::array<MappedValue, 4> mapping_;
    std::array<PdoRow, 2> transmit_;
    std::array<PdoRow, 1> synchronous_;
    std::array<PdoRow, 1> receive_;
    std::array<PdoTiming, 2> timings_{{{.inhibit = 1000}, {.type = 2}}};
    std::array<PdoScheduleState, 2> schedule_states_;
    std::array<TransmitState, 2> transmit_states_;
    std::array<SynchronousReceiver::Waiting, 1> waiting_;
    std::array<ArrivalMonitor, 1> monitors_;
    std::array<std::uint32_t, 4> errors_{};
    Slave slave_;
    PdoSchedule schedule_;
    SynchronousReceiver synchronous_receiver_;
    SyncConsumer sync_{0x80};
    GuardedNode guarded_{5, 100'000, 3};
    EmergencyProducer emergencies_{0x085, 500};
    ErrorHistory history_{errors_};
};

class ComposedDevice : public testing::Test {
  protected:
    using Frames = std::vector<frame::Frame>;

    Frames hear(const frame::Frame& frame, Time now) {
        device_.receive(frame, now);
        return poll(now);
    }
    Frames poll(Time now) {
        next_ = device_.poll(now);
        return port_.take();
    }
    Frames start(Time now = 0) {
        device_.boot_up();
        poll(now);
        return hear(nmt_frame(NmtCommand::start, 5), now);
    }
    static frame::Frame guard() {
        frame::Frame frame = make_frame(0x705, {0});
        frame.remote = true;
        return frame;
    }

    test::RecordingPort port_;
    Device device_{port_};
    Time next_ = 0;
};

TEST_F(ComposedDevice, sends_its_event_driven_pdo_on_entry_and_on_change) {
    EXPECT_EQ(start(), (Frames{make_frame(0x185, {0, 0})}));
    device_.set(7);
    EXPECT_TRUE(poll(400).empty());
    EXPECT_EQ(next_, 1000U);
    EXPECT_EQ(poll(1000), (Frames{make_frame(0x185, {7, 0})}));
}

TEST_F(ComposedDevice, exchanges_synchronous_pdos_at_sync) {
    start();
    EXPECT_TRUE(hear(make_frame(0x205, {9, 0}), 10).empty());
    EXPECT_EQ(device_.received(0), 0);
    hear(make_frame(0x305, {8, 0}), 20);
    EXPECT_EQ(device_.received(1), 8);
    EXPECT_TRUE(hear(make_frame(0x80, {}), 30).empty());
    EXPECT_EQ(device_.received(0), 9);
    EXPECT_EQ(hear(make_frame(0x80, {}), 40), (Frames{make_frame(0x285, {0, 0})}));
}

TEST_F(ComposedDevice, exchanges_no_pdo_outside_operational) {
    start();
    hear(make_frame(0x205, {9, 0}), 10);
    hear(nmt_frame(NmtCommand::enter_pre_operational, 5), 20);
    hear(make_frame(0x305, {8, 0}), 30);
    device_.set(7);
    EXPECT_TRUE(hear(make_frame(0x80, {}), 40).empty());
    EXPECT_TRUE(hear(make_frame(0x80, {}), 5000).empty());
    EXPECT_EQ(device_.received(0), 0);
    EXPECT_EQ(device_.received(1), 0);
}

TEST_F(ComposedDevice, answers_guarding_in_every_state) {
    start();
    EXPECT_EQ(hear(guard(), 10), (Frames{make_frame(0x705, {0x05})}));
    hear(nmt_frame(NmtCommand::stop, 5), 20);
    EXPECT_EQ(hear(guard(), 30), (Frames{make_frame(0x705, {0x84})}));
    EXPECT_EQ(hear(nmt_frame(NmtCommand::reset_node, 5), 40), (Frames{make_frame(0x705, {0x00})}));
    EXPECT_EQ(hear(guard(), 50), (Frames{make_frame(0x705, {0x7F})}));
}

TEST_F(ComposedDevice, reports_errors_at_most_once_in_the_inhibit_time_and_never_in_stopped) {
    start();
    device_.fail(0x1001);
    device_.fail(0x1002);
    EXPECT_EQ(poll(2000).size(), 1U);
    EXPECT_EQ(next_, 2500U);
    hear(nmt_frame(NmtCommand::stop, 5), 2100);
    EXPECT_TRUE(poll(3000).empty());
    EXPECT_EQ(hear(nmt_frame(NmtCommand::enter_pre_operational, 5), 3100),
              (Frames{make_frame(0x085, {0x02, 0x10, 1, 0, 0, 0, 0, 0})}));
}

TEST_F(ComposedDevice, shows_and_clears_its_error_history) {
    start();
    EXPECT_EQ(sdo::payload(hear(make_frame(0x605, {0x40, 0x03, 0x10, 1, 0, 0, 0, 0}), 1).front()),
              0x08000024U);
    device_.fail(0x1001);
    poll(1);
    EXPECT_EQ(sdo::payload(hear(make_frame(0x605, {0x40, 0x03, 0x10, 1, 0, 0, 0, 0}), 2).front()), 0x1001U);
    EXPECT_EQ(sdo::payload(hear(make_frame(0x605, {0x2F, 0x03, 0x10, 0, 3, 0, 0, 0}), 3).front()),
              0x06090030U);
    EXPECT_EQ(hear(make_frame(0x605, {0x2F, 0x03, 0x10, 0, 0, 0, 0, 0}), 4).front().data[0], 0x60);
    EXPECT_EQ(sdo::payload(hear(make_frame(0x605, {0x40, 0x03, 0x10, 0, 0, 0, 0, 0}), 5).front()), 0U);
}

TEST_F(ComposedDevice, obeys_a_write_of_its_heartbeat_time) {
    start();
    EXPECT_EQ(sdo::payload(hear(make_frame(0x605, {0x2B, 0x17, 0x10, 0, 0xFF, 0xFF, 0, 0}), 1).front()),
              0x06090031U);
    EXPECT_EQ(hear(make_frame(0x605, {0x2B, 0x17, 0x10, 0, 20, 0, 0, 0}), 1000).front().data[0], 0x60);
    EXPECT_EQ(next_, 21'000U);
    EXPECT_EQ(poll(21'000), (Frames{make_frame(0x705, {0x05})}));
}

TEST_F(ComposedDevice, loses_nothing_behind_a_port_that_is_full) {
    start();
    port_.room = 0;
    device_.set(7);
    device_.fail(0x1001);
    hear(guard(), 2000);
    hear(make_frame(0x605, {0x40, 0x17, 0x10, 0, 0, 0, 0, 0}), 2000);
    hear(make_frame(0x80, {}), 2000);
    hear(make_frame(0x80, {}), 2000);
    Frames sent;
    for (Time now = 3000; now < 12'000; now += 1000) {
        port_.room = 1;
        const Frames one = poll(now);
        sent.insert(sent.end(), one.begin(), one.end());
    }
    std::vector<std::uint32_t> ids;
    for (const frame::Frame& frame : sent) {
        ids.push_back(frame.id);
    }
    std::sort(ids.begin(), ids.end());
    EXPECT_EQ(ids, (std::vector<std::uint32_t>{0x085, 0x185, 0x285, 0x585, 0x705}));
}

}  // namespace
}  // namespace cgw::canopen
