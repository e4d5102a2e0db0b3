// Copies of parameter files: what is replaced, what stays, and what is refused.
#include "authoring/clone.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "catalogue/catalogue.hpp"
#include "input/parameter_file.hpp"

namespace cgw::authoring {
namespace {

// The copy, or the findings as "E0508 3:4 message".
std::string clone(const std::string& text, const CloneRequest& request) {
    parameter::Catalogue catalogue(catalogue::shipped_rows());
    diagnostic::Findings findings;
    const auto load = [](const std::string& name) -> base::Result<std::string> {
        return base::failure("cannot read " + name);
    };
    const input::ReadResult read = input::read_parameter_file(text, "f.toml", catalogue, load, findings);
    EXPECT_FALSE(findings.has_errors()) << findings.all()[0].message;
    const config::Configuration configuration = config::resolve(read.file.settings, catalogue);
    const std::optional<std::string> copy =
        clone_text(text, read.file.settings, configuration, request, findings);
    if (copy) {
        EXPECT_TRUE(findings.all().empty());
        return *copy;
    }
    std::string said;
    for (const diagnostic::Diagnostic& finding : findings.all()) {
        said += fmt::format("{} {}:{} {}\n", finding.rule->code, finding.where.range.start.line,
                            finding.where.range.start.column, finding.message);
    }
    return said;
}

std::string file(const std::string& top, const std::string& governor, const std::string& gateway) {
    return fmt::format(
        "{}\n[governor.parameters]\n401 = 1\n403 = 1\n416 = 250\n4406 = 1\n{}\n[gateway.parameters]\n401 = "
        "1\n"
        "402 = 1\n416 = 250\n4400 = 1\n426 = 125\n{}\n",
        top, governor, gateway);
}

const std::string tpdo5 = "16404 = 2905\n16461 = 200";

TEST(Clone, replaces_node_id_and_title_and_nothing_else) {
    EXPECT_EQ(
        clone(file("format = 1 # first\ntitle = 'old' # keep", "", "CanOpenMyNodeID = 5   # was 4"),
              {.node_id = 17, .title = "say \"no\""}),
        file("format = 1 # first\ntitle = \"say \\\"no\\\"\" # keep", "", "CanOpenMyNodeID = 17   # was 4"));
}

TEST(Clone, keeps_the_title_when_none_is_given) {
    EXPECT_EQ(clone(file("format = 1\ntitle = \"a\"", "", "427 = 5"), {.node_id = 6}),
              file("format = 1\ntitle = \"a\"", "", "427 = 6"));
}

TEST(Clone, writes_a_title_below_the_format_with_the_line_ends_of_the_file) {
    EXPECT_EQ(clone(file("format = 1  # one", "", "427 = 5"), {.node_id = 6, .title = "b"}),
              file("format = 1  # one\ntitle = \"b\"", "", "427 = 6"));
    EXPECT_EQ(clone("\xEF\xBB\xBF" + file("format = 1\r", "", "427 = 5\r"), {.node_id = 6, .title = "b"}),
              "\xEF\xBB\xBF" + file("format = 1\r\ntitle = \"b\"\r", "", "427 = 6\r"));
}

TEST(Clone, replaces_a_title_of_several_lines) {
    EXPECT_EQ(clone(file("format = 1\ntitle = \"\"\"a \\\n  b\"\"\" # end", "", "427 = 5"),
                    {.node_id = 6, .title = "c"}),
              file("format = 1\ntitle = \"c\" # end", "", "427 = 6"));
}

TEST(Clone, shifts_identifiers_that_follow_the_node_id_in_their_own_notation) {
    EXPECT_EQ(clone(file("format = 1", tpdo5, "427 = 0x05\n16404 = [0x685, 0x0385, 1669, 0] # TPDO5.."),
                    {.node_id = 0x1F}),
              file("format = 1", tpdo5, "427 = 0x1F\n16404 = [0x69F, 0x039F, 1695, 0] # TPDO5.."));
    EXPECT_EQ(clone(file("format = 1", tpdo5, "427 = 10\n16404 = 0x68a"), {.node_id = 0x1F}),
              file("format = 1", tpdo5, "427 = 31\n16404 = 0x69f"));
}

TEST(Clone, writes_numbers_of_unusual_spelling_as_usual) {
    EXPECT_EQ(
        clone(file("format = 1", tpdo5, "427 = 0b101\n16404 = [0x6_85, 1_669, 0o3205]"), {.node_id = 0x1F}),
        file("format = 1", tpdo5, "427 = 31\n16404 = [0x69F, 1695, 1695]"));
}

TEST(Clone, leaves_identifiers_of_inactive_tpdos_that_do_not_follow_the_node_id) {
    EXPECT_EQ(clone(file("format = 1", "", "427 = 5\n16404 = 0x6A0"), {.node_id = 6}),
              file("format = 1", "", "427 = 6\n16404 = 0x6A0"));
}

TEST(Clone, refuses_an_identifier_that_both_gateways_would_send) {
    EXPECT_EQ(
        clone(file("format = 1", tpdo5, "427 = 5\n16404 = 0x6A0"), {.node_id = 6}),
        "E0508 16:9 TPDO5 would be sent under 6A0h by both gateways; 16404 CanOpTPDO5-16ID(0) is not of the "
        "form base + node id 5\n");
}

TEST(Clone, gives_new_identifiers_to_active_tpdos_that_do_not_follow_the_node_id) {
    const std::string three = "16404 = 2905\n16408 = 2907\n16412 = 2908\n16461 = [200, 200, 200]";
    EXPECT_EQ(clone(file("format = 1", three, "427 = 5\n16404 = [0x6A0, 0x685, 0x6A1, 0x6A2]"),
                    {.node_id = 6, .identifiers_from = 0x690}),
              file("format = 1", three, "427 = 6\n16404 = [0x690, 0x686, 0x691, 0x6A2]"));
}

TEST(Clone, refuses_new_identifiers_that_are_taken_or_not_free) {
    const std::string original = file("format = 1", tpdo5, "427 = 5\n16404 = [0x6A0, 0x685, 0x6DF]");
    EXPECT_EQ(
        clone(original, {.node_id = 6, .identifiers_from = 0x6A0}),
        "E0508 16:10 TPDO5 of the copy cannot have 6A0h: a PDO of the original or of the copy has it\n");
    EXPECT_EQ(
        clone(original, {.node_id = 6, .identifiers_from = 0x686}),
        "E0508 16:10 TPDO5 of the copy cannot have 686h: a PDO of the original or of the copy has it\n");
    EXPECT_EQ(
        clone(original, {.node_id = 6, .identifiers_from = 0x6E0}),
        "E0508 16:10 TPDO5 of the copy cannot have 6E0h: it is outside 680h to 6DFh, which CiA 301 leaves "
        "free\n");
}

TEST(Clone, keeps_all_identifiers_for_another_network) {
    EXPECT_EQ(clone(file("format = 1", tpdo5, "427 = 5\n16404 = [0x6A0, 0x685]"),
                    {.node_id = 6, .keep_identifiers = true}),
              file("format = 1", tpdo5, "427 = 6\n16404 = [0x6A0, 0x685]"));
}

}  // namespace
}  // namespace cgw::authoring
