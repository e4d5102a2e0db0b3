// Plausible files put together at random: whatever they say, reading ends with settings that are in range.
#include <cstdint>

#include "catalogue/catalogue.hpp"
#include "input/support.hpp"

namespace cgw {
namespace {

class Random {
  public:
    std::size_t below(std::size_t limit) {
        state_ ^= state_ << 13U;
        state_ ^= state_ >> 7U;
        state_ ^= state_ << 17U;
        return static_cast<std::size_t>(state_ % limit);
    }
    template <std::size_t count>
    std::string_view one_of(const std::array<std::string_view, count>& choices) {
        return choices[below(count)];
    }

  private:
    std::uint64_t state_ = 0xD1B54A32D192ED03;
};

constexpr std::array<std::string_view, 12> sections = {"[governor.parameters]",
                                                       "[gateway.parameters]",
                                                       "[governor]",
                                                       "[gateway]",
                                                       "[network]",
                                                       "[document]",
                                                       "[[governor.declare]]",
                                                       "[gateway.identity]",
                                                       "[gateway.bit_timing.can1]",
                                                       "[other]",
                                                       "[[network]]",
                                                       "[governor.parameters.401]"};

constexpr std::array<std::string_view, 34> keys = {"format",
                                                   "title",
                                                   "catalogue",
                                                   "created",
                                                   "author",
                                                   "revision",
                                                   "profile",
                                                   "main_cycle_us",
                                                   "nodes",
                                                   "declare",
                                                   "number",
                                                   "name",
                                                   "kind",
                                                   "width",
                                                   "signed",
                                                   "internal",
                                                   "external",
                                                   "bit",
                                                   "identity",
                                                   "bit_timing",
                                                   "clock_hz",
                                                   "family",
                                                   "401",
                                                   "\"409 CanBaudrate\"",
                                                   "16400",
                                                   "CanOpTPDO5-16ID",
                                                   "\"CanOpTPDO4-16Cyc (12)\"",
                                                   "2000",
                                                   "65535",
                                                   "\"812 Foo\"",
                                                   "\"403 CanBaudrate\"",
                                                   "canmynodenumber",
                                                   "16451",
                                                   "\"\""};

constexpr std::array<std::string_view, 26> values = {"0",
                                                     "1",
                                                     "-1",
                                                     "250",
                                                     "0x7FF",
                                                     "1.5",
                                                     "nan",
                                                     "-inf",
                                                     "true",
                                                     "\"\"",
                                                     "\"measurement\"",
                                                     "\"switch\"",
                                                     "\"mcp2515\"",
                                                     "2026-03-01",
                                                     "07:00:00",
                                                     "[]",
                                                     "[1, 2, 3]",
                                                     "[[1], {a = 1}]",
                                                     "{ can1 = { clock_hz = 1 } }",
                                                     "{}",
                                                     "[-32768, 32767]",
                                                     "9223372036854775807",
                                                     "2990",
                                                     "[\"a\", \"b\", \"a\", 1]",
                                                     "\"\\u0000\"",
                                                     "29999"};

std::string random_file(Random& random) {
    std::string text = random.below(4) == 0 ? "" : "format = 1\ntitle = \"t\"\n";
    for (std::size_t lines = random.below(25); lines > 0; --lines) {
        text += random.below(4) == 0 ? fmt::format("{}\n", random.one_of(sections))
                                     : fmt::format("{} = {}\n", random.one_of(keys), random.one_of(values));
    }
    return text;
}

void expect_in_range(const parameter::ParameterSet& set, const std::string& text) {
    for (const auto& [number, assignment] : set.all()) {
        ASSERT_NE(assignment.row, nullptr) << text;
        EXPECT_EQ(assignment.row->number, number) << text;
        EXPECT_TRUE(assignment.row->settable()) << text;
        EXPECT_FALSE(assignment.row->minimum && !(assignment.value >= *assignment.row->minimum)) << text;
        EXPECT_FALSE(assignment.row->maximum && !(assignment.value <= *assignment.row->maximum)) << text;
    }
}

TEST(InputRandomFiles, always_end_in_settings_that_are_safe_to_check) {
    Random random;
    const test::Files files{
        {"a", "device = \"governor\"\n[[row]]\nnumber = 2991\nname = \"X\"\nkind = \"measurement\"\n"},
        {"b", "[[row]]\n"}};
    for (int i = 0; i < 600; ++i) {
        const std::string text = random_file(random);
        const auto shipped =
            i % 50 == 0 ? catalogue::shipped_rows() : std::span<const parameter::Row>(test::rows());
        const test::Outcome outcome = test::read(text, files, shipped);
        EXPECT_TRUE(outcome.result.usable || outcome.findings.has_errors()) << text;
        expect_in_range(outcome.settings().governor, text);
        expect_in_range(outcome.settings().gateway, text);
        for (const diagnostic::Diagnostic& finding : outcome.findings.all()) {
            EXPECT_FALSE(finding.message.empty()) << text;
            EXPECT_EQ(finding.message.find('\n'), std::string::npos) << finding.message;
        }
    }
}

}  // namespace
}  // namespace cgw
