// Any bytes whatever end in a document or in findings; what is accepted is spanned correctly.
#include <array>
#include <cstdint>

#include "support/golden.hpp"
#include "toml/support.hpp"

namespace cgw {
namespace {

using toml::Kind;
using toml::Node;

constexpr std::array<std::string_view, 4> seeds = {
    "#:schema x\nformat = 1\ntitle = \"Genset 2, starboard\"\n\n[document]\ncreated = 2026-03-01\nrevision = "
    "2\n"
    "[governor]\nmain_cycle_us = 15_625\n[governor.parameters]\n401 = 1\n\"16460 CanOpTPDO4-16Cyc(0)\" = 16\n"
    "16400 = [2000, 2031, 2300, 2330]\n[[governor.declare]]\nnumber = 2990\nsigned = true\n"
    "external = [-100.0, 100.0]\n[gateway]\nidentity = { software_version = 1, serial_date = 407 }\n"
    "[gateway.parameters]\nCanOpTPDO5-16ID = [0x282]\n[network]\nnodes = [2, 127]\n",
    "a.b = 1\r\nc = [ 1, # x\r\n [2.5e-3, -inf], {d = 'e', f.g = \"\\u00e4\\\\\"} ]\r\nh = \"\"\"\r\nx "
    "\\\r\n y\"\"\"\r\n",
    "\xEF\xBB\xBF[a.b.c]\nx = 2026-03-01 10:00:00.5Z\n[a]\ny = 07:32:00\n[[a.d]]\nz = "
    "true\n[[a.d]]\n[a.d.e]\nf = 0b101\n",
    "k = '''it's'''\n'q.r' = 0o17\n\"\xC3\xA4\" = \"\xE2\x82\xAC\"\n[ \"s t\" . u ]\nv = {}\nw = []\nn = "
    "nan\nm = 1e9\n",
};

constexpr std::array<std::string_view, 24> fragments = {
    "[", "]", "{",  "}",    "[[", "]]",  "\"",  "'", "\"\"\"", "'''",  "=",    ".",
    ",", "#", "\n", "\r\n", "\\", "\\u", "0b1", "a", "1",      "\x00", "\xC3", "e"};

// A small generator of our own, so that every run and every machine sees the same mutations.
class Random {
  public:
    std::size_t below(std::size_t limit) {
        state_ ^= state_ << 13U;
        state_ ^= state_ >> 7U;
        state_ ^= state_ << 17U;
        return static_cast<std::size_t>(state_ % limit);
    }

  private:
    std::uint64_t state_ = 0x9E3779B97F4A7C15;
};

std::string mutated(Random& random, std::string text) {
    for (std::size_t count = 1 + random.below(3); count > 0; --count) {
        const std::size_t at = random.below(text.size() + 1);
        switch (random.below(5)) {
            case 0:
                text.insert(at, fragments[random.below(fragments.size())]);
                break;
            case 1:
                text.erase(at, 1 + random.below(6));
                break;
            case 2:
                text.insert(at, text.substr(random.below(text.size() + 1), random.below(30)));
                break;
            case 3:
                if (at < text.size()) {
                    text[at] = static_cast<char>(random.below(256));
                }
                break;
            default:
                text.resize(at);
                break;
        }
    }
    return text;
}

void expect_spans(std::string_view text, const Node& node) {
    const std::string written = test::slice(text, node.range);
    if (node.kind != Kind::string && node.kind != Kind::array && node.kind != Kind::table &&
        node.kind != Kind::boolean) {
        EXPECT_EQ(written, node.text) << text;
    }
    if (node.kind == Kind::string) {
        EXPECT_TRUE(written.front() == '"' || written.front() == '\'') << text;
        EXPECT_EQ(written.front(), written.back()) << text;
    }
    if (node.kind == Kind::array) {
        EXPECT_EQ(written.front(), '[') << text;
        EXPECT_EQ(written.back(), ']') << text;
    }
    for (const Node& element : node.elements) {
        expect_spans(text, element);
    }
    for (const toml::Entry& entry : node.entries) {
        const std::string key = test::slice(text, entry.key_range);
        EXPECT_TRUE(key == entry.key || key.front() == '"' || key.front() == '\'') << text;
        expect_spans(text, entry.value);
    }
}

void expect_sane(const std::string& text) {
    diagnostic::Findings findings;
    const std::optional<Node> document = toml::parse(text, "f.toml", findings);
    EXPECT_NE(document.has_value(), findings.has_errors()) << text;
    for (const diagnostic::Diagnostic& finding : findings.all()) {
        EXPECT_EQ(finding.message.find('\n'), std::string::npos) << text;
        EXPECT_EQ(finding.message.find("not valid TOML"), std::string::npos) << finding.message << "\n"
                                                                             << text;
        EXPECT_EQ(finding.message.find("in two ways"), std::string::npos) << text;
        EXPECT_GE(finding.where.range.start.line, 1U) << text;
        EXPECT_GE(finding.where.range.start.column, 1U) << text;
    }
    if (document) {
        for (const toml::Entry& entry : document->entries) {
            expect_spans(text, entry.value);
        }
    }
}

TEST(TomlMutations, end_in_a_document_or_in_findings) {
    Random random;
    for (int i = 0; i < 1500; ++i) {
        expect_sane(mutated(random, std::string(seeds[random.below(seeds.size())])));
    }
}

TEST(TomlMutations, of_the_samples_end_in_a_document_or_in_findings) {
    Random random;
    for (const char* name : {"genset.toml", "manual-example.toml", "minimal.toml"}) {
        const std::string sample = test::read_text(std::string(CGW_SAMPLES) + "/" + name);
        ASSERT_FALSE(sample.empty()) << name;
        expect_sane(sample);
        for (int i = 0; i < 40; ++i) {
            expect_sane(mutated(random, sample));
        }
    }
}

TEST(TomlMutations, every_beginning_of_a_text_is_handled) {
    for (const std::string_view seed : seeds) {
        for (std::size_t length = 0; length <= seed.size(); ++length) {
            expect_sane(std::string(seed.substr(0, length)));
        }
    }
}

}  // namespace
}  // namespace cgw
