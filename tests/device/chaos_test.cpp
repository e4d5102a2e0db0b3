// Anything in any order at any time: what must hold all the same. Seeds are fixed, so that a failure comes
// again.
#include <random>

#include "device/gateway_test.hpp"

namespace cgw::device {
namespace {

using canopen::NmtCommand;
using Random = std::mt19937;

std::uint32_t below(Random& random, std::uint32_t limit) {
    return static_cast<std::uint32_t>(random()) % limit;
}

class GatewayChaos : public test::GatewayTest, public testing::WithParamInterface<unsigned> {
  protected:
    frame::Frame any_frame(Random& random) {
        // Identifiers that mean something to node 5, and any other.
        static constexpr std::uint32_t known[] = {0x000, 0x605, 0x205, 0x305, 0x405,
                                                  0x505, 0x77F, 0x585, 0x080};
        frame::Frame frame;
        frame.id = below(random, 8) == 0 ? below(random, 0x20000000) : known[below(random, std::size(known))];
        frame.length = static_cast<std::uint8_t>(below(random, 3) == 0 ? below(random, 9) : 8);
        frame.extended = frame.id > 0x7FF || below(random, 16) == 0;
        frame.remote = below(random, 16) == 0;
        for (std::uint8_t& byte : frame.data) {
            byte = static_cast<std::uint8_t>(below(random, 256));
        }
        if (frame.id == 0x605 && below(random, 2) == 0) {
            frame.data = {0x40, 0x05, 0x20, 0};  // 2005h
        }
        return frame;
    }

    void receive_nmt(Random& random) {
        static constexpr NmtCommand commands[] = {NmtCommand::start, NmtCommand::stop,
                                                  NmtCommand::enter_pre_operational, NmtCommand::reset_node,
                                                  NmtCommand::reset_communication};
        nmt(commands[below(random, 8) < 4 ? 0 : below(random, 5)],
            static_cast<std::uint8_t>(below(random, 3) * 5 / 2));  // all, another, ours
    }

    void act(Random& random) {
        now_ += below(random, 4) == 0 ? below(random, 200'000) : below(random, 20'000);
        switch (below(random, 10)) {
            case 0:
            case 1:
                gateway_.receive(any_frame(random), now_);
                break;
            case 2:
                receive_nmt(random);
                break;
            case 3:
                command(static_cast<GovernorCommand>(below(random, 8) == 0 ? 0 : 1 + below(random, 2)));
                break;
            case 4:
            case 5:
                for (std::uint16_t& word : data_.errors) {
                    word = static_cast<std::uint16_t>(below(random, 3) == 0 ? below(random, 0x10000) : word);
                }
                gateway_.main_cycle(data_, now_);
                break;
            case 6:
                if (below(random, 20) == 0) {
                    gateway_.report(static_cast<Fault>(below(random, fault_count)), true, now_);
                }
                break;
            case 7:
                gateway_.report(static_cast<Fault>(below(random, fault_count)), false, now_);
                break;
            case 8:
                port_.room = below(random, 3) == 0 ? below(random, 3) : test::RecordingPort::unlimited;
                break;
            default:
                gateway_.poll(now_);
                break;
        }
    }

    // A reset, also of what only a reset clears.
    void reset_sometimes(Random& random) {
        if (below(random, 64) == 0) {
            gateway_.clear_errors(now_);
        }
        if (below(random, 256) == 0) {
            EXPECT_EQ(open(), OpenStatus::ok);
        }
    }

    void expect_sane(const frame::Frame& frame) const {
        const GatewayState state = gateway_.state();
        EXPECT_NE(state, GatewayState::undefined);
        EXPECT_NE(state, GatewayState::init);
        if (frame.id == 0x585) {
            EXPECT_NE(state, GatewayState::stopped);
            EXPECT_EQ(frame.length, 8);
        } else if (frame.id == 0x705) {
            ASSERT_EQ(frame.length, 1);
            EXPECT_TRUE(frame.data[0] == 0x00 || frame.data[0] == 0x04 || frame.data[0] == 0x05 ||
                        frame.data[0] == 0x7F);
        } else {
            EXPECT_TRUE(frame.id == 0x185 || frame.id == 0x285 || frame.id == 0x485 || frame.id == 0x282)
                << frame.id;
            EXPECT_EQ(state, GatewayState::operational);
        }
        EXPECT_FALSE(frame.extended);
        EXPECT_FALSE(frame.remote);
    }

    void expect_consistent() const {
        const GatewayErrors& errors = gateway_.errors();
        EXPECT_EQ(gateway_.status(), link_.status);
        EXPECT_EQ(gateway_.status().canopen_errors, errors.canopen_errors());
        EXPECT_EQ(gateway_.status().errors, errors.words());
        if (errors.blocking()) {
            EXPECT_EQ(gateway_.state(), GatewayState::undefined);
        }
        if (gateway_.state() == GatewayState::operational) {
            EXPECT_FALSE(errors.present(Fault::can2_bus));
        } else {
            EXPECT_EQ(gateway_.status().late_rpdos, 0);
            EXPECT_FALSE(gateway_.status().heartbeat_lost);
        }
        if (gateway_.state() == GatewayState::undefined || gateway_.state() == GatewayState::init) {
            EXPECT_FALSE(gateway_.pending());
        }
    }
};

TEST_P(GatewayChaos, breaks_no_rule) {
    plant_.configuration.heartbeat_consumer = {100, 6, 96'000};
    plant_.rpdo(2).time = {100, 6, 93'750};
    ASSERT_EQ(open(), OpenStatus::ok);
    Random random(GetParam());
    unsigned operational = 0;
    for (int step = 0; step < 20'000 && !HasFailure(); ++step) {
        act(random);
        for (const frame::Frame& frame : port_.take()) {
            expect_sane(frame);
        }
        expect_consistent();
        reset_sometimes(random);
        operational += gateway_.state() == GatewayState::operational ? 1U : 0U;
    }
    EXPECT_GT(operational, 200U);  // it got somewhere
    // And nothing is stuck: a reset, and it runs again.
    ASSERT_EQ(open(), OpenStatus::ok);
    port_.room = test::RecordingPort::unlimited;
    command(GovernorCommand::init);
    command(GovernorCommand::pre_operational);
    nmt(NmtCommand::start);
    EXPECT_EQ(gateway_.state(), GatewayState::operational);
    gateway_.poll(now_);
    EXPECT_FALSE(gateway_.pending());
}

INSTANTIATE_TEST_SUITE_P(Seeds, GatewayChaos, testing::Range(1U, 9U));

}  // namespace
}  // namespace cgw::device
