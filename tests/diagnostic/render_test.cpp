#include <gtest/gtest.h>

#include <chrono>

#include "diagnostic/renderers.hpp"
#include "diagnostic/rules/keys.hpp"
#include "diagnostic/rules/notes.hpp"
#include "diagnostic/rules/plant.hpp"
#include "diagnostic/rules/warnings.hpp"
#include "diagnostic/source_lines.hpp"

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
              "f.toml:2:7: error: 427 CanOpenMyNodeID is 1, as is its partner\n"
              "    [E0203 node-id-duplicate]\n"
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

TEST(HumanFormat, keeps_to_80_columns_between_words) {
    Diagnostic d = finding(at("f.toml", 1, 1, 2),
                           std::string(50, 'a') + " bb \xC3\xA4\xC3\xA4 " + std::string(90, 'c') + " d");
    d.related.push_back({at("f.toml", 1, 1, 2), std::string(70, 'e') + " f"});
    d.help = std::string(70, 'g') + " h i";
    const std::string text = render_human(input_with(d, "x\n"));
    EXPECT_EQ(text, "f.toml:1:1: error: " + std::string(50, 'a') + " bb \xC3\xA4\xC3\xA4\n" + "    " +
                        std::string(90, 'c') +
                        "\n"
                        "    d [E0203 node-id-duplicate]\n"
                        "     1 | x\n"
                        "       | ^\n"
                        "  see f.toml:1:1: " +
                        std::string(70, 'e') +
                        "\n"
                        "      f\n"
                        "     1 | x\n"
                        "       | -\n"
                        "  help: " +
                        std::string(70, 'g') +
                        " h\n"
                        "        i\n"
                        "\n"
                        "f.toml: not valid, 1 error\n");
}

TEST(HumanFormat, says_what_is_not_verified_after_the_count) {
    RenderInput input;
    input.files.push_back({"f.toml", {}, {"the devices", "other\x1bnodes"}});
    EXPECT_EQ(render_human(input),
              "f.toml: valid, no findings\n  not verified:\n  - the devices\n  - other?nodes\n");
    EXPECT_EQ(render_concise(input), "");
}

TEST(HumanFormat, counts_over_all_files) {
    RenderInput input = input_with(finding(at("f.toml", 1, 1, 2)), "a = 1\n");
    input.files.push_back({"g.toml", {}});
    EXPECT_TRUE(render_human(input).ends_with(
        "g.toml: valid, no findings\n2 files: 1 valid, 1 not valid; 1 error\n"));
    input.files = {{"f.toml", {}}, {"g.toml", {}}, {"h.toml", {}}};
    EXPECT_TRUE(render_human(input).ends_with("\n3 files: 3 valid\n"));
    input.verdicts = false;
    EXPECT_EQ(render_human(input), "");
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
        R"("message":"r"}],"help":"h"}],"not_verified":[]}]})"
        "\n");
}

TEST(JsonFormat, says_valid_when_no_file_has_an_error) {
    RenderInput input;
    input.files.push_back({"f.toml", {}});
    EXPECT_EQ(render_json(input),
              "{\"format_version\":1,\"valid\":true,\"files\":[{\"path\":\"f.toml\",\"diagnostics\":[],"
              "\"not_verified\":[]}]}\n");
}

TEST(JsonFormat, carries_what_is_not_verified) {
    RenderInput input;
    input.files.push_back({"f.toml", {}, {"the devices"}});
    EXPECT_NE(render_json(input).find("\"not_verified\":[\"the devices\"]"), std::string::npos);
}

TEST(GithubFormat, is_one_workflow_command_per_finding) {
    EXPECT_EQ(render_github(input_with(finding(at("f.toml", 2, 7, 10)), "428 = 127\n427 = 127\n")),
              "::error file=f.toml,line=2,col=7,endLine=2,endColumn=10,title=E0203 node-id-duplicate::427 "
              "CanOpenMyNodeID is 1, as is its partner\n");
    Diagnostic note{&rules::time_quantised, "m", at("f.toml", 1, 1, 4)};
    EXPECT_EQ(render_github(input_with(note, "abc\n")).find("::notice file="), 0U);
    Diagnostic warning{&rules::heartbeat_off, "m", at("f.toml", 1, 1, 4)};
    EXPECT_EQ(render_github(input_with(warning, "abc\n")).find("::warning file="), 0U);
    warning.promoted = true;
    EXPECT_EQ(render_github(input_with(warning, "abc\n")).find("::error file="), 0U);
}

