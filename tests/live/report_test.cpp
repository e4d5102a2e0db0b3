#include <algorithm>

#include "base/json.hpp"
#include "canopen/nmt.hpp"
#include "live_test.hpp"
#include "support/golden.hpp"

namespace cgw::live {
namespace {

using test::answers;
using test::expect_golden;
using test::small_plant;

class Reports : public test::LiveTest {
  protected:
    bool says(const std::string& words,
              const Connection& connection = {.up = true, .reason = "", .lost = 0}) const {
        std::istringstream shown(text(connection));
        std::string one_line;
        for (std::string word; shown >> word;) {
            one_line += word + " ";
        }
        return one_line.find(words) != std::string::npos;
    }
    void expect_80_columns() const {
        std::istringstream lines(text());
        for (std::string line; std::getline(lines, line);) {
            EXPECT_LE(line.size(), 80U) << line;
        }
    }
    // Nothing is answered; `heard` still comes.
    void silent(const std::function<bool(const frame::Frame&)>& heard) {
        connect(small_plant(), small_plant());
        lie = [heard](frame::Frame& frame) { return heard(frame); };
        finish();
        expect_80_columns();
    }
};

TEST_F(Reports, say_that_the_device_has_the_configuration) {
    verify(small_plant(), small_plant());
    expect_golden("live/same.txt", text());
    expect_80_columns();
}

TEST_F(Reports, say_nothing_of_writes_that_were_left_out) {
    verify(small_plant(), small_plant(), {.write = false});
    EXPECT_FALSE(says("writes"));
    EXPECT_FALSE(says("rww"));
}

TEST_F(Reports, show_values_with_their_meaning_and_where_they_come_from) {
    const std::string other =
        small_plant("14402 = 1", "428 = 3\n430 = 500").replace(small_plant().find("16461"), 5, "16462");
    verify(small_plant(), other);
    expect_golden("live/other_configuration.txt", text());
    expect_golden(
        "live/other_configuration.json",
        base::pretty_json(render_json(subject(), *verification_, {.up = true, .reason = "", .lost = 0})));
    expect_80_columns();
}

TEST_F(Reports, put_every_kind_of_difference_into_words) {
    connect(small_plant(), small_plant());
    lie = [](frame::Frame& frame) {
        const bool refused = frame.data[0] == 0x80;
        if (!refused && answers(frame, 0x1400, 0)) {
            frame.data[0] = 0x43;
        } else if (!refused && answers(frame, 0x1400, 3)) {
            frame = canopen::sdo::make_frame(frame.id, 0x80, {0x1400, 3}, 0x06090011);
        } else if (!refused && answers(frame, 0x1400, 4)) {
            frame = canopen::sdo::make_frame(frame.id, 0x80, {0x1400, 4}, 0x08000000);
        } else if (refused && answers(frame, 0x1400, 5)) {
            frame = canopen::sdo::make_frame(frame.id, 0x60, {0x1400, 5}, 0);
        } else if (refused && answers(frame, 0x1401, 0)) {
            frame = canopen::sdo::make_frame(frame.id, 0x80, {0x1401, 0}, 0x08000000);
        } else if (answers(frame, 0x1402, 0)) {
            return false;
        } else if (!refused && answers(frame, 0x1403, 0)) {
            frame.data[0] = 0x41;
        } else if (answers(frame, 0x1005, 0)) {
            frame = canopen::sdo::make_frame(frame.id, 0x43, {0x1005, 0}, 0x80);
        }
        return true;
    };
    finish();
    expect_golden("live/every_kind.txt", text());
    expect_80_columns();
}

TEST_F(Reports, show_some_of_many_differences) {
    connect(small_plant(), small_plant());
    lie = [](frame::Frame& frame) {
        if (frame.data[0] != 0x80 && frame.id == 0x58C && frame.data[2] >= 0x14 && frame.data[2] < 0x20) {
            frame.data[4] ^= 0x40U;
        }
        return true;
    };
    finish();
    EXPECT_TRUE(says("more differences, all of which are in --format json"));
}

TEST_F(Reports, say_that_it_is_another_device) {
    connect(small_plant(), small_plant());
    lie = [](frame::Frame& frame) {
        if (answers(frame, 0x1000, 0)) {
            frame.data[4] = 0x92;
            frame.data[5] = 0x01;
        }
        return true;
    };
    finish();
    EXPECT_TRUE(says("this is another kind of device: nothing else was asked"));
    EXPECT_TRUE(says("1000h Device Type: 0x00000000 in the file, 0x00000192 in the device"));
    EXPECT_FALSE(says("as expected"));
}

TEST_F(Reports, say_what_to_look_at_on_a_dead_bus) {
    silent([](const frame::Frame&) { return false; });
    expect_golden("live/dead_bus.txt", text());
}

TEST_F(Reports, say_what_to_look_at_when_only_others_are_heard) {
    simulation::MasterNode* other = nullptr;
    connect(small_plant(), small_plant());
    simulation::MasterNode node_3(plant_->can2(), node, second);
    other = &node_3;
    frame::Frame heartbeat = canopen::heartbeat_frame(3, canopen::NmtState::operational);
    other->produce(heartbeat, second / 2);
    lie = [](frame::Frame& frame) { return frame.id == 0x703; };
    finish();
    EXPECT_TRUE(says("node 12 was not heard"));
    EXPECT_TRUE(says("heartbeats came from 3: does the gateway have another node-ID (427)?"));
}

TEST_F(Reports, say_that_stopped_answers_nothing) {
    connect(small_plant(), small_plant());
    port_->send(canopen::nmt_frame(canopen::NmtCommand::stop, node));
    plant_->run_until(plant_->now() + 1000);
    finish();
    EXPECT_TRUE(says("node 12 is Stopped: in this state it answers nothing"));
    EXPECT_TRUE(says("let the master bring it to Pre-Operational (NMT 80 0C)"));
}

TEST_F(Reports, wonder_about_a_device_that_lives_and_does_not_answer) {
    silent([](const frame::Frame& frame) { return frame.id != 0x58C; });
    EXPECT_TRUE(says("heartbeats of node 12 came, but no answer to 60Ch"));
}

TEST_F(Reports, say_that_the_connection_is_gone) {
    const test::Built built(small_plant());
    class Stubborn final : public frame::FramePort {
      public:
        bool send(const frame::Frame&) override { return false; }
    } port;
    file_.emplace(small_plant());
    verification_.emplace(plan(built.dictionary(), node, {}), node, port, Pace{.unsendable = 1});
    verification_->poll(1);
    verification_->poll(2);
    EXPECT_TRUE(says("no connection: hub:127.0.0.1:29536: nobody listens there",
                     {.up = false, .reason = "hub:127.0.0.1:29536: nobody listens there", .lost = 0}));
    EXPECT_TRUE(says("takes no frames", {.up = true, .reason = "", .lost = 0}));
    EXPECT_TRUE(
        says("look at bit rate (250 kbit/s (426)), wiring and power", {.up = true, .reason = "", .lost = 0}));
}

TEST_F(Reports, say_how_far_it_came_when_interrupted) {
    connect(small_plant(), small_plant());
    plant_->run_until(plant_->now() + second / 2);
    verification_->interrupt();
    EXPECT_TRUE(says(fmt::format("interrupted after {} of {} questions", verification_->result().asked,
                                 verification_->plan().size())));
    EXPECT_FALSE(says("The device has the configuration"));
}

TEST_F(Reports, mention_another_client) {
    connect(small_plant(), small_plant());
    simulation::MasterNode other(plant_->can2(), node, second);
    other.master().sdo().upload({0x1000, 0});
    finish();
    EXPECT_TRUE(says("Somebody else also asks node 12 by SDO"));
}

}  // namespace
}  // namespace cgw::live
