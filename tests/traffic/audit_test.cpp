// Logs against the genset: one thing wrong at a time.
#include <gtest/gtest.h>

#include <algorithm>

#include "genset.hpp"

namespace cgw::traffic {
namespace {

struct Event {
    std::uint64_t time_us = 0;
    frame::Frame frame;
};

// Everything the plant sends in `seconds`, from the command on, in order; frames of `without` never come.
std::vector<Event> traffic_of(std::uint64_t seconds, std::uint32_t without = 0xFFFF) {
    const Subject& subject = test::genset().subject;
    std::vector<Event> events{{0, test::make_frame(0, {1, 12})}};
    const auto add = [&](std::uint32_t id, std::uint8_t length, std::uint64_t first, std::uint64_t period) {
        frame::Frame frame;
        frame.id = id;
        frame.length = length;
        frame.data[0] = id >= 0x700 ? 0x05 : 0;
        for (std::uint64_t time = first; id != without && time < seconds * 1'000'000; time += period) {
            events.push_back({time, frame});
        }
    };
    for (const signals::Frame& frame : subject.frames) {
        add(frame.identifier, frame.length, 10'000,
            frame.period_us != 0       ? frame.period_us
            : frame.monitoring_us != 0 ? 250'000
                                       : 5'000'000);
    }
    add(0x70C, 1, 200'000, subject.heartbeat_period_us);
    add(0x701, 1, 100'000, 500'000);
    std::stable_sort(events.begin(), events.end(),
                     [](const Event& a, const Event& b) { return a.time_us < b.time_us; });
    return events;
}

std::vector<Event> between(std::vector<Event> events, std::uint32_t id, std::uint64_t from,
                           std::uint64_t to) {
    std::erase_if(events, [&](const Event& event) {
        return event.frame.id == id && event.time_us >= from && event.time_us < to;
    });
    return events;
}

std::vector<Event> with(std::vector<Event> events, std::uint64_t time_us, const frame::Frame& frame) {
    const auto at = std::find_if(events.begin(), events.end(),
                                 [time_us](const Event& event) { return event.time_us > time_us; });
    events.insert(at, {time_us, frame});
    return events;
}

// "E1217 RPDO1 (20Ch) stayed out …", one line each.
std::string found(const std::vector<Event>& events) {
    const Subject& subject = test::genset().subject;
    const Owners owners(subject);
    Audit audit(subject, owners);
    std::uint64_t number = 0;
    for (const Event& event : events) {
        audit.take({++number, event.time_us, true, event.frame});
    }
    audit.finish(true);
    std::string text;
    const diagnostic::Findings findings = audit.findings("run.log");
    for (const diagnostic::Diagnostic& finding : findings.all()) {
        text += std::string(finding.rule->code) + " " + finding.message + "\n";
    }
    return text;
}

}  // namespace

TEST(Audit, has_nothing_to_say_about_a_sound_plant) {
    EXPECT_EQ(found(traffic_of(20)), "");
}

TEST(Audit, misses_every_frame_that_never_comes) {
    for (const signals::Frame& frame : test::genset().subject.frames) {
        const std::string said = found(traffic_of(20, frame.identifier));
        EXPECT_TRUE(said.starts_with("E1212 " + frame.name) ||
                    (!frame.transmit() && said.starts_with("E1217 ")))
            << frame.name << ": " << said;
    }
    EXPECT_EQ(found(traffic_of(20, 0x70C)),
              "E1212 heartbeat of node 12 (70Ch) was never sent, though the log lasts 19885 ms\n");
}

TEST(Audit, finds_gaps_and_exceeded_monitoring) {
    EXPECT_EQ(found(between(traffic_of(20), 0x48C, 5'000'000, 5'300'000)),
              "E1216 TPDO4 (48Ch) stayed out for 500 ms, its period is 125 ms; once\n");
    EXPECT_EQ(found(between(traffic_of(20), 0x20C, 5'000'000, 6'000'000)),
              "E1217 RPDO1 (20Ch) stayed out for 1250 ms, and is missed after 500 ms; once\n");
    EXPECT_EQ(found(between(traffic_of(20), 0x701, 5'000'000, 8'000'000)),
              "E1217 heartbeat of node 1 (701h) stayed out for 3500 ms, and is missed after 2000 ms; once\n");
}

TEST(Audit, judges_the_end_of_the_log_as_well) {
    EXPECT_EQ(found(between(traffic_of(20), 0x20C, 19'000'000, 20'000'000)).substr(0, 20),
              "E1217 RPDO1 (20Ch) s");
}

TEST(Audit, finds_strangers_and_wrong_lengths) {
    EXPECT_EQ(found(with(traffic_of(20), 1'000'000, test::make_frame(0x285, {1}))),
              "E1214 285h is no frame of this plant, and was seen once; by default it is TPDO2 of node 5\n");
    EXPECT_EQ(found(with(traffic_of(20), 1'000'000, test::make_frame(0x123, {1}))),
              "E1214 123h is no frame of this plant, and was seen once; CiA 301 gives it to nobody\n");
    EXPECT_EQ(found(with(traffic_of(20), 1'000'000, test::make_frame(0x08C, {1}))),
              "E1214 08Ch is no frame of this plant, and was seen once; by default it is EMCY of node 12\n");
    EXPECT_EQ(found(with(traffic_of(20), 1'000'000, test::make_frame(0x08B, {1}))), "");
    EXPECT_EQ(found(with(traffic_of(20), 1'000'000, test::make_frame(0x18C, {1}))),
              "E1210 TPDO1 (18Ch) has 1 byte here and 8 in the plant, once in all\n");
    EXPECT_EQ(found(with(traffic_of(20), 1'000'000, test::make_frame(0x50C, {1, 2, 3}))),
              "E1211 RPDO4 (50Ch) has 3 bytes here and 2 in the plant, once in all\n");
}

TEST(Audit, tells_short_and_long_frames_apart) {
    const std::vector<Event> longer = with(traffic_of(20), 1'000'000, test::make_frame(0x50C, {1, 2, 3}));
    EXPECT_EQ(found(with(longer, 2'000'000, test::make_frame(0x50C, {1}))),
              "E1211 RPDO4 (50Ch) has 3 bytes here and 2 in the plant, once in all\n"
              "E1210 RPDO4 (50Ch) has 1 byte here and 2 in the plant, once in all\n");
}

// D28, D55: the gateway drops it and goes on waiting.
TEST(Audit, does_not_let_a_short_frame_feed_the_monitoring) {
    std::vector<Event> events = traffic_of(20);
    for (Event& event : events) {
        const bool shortened = event.time_us >= 5'000'000 && event.time_us < 6'000'000;
        event.frame.length = event.frame.id == 0x20C && shortened ? 1 : event.frame.length;
    }
    EXPECT_EQ(found(events),
              "E1210 RPDO1 (20Ch) has 1 byte here and 6 in the plant, 4 times in all\n"
              "E1217 RPDO1 (20Ch) stayed out for 1250 ms, and is missed after 500 ms; once\n");
}

TEST(Audit, tells_only_some_of_very_many_strangers) {
    std::vector<Event> events = traffic_of(20);
    for (std::uint32_t id = 0x680 + 2; id < 0x6DF; ++id) {
        events = with(std::move(events), 1'000'000, test::make_frame(id, {}));
    }
    const std::string said = found(events);
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 11);
    EXPECT_NE(said.find("more identifiers are none of this plant"), std::string::npos);
}

TEST(Audit, knows_when_the_gateway_may_send) {
    std::vector<Event> stopped = traffic_of(5);
    stopped.push_back({5'000'000, test::make_frame(0, {2, 12})});
    EXPECT_EQ(found(stopped), "");
    std::vector<Event> queued = stopped;
    queued.push_back({5'050'000, test::make_frame(0x48C, {0, 0, 0, 0, 0, 0, 0, 0})});
    EXPECT_EQ(found(queued), "");
    queued.push_back({5'200'000, test::make_frame(0x48C, {0, 0, 0, 0, 0, 0, 0, 0})});
    EXPECT_EQ(found(queued), "E1218 TPDO4 (48Ch) was sent once while the gateway was not Operational\n");
    std::vector<Event> others = stopped;  // a command to another node
    others.back().frame.data[1] = 11;
    others.push_back({5'050'000, test::make_frame(0x48C, {0, 0, 0, 0, 0, 0, 0, 0})});
    EXPECT_EQ(found(others), "");
}

TEST(Audit, begins_anew_where_time_runs_backwards) {
    std::vector<Event> events = traffic_of(20);
    for (const Event& event : traffic_of(20)) {
        events.push_back(event);
    }
    EXPECT_EQ(found(events), "E1208 time runs backwards here\n");
}

TEST(Audit, does_not_mind_times_at_the_end_of_all_numbers) {
    std::vector<Event> events = traffic_of(2);
    events.push_back({~std::uint64_t{0}, test::make_frame(0x48C, {0, 0, 0, 0, 0, 0, 0, 0})});
    events.push_back({0, test::make_frame(0x48C, {0, 0, 0, 0, 0, 0, 0, 0})});
    EXPECT_NE(found(events), "");
}

TEST(Audit, says_that_a_log_is_empty) {
    EXPECT_EQ(found({}), "E1209 there is no frame in this log\n");
}

}  // namespace cgw::traffic
