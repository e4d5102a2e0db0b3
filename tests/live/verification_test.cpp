#include "live_test.hpp"

#include <set>

#include "canopen/nmt.hpp"

namespace cgw::live {
namespace {

using canopen::NmtCommand;
using test::answers;
using test::small_plant;
using Lines = std::vector<std::string>;

using Verifying = test::LiveTest;

TEST_F(Verifying, finds_nothing_where_the_device_has_the_configuration) {
    const Result& result = verify(small_plant(), small_plant());
    EXPECT_EQ(differences(), Lines{});
    EXPECT_EQ(result.ending, Ending::complete);
    EXPECT_TRUE(result.same());
    EXPECT_EQ(result.asked, verification_->plan().size());
}

TEST_F(Verifying, finds_nothing_in_operational_either) {
    connect(small_plant(), small_plant());
    plant_->can2().attach_clock(*this);
    port_->send(canopen::nmt_frame(NmtCommand::start, node));
    EXPECT_TRUE(finish().same());
    EXPECT_EQ(plant_->gateway().state(), device::GatewayState::operational);
}

TEST_F(Verifying, asks_one_thing_at_a_time_and_sends_nothing_but_requests) {
    verify(small_plant(), small_plant());
    bool waiting = false;
    for (const frame::Frame& frame : bus_) {
        if (frame.id == 0x600U + node) {
            EXPECT_FALSE(waiting);
            waiting = true;
        } else if (frame.id == 0x580U + node) {
            waiting = false;
        } else {
            EXPECT_TRUE(frame.id == 0x700U + node || frame.id < 0x580U) << frame.id;
            EXPECT_NE(frame.id, 0U);  // NMT
        }
    }
}

TEST_F(Verifying, changes_nothing_in_the_device) {
    connect(small_plant(), small_plant());
    const std::vector<std::uint8_t> before(plant_->gateway().values().begin(),
                                           plant_->gateway().values().end());
    plant_->run_until(plant_->now());
    finish();
    const object::ObjectTable objects = device_->image.objects();
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const object::ObjectEntry entry = objects.entry(i);
        if (entry.index < 0x2000 && entry.index != 0x1001) {
            EXPECT_EQ(object::load_value(plant_->gateway().values(), entry),
                      object::load_value(before, entry));
        }
    }
}

TEST_F(Verifying, leaves_writes_out_when_told_so) {
    verify(small_plant(), small_plant(), {.write = false});
    EXPECT_TRUE(verification_->result().same());
    for (const frame::Frame& frame : bus_) {
        if (frame.id == 0x600U + node) {
            EXPECT_EQ(frame.data[0], 0x40);
        }
    }
}

TEST_F(Verifying, finds_another_identifier) {
    verify(small_plant(), small_plant("", "").replace(small_plant().find("0x282"), 5, "0x283"));
    EXPECT_EQ(differences(), (Lines{"1804h:1 value"}));
    EXPECT_EQ(verification_->result().differences[0].value, 0x283U);
}

TEST_F(Verifying, finds_a_pdo_that_the_device_has_not) {
    const std::string more = small_plant("16408 = [2031]\n16462 = 100", "16405 = 0x290");
    verify(more, small_plant());
    EXPECT_EQ(differences(), (Lines{"1805h:1 value", "1805h:5 value", "1A05h:0 value", "1A05h:1 value",
                                    "2001h:0 value", "2001h:3 missing"}));
}

TEST_F(Verifying, finds_an_object_that_the_file_has_not) {
    const std::string more = small_plant("16408 = [2031]\n16462 = 100", "16405 = 0x290");
    verify(small_plant(), more);
    EXPECT_EQ(differences().back(), "2001h:3 unexpected");
}

TEST_F(Verifying, compares_the_identity_only_where_the_file_states_it) {
    const std::string identity =
        "[gateway]\nidentity = { software_version = 3, serial_date = 407, serial_number = 12 }\n";
    const std::string stated = small_plant() + identity;
    verify(small_plant(), stated);
    EXPECT_TRUE(verification_->result().same());
    verification_.reset();
    verify(stated, small_plant());
    EXPECT_EQ(differences(), (Lines{"1018h:3 value", "1018h:4 value"}));
}

TEST_F(Verifying, asks_another_device_nothing_else) {
    connect(small_plant(), small_plant());
    lie = [](frame::Frame& frame) {
        if (answers(frame, 0x1018, 1)) {
            frame.data[4] = 0x62;
        }
        return true;
    };
    EXPECT_EQ(finish().ending, Ending::other_device);
    EXPECT_EQ(verification_->result().asked, 2U);
    EXPECT_FALSE(verification_->result().same());
}

TEST_F(Verifying, finds_values_lengths_and_objects_that_are_wrong) {
    connect(small_plant(), small_plant());
    lie = [](frame::Frame& frame) {
        if (frame.data[0] != 0x80 && answers(frame, 0x1017, 0)) {
            frame.data[4] ^= 1U;
        } else if (frame.data[0] != 0x80 && answers(frame, 0x2000, 3)) {
            frame.data[0] = 0x43;
        } else if (frame.data[0] != 0x80 && answers(frame, 0x2005, 0)) {
            frame = canopen::sdo::make_frame(frame.id, 0x80, {0x2005, 0}, 0x06020000);
        } else if (frame.data[0] != 0x80 && answers(frame, 0x1200, 1)) {
            frame.data[0] = 0x41;  // segments to follow
        }
        return true;
    };
    EXPECT_EQ(finish().ending, Ending::complete);
    EXPECT_EQ(differences(), (Lines{"1017h value", "1200h:1 garbled", "2000h:3 length", "2005h missing"}));
}

TEST_F(Verifying, finds_objects_that_can_be_written_or_refuse_otherwise) {
    connect(small_plant(), small_plant());
    lie = [](frame::Frame& frame) {
        if (frame.data[0] == 0x80 && answers(frame, 0x1400, 1)) {
            frame = canopen::sdo::make_frame(frame.id, 0x60, {0x1400, 1}, 0);
        } else if (frame.data[0] == 0x80 && answers(frame, 0x1400, 2)) {
            frame = canopen::sdo::make_frame(frame.id, 0x80, {0x1400, 2}, 0x08000000);
        }
        return true;
    };
    finish();
    EXPECT_EQ(differences(), (Lines{"1400h:1 writable", "1400h:2 refused"}));
}

TEST_F(Verifying, finds_what_should_not_be_there) {
    connect(small_plant(), small_plant());
    lie = [](frame::Frame& frame) {
        if (answers(frame, 0x1010, 0)) {
            frame = canopen::sdo::make_frame(frame.id, 0x4F, {0x1010, 0}, 1);
        } else if (answers(frame, 0x1018, 5)) {
            frame = canopen::sdo::make_frame(frame.id, 0x80, {0x1018, 5}, 0x06020000);
        }
        return true;
    };
    finish();
    EXPECT_EQ(differences(), (Lines{"1018h:5 refused", "1010h unexpected"}));
}

TEST_F(Verifying, asks_again_when_an_answer_is_lost) {
    connect(small_plant(), small_plant());
    std::set<std::pair<std::uint16_t, std::uint8_t>> lost;
    lie = [&lost](frame::Frame& frame) {
        const canopen::sdo::Multiplexer object = canopen::sdo::multiplexer(frame);
        return frame.id != 0x58C || object.index != 0x1802 ||
               !lost.insert({object.index, object.sub_index}).second;
    };
    EXPECT_TRUE(finish().same());
    EXPECT_EQ(lost.size(), 7U);  // six entries, and the one beyond
}

TEST_F(Verifying, takes_no_answer_about_another_object) {
    connect(small_plant(), small_plant());
    lie = [](frame::Frame& frame) {
        if (answers(frame, 0x1802, 1)) {
            frame.data[3] = 2;
        }
        return true;
    };
    EXPECT_EQ(finish().ending, Ending::complete);
    EXPECT_EQ(differences(), (Lines{"1802h:1 silent"}));
}

TEST_F(Verifying, takes_an_answer_that_comes_late) {
    connect(small_plant(), small_plant(), {}, {.timeout = 100'000});
    std::vector<frame::Frame> late;
    lie = [&late](frame::Frame& frame) {
        if (answers(frame, 0x1802, 1) && late.size() < 2) {  // to both attempts, and the second one is heard
            late.push_back(frame);
            return late.size() == 2;
        }
        return true;
    };
    EXPECT_TRUE(finish().same());
}

TEST_F(Verifying, ends_when_nobody_answers) {
    connect(small_plant(), small_plant());
    lie = [](frame::Frame& frame) { return frame.id != 0x58C; };
    EXPECT_EQ(finish().ending, Ending::silent);
    EXPECT_EQ(verification_->result().answers, 0U);
    EXPECT_EQ(differences(), Lines{});
    EXPECT_EQ(verification_->result().heard.state, canopen::NmtState::pre_operational);
}

TEST_F(Verifying, ends_when_the_device_falls_silent_on_the_way) {
    connect(small_plant(), small_plant());
    plant_->run_until(plant_->now() + second / 2);
    EXPECT_GT(verification_->result().asked, 20U);
    port_->send(canopen::nmt_frame(NmtCommand::stop, node));
    EXPECT_EQ(finish().ending, Ending::silent);
    EXPECT_EQ(differences(), Lines{});
    EXPECT_EQ(verification_->result().heard.state, canopen::NmtState::stopped);
}

// A port that stops taking frames.
class Stubborn final : public frame::FramePort {
  public:
    bool send(const frame::Frame&) override { return false; }
};

TEST(Verification, ends_when_the_bus_takes_no_frames) {
    const test::Built built(small_plant());
    Stubborn port;
    Verification verification(plan(built.dictionary(), 12, {}), 12, port, {.unsendable = 1000});
    EXPECT_EQ(verification.poll(500), 1500U);
    EXPECT_TRUE(verification.pending());
    verification.poll(1499);
    EXPECT_FALSE(verification.over());
    verification.poll(1500);
    EXPECT_EQ(verification.result().ending, Ending::unsendable);
}

TEST_F(Verifying, hears_other_nodes_and_other_clients) {
    connect(small_plant(), small_plant());
    simulation::MasterNode other(plant_->can2(), node, second);
    other.master().send_process_data(0x703, std::array<std::uint8_t, 1>{0x05});
    other.master().sdo().upload({0x1000, 0});
    finish();
    EXPECT_TRUE(verification_->result().heard.others.test(3));
    EXPECT_TRUE(verification_->result().heard.other_client);
    EXPECT_GT(verification_->result().heard.frames, 100U);
}

TEST_F(Verifying, can_be_interrupted) {
    connect(small_plant(), small_plant());
    plant_->run_until(plant_->now() + second / 2);
    verification_->interrupt();
    EXPECT_EQ(verification_->result().ending, Ending::interrupted);
    EXPECT_EQ(verification_->poll(plant_->now()), canopen::never);
}

}  // namespace
}  // namespace cgw::live