TEST(GithubFormat, escapes_what_would_end_a_command_or_a_property) {
    Diagnostic d = finding(at("a:b,c%.toml", 1, 1, 2), "100 %, so: m\r");
    d.related.push_back({at("g.toml", 3, 4, 5), "r"});
    d.help = "first\nsecond";
    EXPECT_EQ(render_github(input_with(d, "")),
              "::error file=a%3Ab%2Cc%25.toml,line=1,col=1,endLine=1,endColumn=2,title=E0203 "
              "node-id-duplicate::100 %25, so: m?%0Asee g.toml:3:4: r%0Ahelp: first%0Asecond\n");
}

TEST(GithubFormat, leaves_out_the_places_that_mean_nothing) {
    EXPECT_EQ(render_github(input_with(finding({"f.toml", {}}, "m"), "")),
              "::error file=f.toml,title=E0203 node-id-duplicate::m\n");
    EXPECT_EQ(render_github(input_with(finding(at("-", 2, 1, 2), "m"), "")),
              "::error line=2,col=1,endLine=2,endColumn=2,title=E0203 node-id-duplicate::m\n");
    EXPECT_EQ(render_github(input_with(finding({"f.toml", {{1, 2}, {3, 1}}}, "m"), "")),
              "::error file=f.toml,line=1,endLine=3,title=E0203 node-id-duplicate::m\n");
}

TEST(SarifFormat, points_into_the_file_in_utf16_code_units) {
    // a-umlaut: 2 bytes, 1 unit; the engine's emoji: 4 bytes, 2 units
    const std::string line = "\xC3\xA4\xF0\x9F\x9A\xA2=bad\n";
    const std::string text = render_sarif(input_with(finding(at("f.toml", 1, 8, 11)), line));
    EXPECT_NE(text.find(R"("region":{"startLine":1,"startColumn":5,"endLine":1,"endColumn":8})"),
              std::string::npos)
        << text.substr(text.find("\"results\""));
}

TEST(SarifFormat, survives_places_outside_the_text) {
    for (const Location& where :
         {at("f.toml", 9, 1, 2), at("f.toml", 1, 90, 95), at("gone.toml", 1, 1, 2),
          Location{"f.toml", {{1, 2}, {3, 1}}}, Location{"f.toml", {{1, 9}, {1, 3}}}}) {
        EXPECT_NE(render_sarif(input_with(finding(where), "a = 1\n")).find("\"region\""), std::string::npos);
    }
    EXPECT_EQ(render_sarif(input_with(finding({"f.toml", {}}), "")).find("\"region\""), std::string::npos);
    EXPECT_NE(render_sarif(input_with(finding(at("f.toml", 1, 90, 95)), "a = 1\n"))
                  .find(R"("startColumn":90,"endLine":1,"endColumn":95)"),
              std::string::npos);
}

TEST(SarifFormat, encodes_paths_as_uris) {
    EXPECT_NE(render_sarif(input_with(finding(at("a b/\xC3\xA4:#.toml", 1, 1, 2)), ""))
                  .find(R"("artifactLocation":{"uri":"a%20b/%C3%A4%3A%23.toml"})"),
              std::string::npos);
    EXPECT_NE(
        render_sarif(input_with(finding(at("/a/b.toml", 1, 1, 2)), "")).find(R"({"uri":"file:///a/b.toml"})"),
        std::string::npos);
}

TEST(Utf16Columns, are_right_in_any_order_of_places) {
    const std::map<std::string, std::string> sources = {{"f.toml", "\xC3\xA4\xC3\xA4\xC3\xA4xyz\n\xC3\xA4"}};
    SourceLines lines(sources);
    Utf16Columns columns(lines);
    EXPECT_EQ(columns.convert(at("f.toml", 1, 7, 9)).start.column, 4U);
    EXPECT_EQ(columns.convert(at("f.toml", 1, 8, 9)).start.column, 5U);
    EXPECT_EQ(columns.convert(at("f.toml", 1, 3, 5)).start.column, 2U);
    EXPECT_EQ(columns.convert(at("f.toml", 1, 3, 5)).end.column, 3U);
    EXPECT_EQ(columns.convert({"f.toml", {{1, 1}, {2, 3}}}).end.column, 2U);
}

// One line as long as the largest file, with a finding at every 64th byte.
TEST(Utf16Columns, stay_cheap_on_one_long_line) {
    RenderInput input = input_with(finding(at("f.toml", 1, 1, 2), "m"), std::string(1U << 22U, 'x'));
    for (std::uint32_t column = 9; column < (1U << 22U); column += 64) {
        input.files[0].findings.push_back(finding(at("f.toml", 1, column, column + 1), "m"));
    }
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_GT(render_github(input).size(), 1U << 20U);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(60));
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
