// Whatever stands in a file, reading, binding and running it never fails otherwise than with findings.
#include <random>

#include "scenario/stage.hpp"
#include "support/golden.hpp"

namespace cgw::scenario {
namespace {

void read_and_run(const std::string& text) {
    diagnostic::Findings findings;
    Scenario scenario = read_scenario(text, "t.toml", findings);
    bind(scenario, test::genset(), findings);
    if (!findings.has_errors()) {
        simulation::Installation installation(test::genset());
        scenario::Run run(installation, &scenario, 100'000, [](const Event&) {});
        run.advance(100'000);
    }
}

TEST(ScenarioMutations, of_samples_are_survived) {
    static const std::string pieces[] = {"\"",    "[",   "]",    "{",    "}",
                                         ",",     "=",   "\n",   "-1",   "nan",
                                         "1e99",  "0x0", "true", "[]",   "{}",
                                         "\"x\"", "at",  "9",    "step", "\xff",
                                         "\\",    "#",   "'",    "RPDO", "expect-error = 12413"};
    std::mt19937 random(4711);
    const auto below = [&random](std::size_t limit) { return static_cast<std::size_t>(random() % limit); };
    std::size_t sound = 0;
    for (const char* name : {"normal-start", "silent-plc", "saturated-bus"}) {
        const std::string original =
            test::read_text(std::string(CGW_SAMPLES) + "/scenarios/" + name + ".toml");
        ASSERT_FALSE(original.empty());
        for (int round = 0; round < 50; ++round) {
            std::string text = original;
            for (std::size_t i = 0; i <= below(3); ++i) {
                text.replace(below(text.size()), below(4), pieces[below(std::size(pieces))]);
            }
            diagnostic::Findings findings;
            read_scenario(text, "t.toml", findings);
            sound += findings.has_errors() ? 0U : 1U;
            read_and_run(text);
        }
    }
    EXPECT_GT(sound, 2U);  // some mutations only move a number: these run
}

TEST(ScenarioMutations, random_bytes_are_findings) {
    std::mt19937 random(815);
    for (int round = 0; round < 300; ++round) {
        std::string text(random() % 200, ' ');
        for (char& c : text) {
            c = static_cast<char>(random());
        }
        diagnostic::Findings findings;
        read_scenario(text, "t.toml", findings);
        EXPECT_TRUE(findings.has_errors());
    }
}

}  // namespace
}  // namespace cgw::scenario
