// Values as people type them, into bytes.
#include <gtest/gtest.h>

#include <random>

#include "check/findings_text.hpp"
#include "driver/check_file.hpp"
#include "signal_support.hpp"
#include "signals/encode.hpp"

namespace cgw::signals {
namespace {

class Encode : public testing::Test {
  protected:
    // The frame's text, or the codes of the findings.
    std::string made(std::string_view name, const std::vector<std::string>& values) const {
        diagnostic::Findings findings;
        const Frame* const frame = demand_frame(frames, name, findings);
        if (frame == nullptr) {
            return std::string(findings.all().front().rule->code);
        }
        const Encoded encoded = encode(*frame, values, findings);
        std::string codes;
        for (const diagnostic::Diagnostic& finding : findings.all()) {
            codes += codes.empty() ? "" : " ";
            codes += finding.rule->code;
        }
        return codes.empty() ? cansend_text(*frame, encoded.data) : codes;
    }

    driver::CheckedFile file = driver::check_file(CGW_SAMPLES "/genset.toml");
    std::vector<Frame> frames = frames_of(file.settings, *file.catalogue, file.configuration);
};

}  // namespace

TEST_F(Encode, leaves_at_0_what_is_not_given) {
    EXPECT_EQ(made("RPDO2", {}), "30C#000000000000");
    EXPECT_EQ(made("RPDO4", {"CurrentLoad=65535"}), "50C#FFFF");
}

TEST_F(Encode, takes_values_with_and_without_unit) {
    for (const char* const value : {"900=50", "900=50%", "900 = 50 %", "900=+50.0", "900=5e1 %"}) {
        EXPECT_EQ(made("RPDO2", {value}), "30C#008000000000") << value;
    }
}

TEST_F(Encode, takes_raw_values_up_to_the_width) {
    EXPECT_EQ(made("RPDO2", {"900=0x1F40 raw"}), "30C#401F00000000");
    EXPECT_EQ(made("RPDO2", {"900=8000raw"}), "30C#401F00000000");
    EXPECT_EQ(made("RPDO2", {"900=65535 RAW"}), "30C#FFFF00000000");
    EXPECT_EQ(made("RPDO2", {"900=65536 raw"}), "E1204");
    EXPECT_EQ(made("RPDO2", {"900=-1 raw"}), "E1204");
}

TEST_F(Encode, says_which_value_is_wrong_and_goes_on) {
    EXPECT_EQ(made("RPDO2", {"900=5 bar", "901=1", "902=200", "900"}), "E1203 E1202 E1204 E1203");
    EXPECT_EQ(made("RPDO2", {"900=1", "Setp1Ext=1"}), "E1205");
    EXPECT_EQ(made("TPDO16", {}), "E1201");
}

// What a signal's text says is encoded to the raw value that it came from: all signals, random values.
TEST_F(Encode, reads_every_text_that_values_have) {
    std::mt19937 random(11);
    for (const Frame& frame : frames) {
        for (const Signal& signal : frame.signals) {
            std::uniform_int_distribution<std::int32_t> any(signal.raw_minimum, signal.raw_maximum);
            for (int round = 0; round < 50; ++round) {
                const std::int32_t raw = any(random);
                const std::vector<std::string> value{signal.name + "=" + value_text(signal, raw)};
                diagnostic::Findings findings;
                const Encoded encoded = encode(frame, value, findings);
                ASSERT_EQ(test::findings_text(findings), "") << value[0];
                ASSERT_EQ(raw_value(signal, encoded.data), raw) << value[0];
            }
        }
    }
}

// Any text is a value, or one finding.
TEST_F(Encode, survives_any_text) {
    std::mt19937 random(13);
    constexpr std::string_view characters = "0123456789.+-eExX=% rawonf/min\xC2\xB0";
    for (int round = 0; round < 20'000; ++round) {
        std::string value = random() % 2 == 0 ? "900=" : "";
        for (auto length = random() % 12; length != 0; --length) {
            value += characters[random() % characters.size()];
        }
        diagnostic::Findings findings;
        const std::vector<std::string> values{value};
        encode(*demand_frame(frames, "RPDO2", findings), values, findings);
        ASSERT_LE(findings.all().size(), 1U) << value;
    }
}

}  // namespace cgw::signals
