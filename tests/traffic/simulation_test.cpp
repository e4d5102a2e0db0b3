// The running gateway's own frames: they decode to what the simulated engine does, and a sound plant has no
// findings.
#include <gtest/gtest.h>

#include <map>

#include "emit/emitter.hpp"
#include "genset.hpp"
#include "signals/codec.hpp"
#include "simulation/installation.hpp"

namespace cgw::traffic {
namespace {

class Recorded {
  public:
    Recorded() {
        image::Image::open(bytes_, image_);
        installation_.emplace(image_);
        installation_->plant().can2().observe([this](const frame::Frame& frame, simulation::Time now) {
            audit_.take({++number_, now, true, frame});
            const Owner& owner = decoder_.owners().of(frame.id);
            if (owner.frame != nullptr && owner.frame->name == "TPDO4") {
                compare(*owner.frame, frame);
            }
        });
    }

    simulation::Installation& installation() { return *installation_; }
    diagnostic::Findings findings() {
        audit_.finish(true);
        return audit_.findings("run");
    }
    const Audit& audit() const { return audit_; }
    int compared() const { return compared_; }

  private:
    // A word is at most two main cycles old when it is on the bus.
    void compare(const signals::Frame& pdo, const frame::Frame& frame) {
        const simulation::EngineState& engine = installation_->plant().governor().engine().state();
        const std::map<std::string, double> expected{
            {"Speed", engine.speed}, {"SpeedSetp", engine.speed_setpoint}, {"ActPos", engine.position}};
        for (const signals::Signal& signal : pdo.signals) {
            const auto value = expected.find(signal.name);
            if (value != expected.end()) {
                const double physical =
                    signals::physical_value(signal, signals::raw_value(signal, frame.data));
                EXPECT_NEAR(physical, value->second, 0.03 * signal.maximum) << signal.name;
                ++compared_;
            }
        }
    }

    base::Bytes bytes_ = emit::find_emitter("image")->emit(test::genset().view, {});
    image::Image image_;
    std::optional<simulation::Installation> installation_;
    Decoder decoder_{test::genset().subject};
    Audit audit_{test::genset().subject, decoder_.owners()};
    std::uint64_t number_ = 0;
    int compared_ = 0;
};

std::string codes_of(const diagnostic::Findings& findings) {
    std::string codes;
    for (const diagnostic::Diagnostic& finding : findings.all()) {
        codes += std::string(finding.rule->code) + " " + finding.message + "\n";
    }
    return codes;
}

}  // namespace

TEST(Simulation, decodes_to_what_the_engine_does_and_has_no_findings) {
    Recorded recorded;
    recorded.installation().plant().run_until(20'000'000);
    EXPECT_GT(recorded.compared(), 400);
    EXPECT_EQ(codes_of(recorded.findings()), "");
    EXPECT_GT(recorded.audit().frames(), 1500U);
    EXPECT_TRUE(recorded.audit().was_operational());
}

}  // namespace cgw::traffic
