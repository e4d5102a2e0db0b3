// One finding for a text that is not TOML, at the right place and in plain words.
#include "diagnostic/rules/files.hpp"
#include "toml/judge.hpp"
#include "toml/support.hpp"

namespace cgw {
namespace {

using test::findings_of;

struct Case {
    const char* text;
    const char* finding;
};

void expect_findings(std::initializer_list<Case> cases) {
    for (const Case& item : cases) {
        EXPECT_EQ(findings_of(item.text), item.finding) << item.text;
    }
}

TEST(TomlSyntax, mistakes_around_keys) {
    expect_findings({
        {"a = 1\n= 2\n", "E0004 2:1 expected a key, found '='"},
        {"a\n", "E0004 1:2 expected '=' after the key, found the end of the line"},
        {"a", "E0004 1:2 expected '=' after the key, found the end of the file"},
        {"16404 CanOp(0) = 1\n", "E0004 1:7 expected '=' after the key, found 'C'"},
        {"\xC3\xA4 = 1\n", "E0004 1:1 expected a key, found '\xC3\xA4'"},
        {"a. = 1\n", "E0004 1:4 expected a key, found '='"},
        {"\"a = 1\n", "E0004 1:1 the string is not closed on this line"},
        {"\"\"\"a\"\"\" = 1\n", "E0004 1:3 expected '=' after the key, found '\"'"},
        {"a = 1 b = 2\n", "E0004 1:7 expected the end of the line, found 'b'"},
        {"a =\n", "E0004 1:4 there is no value after '='"},
        {"a = # c\n", "E0004 1:5 there is no value after '='"},
        {"a =", "E0004 1:4 there is no value after '='"},
    });
}

TEST(TomlSyntax, mistakes_in_values) {
    expect_findings({
        {"a = yes\n", "E0004 1:5 'yes' is not a value"},
        {"a = True\n", "E0004 1:5 'True' is not a value"},
        {"a = 0123\n", "E0004 1:5 '0123' is not a value"},
        {"a = 282h\n", "E0004 1:5 '282h' is not a value"},
        {"a = .5\n", "E0004 1:5 '.5' is not a value"},
        {"a = 5.\n", "E0004 1:5 '5.' is not a value"},
        {"a = 1__0\n", "E0004 1:5 '1__0' is not a value"},
        {"a = 1_\n", "E0004 1:5 '1_' is not a value"},
        {"a = 1e\n", "E0004 1:5 '1e' is not a value"},
        {"a = 1._5\n", "E0004 1:5 '1._5' is not a value"},
        {"a = 0x\n", "E0004 1:5 '0x' is not a value"},
        {"a = -0x1\n", "E0004 1:5 '-0x1' is not a value"},
        {"a = 0b2\n", "E0004 1:5 '0b2' is not a value"},
        {"a = +\n", "E0004 1:5 '+' is not a value"},
        {"a = 2026-02-29\n", "E0004 1:5 '2026-02-29' is not a value"},
        {"a = 2026-13-01\n", "E0004 1:5 '2026-13-01' is not a value"},
        {"a = 2026-03-01T25:00:00\n", "E0004 1:5 '2026-03-01T25:00:00' is not a value"},
        {"a = 2026-03-01T10:00:00+1\n", "E0004 1:5 '2026-03-01T10:00:00+1' is not a value"},
        {"a = 10:00\n", "E0004 1:5 '10:00' is not a value"},
        {"a = 10:00:00.\n", "E0004 1:5 '10:00:00.' is not a value"},
        {"a = 1,0\n", "E0004 1:6 expected the end of the line, found ','"},
        {"a = \xE2\x82\xAC\n", "E0004 1:5 expected a value, found '\xE2\x82\xAC'"},
        {"a = x1234567890123456789012345678901234567890123456789\n",
         "E0004 1:5 'x123456789012345678901234567890123456789...' is not a value"},
    });
}

TEST(TomlSyntax, mistakes_in_strings) {
    expect_findings({
        {"a = \"x\nb = 1\n", "E0004 1:5 the string is not closed on this line"},
        {"a = 'x", "E0004 1:5 the string is not closed on this line"},
        {"a = \"x\\",
         "E0004 1:7 a backslash is followed by the end of the file, which is no escape sequence"},
        {"a = \"C:\\dir\"\n", "E0004 1:8 a backslash is followed by 'd', which is no escape sequence"},
        {"a = \"\\uD800\"\n",
         "E0004 1:6 the escape sequence does not name a character: 4 hexadecimal digits of a Unicode "
         "character are "
         "needed"},
        {"a = \"\\U00110000\"\n",
         "E0004 1:6 the escape sequence does not name a character: 8 hexadecimal digits of a Unicode "
         "character are "
         "needed"},
        {"a = \"\\u12\"\n",
         "E0004 1:6 the escape sequence does not name a character: 4 hexadecimal digits of a Unicode "
         "character are "
         "needed"},
        {"x = 1\na = \"\"\"x\n\nb = 1\n", "E0004 2:5 the multi-line string that begins here is not closed"},
        {"a = '''x", "E0004 1:5 the multi-line string that begins here is not closed"},
        {"a = \"\"\"x\"\"\"\"\"\"\n", "E0004 1:14 expected the end of the line, found '\"'"},
    });
}

TEST(TomlSyntax, mistakes_in_lists_and_inline_tables) {
    expect_findings({
        {"a = [1, 2\nb = 3\n", "E0004 2:1 expected ',' or ']' in the list, found 'b'"},
        {"a = [1, 2\n", "E0004 1:5 the list that begins here is not closed by ']'"},
        {"a = [", "E0004 1:5 the list that begins here is not closed by ']'"},
        {"a = [1 2]\n", "E0004 1:8 expected ',' or ']' in the list, found '2'"},
        {"a = [,]\n", "E0004 1:6 expected a value, found ','"},
        {"a = {b = 1\n}\n", "E0004 1:5 the inline table that begins here does not end on its line"},
        {"a = {\n", "E0004 1:5 the inline table that begins here does not end on its line"},
        {"a = {b = 1, # c\n", "E0004 1:5 the inline table that begins here does not end on its line"},
        {"a = {", "E0004 1:5 the inline table that begins here is not closed by '}'"},
        {"a = {b = 1,}\n", "E0004 1:12 an inline table ends without a comma"},
        {"a = {b = 1 c = 2}\n", "E0004 1:12 expected ',' or '}' in the inline table, found 'c'"},
        {"a = {b}\n", "E0004 1:7 expected '=' after the key, found '}'"},
    });
}

TEST(TomlSyntax, mistakes_in_headers) {
    expect_findings({
        {"[a\n", "E0004 1:3 expected ']' at the end of the table's name, found the end of the line"},
        {"[[a]\n", "E0004 1:4 expected ']]' at the end of the table's name, found ']'"},
        {"[]\n", "E0004 1:2 expected a key, found ']'"},
        {"[a b]\n", "E0004 1:4 expected ']' at the end of the table's name, found 'b'"},
        {"[a] x = 1\n", "E0004 1:5 expected the end of the line, found 'x'"},
    });
}

TEST(TomlSyntax, what_is_defined_twice) {
    expect_findings({
        {"a = 1\nb = 2\na = 3\n", "E0004 3:1 `a` is defined twice"},
        {"[a]\n[b]\n[a]\n", "E0004 3:1 `a` is defined twice"},
        {"[a]\n[[a]]\n", "E0004 2:1 `a` is defined already and is no list of tables"},
        {"[[a]]\n[a]\n", "E0004 2:1 `a` is defined twice"},
        {"a = [1]\n[[a]]\n", "E0004 2:1 `a` is defined already and is no list of tables"},
        {"a = {}\n[a.b]\n", "E0004 2:2 `a` has a value already and cannot be a table"},
        {"a = {}\na.b = 1\n", "E0004 2:1 `a` is defined already and takes no more keys"},
        {"a.b = 1\na.b.c = 1\n", "E0004 2:3 `b` is defined already and takes no more keys"},
        {"a.b = 1\n[a]\n", "E0004 2:1 `a` is defined twice"},
        {"a = {b = 1, b = 2}\n", "E0004 1:13 `b` is defined twice"},
        {"[a.b.c]\n[a]\nb.d = 1\n", "E0004 3:1 `b` is defined already and takes no more keys"},
        {"\"a\" = 1\na = 2\n", "E0004 2:1 `a` is defined twice"},
        {"[a]\nb.c = 1\n[a.b]\n", "E0004 3:1 `a.b` is defined twice"},
    });
}

TEST(TomlSyntax, a_second_definition_shows_the_first) {
    diagnostic::Findings findings;
    EXPECT_FALSE(toml::parse("a = 1\nb = 2\na = 3\n", "f.toml", findings));
    ASSERT_EQ(findings.all().size(), 1U);
    ASSERT_EQ(findings.all()[0].related.size(), 1U);
    EXPECT_EQ(findings.all()[0].related[0].message, "first defined here");
    EXPECT_EQ(findings.all()[0].related[0].where.path, "f.toml");
    EXPECT_EQ(test::show(findings.all()[0].related[0].where.range), "1:1-1:2");
}

TEST(TomlSyntax, a_declaration_before_its_table_gets_advice) {
    diagnostic::Findings findings;
    EXPECT_FALSE(toml::parse("[[governor.declare]]\nnumber = 1\n[governor]\n", "f.toml", findings));
    ASSERT_EQ(findings.all().size(), 1U);
    const diagnostic::Diagnostic& finding = findings.all()[0];
    EXPECT_EQ(finding.rule, &diagnostic::rules::toml_syntax);
    EXPECT_EQ(finding.message, "the table `governor` stands after a [[...]] that belongs to it");
    EXPECT_EQ(finding.help, "move it above that [[...]]");
    EXPECT_EQ(test::show(finding.where.range), "3:1-3:11");
    ASSERT_EQ(finding.related.size(), 1U);
    EXPECT_EQ(test::show(finding.related[0].where.range), "1:1-1:21");
}

TEST(TomlSyntax, a_declaration_may_stand_before_the_parameters) {
    EXPECT_EQ(findings_of("[[governor.declare]]\nnumber = 1\n[governor.parameters]\n401 = 1\n"), "fine");
}

TEST(TomlSyntax, keys_in_messages_are_short_and_printable) {
    EXPECT_EQ(toml::quoted("a b"), "`a b`");
    EXPECT_EQ(toml::quoted("a\x1B[31m\n"), "`a?[31m?`");
    EXPECT_EQ(toml::quoted(std::string(79, 'x') + "\xC3\xA4y"), "`" + std::string(79, 'x') + "\xC3\xA4...`");
}

TEST(TomlSyntax, help_names_the_usual_cure) {
    const auto help_of = [](const char* text) {
        diagnostic::Findings findings;
        EXPECT_FALSE(toml::parse(text, "f.toml", findings)) << text;
        return findings.all().empty() ? std::string() : findings.all()[0].help;
    };
    EXPECT_EQ(help_of("400 = 1,0\n"), "decimal numbers have a point; several values stand between [ and ]");
    EXPECT_EQ(help_of("16404 X = 1\n"), "a key with blanks, brackets or other signs stands in quotes");
    EXPECT_EQ(help_of("a = 01\n"), "a number has no leading zeros");
    EXPECT_EQ(help_of("a = 57Fh\n"), "a hexadecimal number begins with 0x");
    EXPECT_EQ(help_of("a = .5\n"), "a decimal number has a digit before its point");
    EXPECT_EQ(help_of("a = on\n"), "text stands in quotes; booleans are true and false");
}

// The scanner is strict; the second judge speaks only where the two differ.
TEST(TomlJudge, names_the_place_in_one_line) {
    const auto complaint = toml::judge("a = 1\nb = 2\n  b = 3\n", toml::Node{});
    ASSERT_TRUE(complaint);
    EXPECT_EQ(complaint->message, "not valid TOML: value (\"b\") already exists.");
    EXPECT_EQ(test::show(complaint->where), "3:7-3:8");
    const auto other = toml::judge("a = 1\n\nb ! 1\n", toml::Node{});
    ASSERT_TRUE(other);
    EXPECT_EQ(other->where.start.line, 3U);
    EXPECT_EQ(other->message.find('\n'), std::string::npos);
}

TEST(TomlJudge, refuses_a_text_that_was_read_differently) {
    const std::string text = "a = 1\nb = [\"x\"]\n";
    toml::Node document = test::parsed(text);
    EXPECT_FALSE(toml::judge(text, document));
    document.entries[1].value.elements[0].text = "y";
    ASSERT_TRUE(toml::judge(text, document));
    EXPECT_EQ(toml::judge(text, document)->message, "the file can be read in two ways");
}

}  // namespace
}  // namespace cgw
