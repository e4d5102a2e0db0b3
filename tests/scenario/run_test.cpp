// Runs: counted steps, transfers that wait, refusals, and lines that fit.
#include <array>

#include "base/utf8.hpp"
#include "scenario/names.hpp"
#include "scenario/stage.hpp"

namespace cgw::scenario {
namespace {

TEST(ScenarioRun, counts_steps_and_expectations) {
    const test::Stage stage(
        "{ at = 1, reset = \"gateway\" },\n{ at = 1, expect-state = \"undefined\" },\n"
        "{ at = 2, expect-state = \"stopped\" },",
        "3");
    EXPECT_EQ(stage.run->count().steps, 3U);
    EXPECT_EQ(stage.run->count().expectations, 2U);
    EXPECT_EQ(stage.run->count().failed, 1U);
    EXPECT_TRUE(stage.run->over());
}

TEST(ScenarioRun, takes_steps_at_the_microsecond_and_in_order) {
    const test::Stage stage(
        "{ at = 1.000001, reset = \"gateway\" },\n{ at = 1.000001, expect-state = \"undefined\" },\n"
        "{ at = 1.2345675, expect-boot-ups = 2 },",
        "2");
    std::vector<Time> times;
    for (const Event& event : stage.events) {
        if (event.kind == EventKind::step || event.kind == EventKind::expected) {
            times.push_back(event.time);
        }
    }
    EXPECT_EQ(times, (std::vector<Time>{1'000'001, 1'000'001, 1'234'568}));
    EXPECT_EQ(stage.run->count().failed, 0U);
}

TEST(ScenarioRun, says_when_the_transfer_before_is_not_over) {
    const test::Stage stage("{ at = 1, upload = \"1000h\" },\n{ at = 1, write = \"1000h\", value = 1 },",
                            "2");
    EXPECT_EQ(stage.told(EventKind::step),
              "the PLC reads 1000h:0\nthe PLC writes 1000h:0: the transfer before it is not over\n");
    EXPECT_EQ(stage.told(EventKind::answer), "1000h:0: 0x00000000\n");
    EXPECT_EQ(stage.run->count().failed, 1U);
}

TEST(ScenarioRun, goes_no_further_than_it_is_told) {
    simulation::Installation installation(test::genset());
    scenario::Run run(installation, nullptr, canopen::never, [](const Event&) {});
    run.advance(1'234'567);
    EXPECT_EQ(installation.now(), 1'230'000U);  // whole quanta
    EXPECT_FALSE(run.over());
    EXPECT_EQ(run.steps(), 0U);
}

TEST(ScenarioRun, tells_why_a_governor_is_refused) {
    const test::Configuration other(CGW_SAMPLES "/minimal.toml");
    const test::Configuration gateway(CGW_SAMPLES "/manual-example.toml");
    simulation::Installation installation(gateway.image, other.image);
    std::string told;
    scenario::Run run(installation, nullptr, 2'000'000, [&told](const Event& event) {
        told += event.kind == EventKind::link ? event.text + "\n" : "";
    });
    run.advance(2'000'000);
    const std::string refused = "refused: 14401: 0 at the governor, 1 at the gateway\n";
    EXPECT_EQ(told, refused + refused + refused + "the governor gives up until errors are cleared\n");
}

TEST(ScenarioEvents, are_lines_of_at_most_80_columns) {
    EXPECT_EQ(line_of({2'500'000, EventKind::state, "Operational"}), "   2.500 s  state    Operational");
    EXPECT_EQ(line_of({0, EventKind::expected, "no error"}), "   0.000 s  ok       no error");
    EXPECT_EQ(line_of({0, EventKind::expected, "no error: 3005", true}),
              "   0.000 s  FAILED   no error: 3005");
    EXPECT_EQ(line_of({0, EventKind::step, "x", true}), "   0.000 s  FAILED   x");
    EXPECT_EQ(line_of({86'400'000'000, EventKind::boot_up, "node 12"}), "86400.000 s  boot-up  node 12");
    EXPECT_EQ(base::width_of(line_of({0, EventKind::step, std::string(200, 'x')})), 80U);
}

TEST(ScenarioEvents, have_a_word_each) {
    std::set<std::string_view> words;
    for (int kind = 0; kind <= static_cast<int>(EventKind::expected); ++kind) {
        words.insert(to_text(static_cast<EventKind>(kind)));
    }
    EXPECT_EQ(words.size(), 11U);
}

TEST(ScenarioErrors, have_the_names_of_the_catalogue) {
    EXPECT_EQ(error_text(12413), "12413 CanOpTimeCtrlErr");
    EXPECT_EQ(error_text(3007), "3007");
    EXPECT_EQ(error_by_name("errcanbus2"), 3072);
    EXPECT_EQ(error_by_name("CanOpenMyNodeID"), std::nullopt);
}

}  // namespace
}  // namespace cgw::scenario
