#include <gtest/gtest.h>

#include "diagnostic/renderers.hpp"

namespace cgw::diagnostic {
namespace {

Location at(const std::string& path, std::uint32_t line, std::uint32_t column, std::uint32_t end_column) {
    return {path, {{line, column}, {line, end_column}}};
}

Diagnostic finding(Location where, std::string message = "427 CanOpenMyNodeID is 1, as is its partner") {
    return {&rules::node_id_duplicate, std::move(message), std::move(where)};
}

RenderInput input_with(Diagnostic diagnostic, const std::string& text) {
    RenderInput input;
    input.sources["f.toml"] = text;
    input.files.push_back({"f.toml", {std::move(diagnostic)}});
    return input;
}

}  // namespace

TEST(HumanFormat, puts_the_caret_under_the_value_and_shows_the_other_place) {
    Diagnostic d = finding(at("f.toml", 2, 7, 10));
    d.related.push_back({at("f.toml", 1, 7, 10), "428 CanOpenPartnerNodeID is 127 here"});
    d.help = "give the partner another node id";
    EXPECT_EQ(render_human(input_with(d, "428 = 127\n427 = 127\n")),
              "f.toml:2:7: error: 427 CanOpenMyNodeID is 1, as is its partner [E0203 node-id-duplicate]\n"
              "     2 | 427 = 127\n"
              "       |       ^^^\n"
              "  see f.toml:1:7: 428 CanOpenPartnerNodeID is 127 here\n"
              "     1 | 428 = 127\n"
              "       |       ---\n"
              "  help: give the partner another node id\n"
              "\n"
              "f.toml: not valid, 1 error\n");
}

TEST(HumanFormat, counts_characters_not_bytes_for_the_caret) {
    const std::string text =
        render_human(input_with(finding(at("f.toml", 1, 6, 7)), "\"\xC3\xA4\xC3\xB6\" = 1\r\n"));
    EXPECT_NE(text.find("     1 | \"\xC3\xA4\xC3\xB6\" = 1\n       |    ^\n"), std::string::npos) << text;
}

TEST(HumanFormat, cuts_a_long_line_around_the_caret) {
    const std::string line = std::string(5000, 'x') + "bad" + std::string(5000, 'y');
    const std::string text = render_human(input_with(finding(at("f.toml", 1, 5001, 5004)), line));
    EXPECT_LT(text.size(), 700U);
    EXPECT_NE(text.find("xbady"), std::string::npos);
    const std::size_t source = text.find("     1 | ");
    const std::size_t marks = text.find("       | ", source);
    EXPECT_EQ(text.find("bad", source) - source, text.find("^^^", marks) - marks);
}

TEST(HumanFormat, survives_places_outside_the_text) {
    for (const Location& where : {at("f.toml", 9, 1, 2), at("f.toml", 1, 90, 95), at("gone.toml", 1, 1, 2),
                                  Location{"f.toml", {}}, Location{"f.toml", {{1, 2}, {3, 1}}}}) {
        EXPECT_NE(render_human(input_with(finding(where), "a = 1\n")).find("[E0203"), std::string::npos);
    }
}

TEST(HumanFormat, lets_no_control_character_reach_the_terminal) {
    const std::string text = render_human(
        input_with(finding(at("f.toml", 1, 1, 2), "key \x1b[31m is unknown"), "\x1b[31m = 1\t2\n"));
    EXPECT_EQ(text.find('\x1b'), std::string::npos);
    EXPECT_EQ(text.find('\t'), std::string::npos);
}

TEST(HumanFormat, colours_only_when_asked) {
    RenderInput input = input_with(finding(at("f.toml", 1, 1, 2)), "a = 1\n");
    input.color = true;
    EXPECT_NE(render_human(input).find("\x1b[1;31merror:\x1b[0m"), std::string::npos);
}

TEST(HumanFormat, says_that_a_file_has_no_findings) {
    RenderInput input;
    input.files.push_back({"f.toml", {}});
    EXPECT_EQ(render_human(input), "f.toml: valid, no findings\n");
}

TEST(HumanFormat, indents_a_help_of_several_lines) {
    Diagnostic d = finding(at("f.toml", 1, 1, 2));
    d.help = "declare it:\n[[governor.declare]]\nnumber = 2990";
    EXPECT_NE(render_human(input_with(d, "a = 1\n"))
                  .find("  help: declare it:\n        [[governor.declare]]\n        number = 2990\n"),
              std::string::npos);
}

TEST(ConciseFormat, is_one_line_per_finding_that_editors_understand) {
    EXPECT_EQ(render_concise(input_with(finding(at("f.toml", 2, 7, 10)), "")),
              "f.toml:2:7: error: 427 CanOpenMyNodeID is 1, as is its partner [E0203 node-id-duplicate]\n");
    EXPECT_EQ(render_concise(input_with(finding({"-", {{1, 1}, {1, 2}}}), "")),
              "<stdin>:1:1: error: 427 CanOpenMyNodeID is 1, as is its partner [E0203 node-id-duplicate]\n");
}

TEST(JsonFormat, is_the_documented_document) {
    Diagnostic d = finding(at("f.toml", 2, 7, 10), "m");
    d.related.push_back({at("g.toml", 1, 7, 10), "r"});
    d.help = "h";
    EXPECT_EQ(
        render_json(input_with(d, "")),
        R"({"format_version":1,"valid":false,"files":[{"path":"f.toml","diagnostics":[{"code":"E0203",)"
        R"("name":"node-id-duplicate","level":"error","message":"m",)"
        R"("range":{"start":{"line":2,"column":7},"end":{"line":2,"column":10}},)"
        R"("related":[{"path":"g.toml","range":{"start":{"line":1,"column":7},"end":{"line":1,"column":10}},)"
        R"("message":"r"}],"help":"h"}]}]})"
        "\n");
}

TEST(JsonFormat, says_valid_when_no_file_has_an_error) {
    RenderInput input;
    input.files.push_back({"f.toml", {}});
    EXPECT_EQ(render_json(input),
              "{\"format_version\":1,\"valid\":true,\"files\":[{\"path\":\"f.toml\",\"diagnostics\":[]}]}\n");
}

TEST(Findings, are_sorted_by_place_then_code) {
    Findings findings;
    findings.report(finding(at("f.toml", 2, 1, 2), "third"));
    findings.report(finding(at("f.toml", 1, 5, 6), "second"));
    findings.report({&rules::key_unknown, "first", at("f.toml", 1, 5, 6)});
    findings.sort();
    EXPECT_EQ(findings.all()[0].message, "first");
    EXPECT_EQ(findings.all()[1].message, "second");
    EXPECT_EQ(findings.all()[2].message, "third");
    EXPECT_TRUE(findings.has_errors());
}

TEST(Findings, of_level_error_cannot_be_hidden) {
    Findings findings;
    findings.report(finding(at("f.toml", 2, 1, 2)));
    findings.hide({&rules::node_id_duplicate});
    EXPECT_EQ(findings.all().size(), 1U);
}

}  // namespace cgw::diagnostic
