// docs/scenarios.md is what the table gives, and its example is a valid scenario.
#include "scenario/actions.hpp"
#include "scenario/stage.hpp"
#include "support/golden.hpp"

namespace cgw::scenario {
namespace {

TEST(ScenarioPage, is_up_to_date_in_docs) {
    test::expect_golden("../../docs/scenarios.md", page());
}

TEST(ScenarioPage, has_every_action_with_its_meaning) {
    const std::string text = page();
    for (const Action& action : actions()) {
        EXPECT_NE(text.find("| `" + std::string(action.key.name) + "` |"), std::string::npos);
        EXPECT_FALSE(action.key.text.empty()) << action.key.name;
        for (const Key& key : action.further) {
            EXPECT_FALSE(key.text.empty()) << action.key.name << ' ' << key.name;
        }
    }
}

TEST(ScenarioPage, shows_an_example_that_is_met) {
    const std::string text = page();
    const std::string fence = "```toml\n";
    const std::size_t begin = text.find(fence) + fence.size();
    driver::ScenarioFile file =
        driver::read_scenario_text("page.toml", text.substr(begin, text.find("```", begin) - begin));
    bind(file.scenario, test::genset(), file.findings);
    EXPECT_EQ(test::findings_text(file.findings), "");
    simulation::Installation installation(test::genset());
    scenario::Run run(installation, &file.scenario, file.scenario.duration, [](const Event&) {});
    run.advance(file.scenario.duration);
    EXPECT_EQ(run.count().steps, 5U);
    EXPECT_EQ(run.count().failed, 0U);
}

}  // namespace
}  // namespace cgw::scenario
