// samples/genset.toml in memory, and scenarios run on it.
#pragma once

#include <gtest/gtest.h>

#include "driver/scenario_file.hpp"
#include "scenario/run.hpp"

namespace cgw::test {

// A configuration that lives as long as the program.
struct Configuration {
    explicit Configuration(const std::string& path) : file(driver::check_file(path)) {
        EXPECT_TRUE(file.valid()) << path;
        bytes = driver::image_bytes(file).value();
        EXPECT_EQ(image::Image::open(bytes, image), image::Status::ok);
    }
    driver::CheckedFile file;
    base::Bytes bytes;
    image::Image image;
};

inline const image::Image& genset() {
    static const Configuration configuration(CGW_SAMPLES "/genset.toml");
    return configuration.image;
}

// "1:2: key-unknown: text (help)\n", sorted.
inline std::string findings_text(diagnostic::Findings& findings) {
    findings.sort();
    std::string text;
    for (const diagnostic::Diagnostic& finding : findings.all()) {
        text += std::to_string(finding.where.range.start.line) + ":" +
                std::to_string(finding.where.range.start.column) + ": " + std::string(finding.rule->name) +
                ": " + finding.message + (finding.help.empty() ? "" : " (" + finding.help + ")") + "\n";
    }
    return text;
}

// `steps` is what stands in the list, each at its time.
inline std::string scenario_text(const std::string& steps, const std::string& duration = "20") {
    return "format = 1\nduration = " + duration + "\nstep = [\n" + steps + "\n]\n";
}

// A scenario on the genset, run to its end.
struct Stage {
    explicit Stage(const std::string& steps, const std::string& duration = "20")
        : file(driver::read_scenario_text("test.toml", scenario_text(steps, duration))) {
        scenario::bind(file.scenario, genset(), file.findings);
        EXPECT_EQ(findings_text(file.findings), "") << steps;
        run.emplace(installation, &file.scenario, file.scenario.duration,
                    [this](const scenario::Event& event) { events.push_back(event); });
        if (file.valid()) {
            run->advance(file.scenario.duration);
        }
    }

    // Events of a kind, "time text" each, from `begin` (us) on.
    std::string told(scenario::EventKind kind, canopen::Time begin = 0) const {
        std::string text;
        for (const scenario::Event& event : events) {
            if (event.kind == kind && event.time >= begin) {
                text += event.text + "\n";
            }
        }
        return text;
    }

    driver::ScenarioFile file;
    simulation::Installation installation{genset()};
    std::vector<scenario::Event> events;
    std::optional<scenario::Run> run;
};

}  // namespace cgw::test
