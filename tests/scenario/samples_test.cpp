// The scenarios in samples/scenarios: all their expectations are met, and they give the same frames and
// events every time, however the time is cut.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/files.hpp"
#include "base/sha256.hpp"
#include "media/log.hpp"
#include "scenario/stage.hpp"
#include "support/golden.hpp"

namespace cgw::scenario {
namespace {

std::vector<std::string> names() {
    std::vector<std::string> all;
    for (const auto& entry : std::filesystem::directory_iterator(CGW_SAMPLES "/scenarios")) {
        all.push_back(entry.path().stem().string());
    }
    std::sort(all.begin(), all.end());
    return all;
}

struct Told {
    std::string events;
    std::string log;  // candump
    std::size_t failed = 0;
    std::size_t expectations = 0;
};

class ScenarioSamples : public testing::TestWithParam<std::string> {
  protected:
    ScenarioSamples()
        : path_(std::string(CGW_SAMPLES) + "/scenarios/" + GetParam() + ".toml"),
          file_(driver::read_scenario_file(path_)),
          plant_(base::beside(path_, file_.scenario.plant)),
          governor_(base::beside(
              path_, file_.scenario.governor.empty() ? file_.scenario.plant : file_.scenario.governor)) {
        bind(file_.scenario, plant_.image, file_.findings);
        EXPECT_EQ(test::findings_text(file_.findings), "");
    }

    Told told(Time slice) {
        Told result;
        std::vector<media::LoggedFrame> frames;
        simulation::Installation installation(plant_.image, governor_.image);
        for (const char* name : {"can1", "can2"}) {
            const bool first = std::string(name) == "can1";
            (first ? installation.plant().can1() : installation.plant().can2())
                .observe([&frames, name](const frame::Frame& frame, Time now) {
                    frames.push_back({now, name, frame});
                });
        }
        const Time end = file_.scenario.duration;
        scenario::Run run(installation, &file_.scenario, end,
                          [&result](const Event& event) { result.events += line_of(event) + "\n"; });
        for (Time time = slice; !run.over(); time += slice) {
            run.advance(std::min(time, end));
        }
        const base::Bytes log = media::write_log(media::LogFormat::candump, frames).value();
        result.log.assign(log.begin(), log.end());
        result.failed = run.count().failed;
        result.expectations = run.count().expectations;
        return result;
    }

    std::string path_;
    driver::ScenarioFile file_;
    test::Configuration plant_;
    test::Configuration governor_;
};

TEST_P(ScenarioSamples, meet_their_expectations_and_give_the_same_log_every_time) {
    const Told whole = told(file_.scenario.duration);
    EXPECT_EQ(whole.failed, 0U) << whole.events;
    EXPECT_GE(whole.expectations, 5U);
    const Told cut = told(7'301);
    EXPECT_EQ(cut.events, whole.events);
    EXPECT_TRUE(cut.log == whole.log);
    const auto frames = std::count(whole.log.begin(), whole.log.end(), '\n');
    const auto digest =
        base::sha256(std::span(reinterpret_cast<const std::uint8_t*>(whole.log.data()), whole.log.size()));
    test::expect_golden("golden/scenarios/" + GetParam() + ".txt",
                        fmt::format("{}{} frames, {}\n", whole.events, frames, base::to_hex(digest)));
}

INSTANTIATE_TEST_SUITE_P(All, ScenarioSamples, testing::ValuesIn(names()), [](const auto& test) {
    std::string name = test.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

TEST(ScenarioSampleFiles, are_there) {
    EXPECT_GE(names().size(), 7U);
}

}  // namespace
}  // namespace cgw::scenario
