// Catalogues and declarations add what the file's parameters may then use.
#include "input/support.hpp"

namespace cgw {
namespace {

using test::Files;
using test::gateway;
using test::governor;
using test::head;
using test::Outcome;
using test::read;
using test::show;

const std::string more =
    "device = \"governor\"\n[[row]]\nnumber = 1234\nname = \"MyGain\"\nkind = \"parameter\"\nrange = [0, "
    "5]\n";

std::string with_catalogues(const std::string& list, const Files& files) {
    return show(read(head + "catalogue = " + list + "\n" + governor + gateway, files).findings);
}

TEST(InputCatalogues, a_catalogue_adds_parameters) {
    const Outcome outcome = read(head + "catalogue = [\"more.toml\"]\n" + gateway + governor + "MyGain = 3\n",
                                 {{"more.toml", more}});
    EXPECT_EQ(show(outcome.findings), "fine");
    EXPECT_EQ(outcome.settings().governor.value(1234), 3);
    EXPECT_EQ(outcome.result.file.catalogues, std::vector<std::string>{"more.toml"});
    EXPECT_EQ(outcome.result.file.sources.at("more.toml"), more);
    ASSERT_EQ(outcome.settings().declarations.size(), 1U);
    EXPECT_EQ(outcome.settings().declarations[0]->number, 1234);
}

TEST(InputCatalogues, findings_of_a_catalogue_name_it_beside_the_file) {
    const Outcome outcome = read(head + "catalogue = [\"more.toml\"]\n" + governor + gateway,
                                 {{"more.toml", "device = 1\n"}}, test::rows(), "plants/f.toml");
    ASSERT_EQ(outcome.findings.all().size(), 1U);
    EXPECT_EQ(outcome.findings.all()[0].where.path, "plants/more.toml");
    EXPECT_TRUE(outcome.result.file.sources.contains("plants/more.toml"));
    const Outcome piped = read(head + "catalogue = [\"more.toml\"]\n" + governor + gateway,
                               {{"more.toml", "device = 1\n"}}, test::rows(), "-");
    ASSERT_EQ(piped.findings.all().size(), 1U);
    EXPECT_EQ(piped.findings.all()[0].where.path, "more.toml");
}

TEST(InputCatalogues, one_that_cannot_be_read_is_a_finding_at_its_name) {
    EXPECT_EQ(with_catalogues("[\"a.toml\", \"b.toml\"]", {{"a.toml", "device = \"gateway\"\n"}}),
              "E0009 3:24 cannot open b.toml");
}

TEST(InputCatalogues, names_are_strings_and_named_once) {
    const Files files{{"a", "device = \"gateway\"\n"}};
    EXPECT_EQ(with_catalogues("[1, \"\", \"a\", \"a\"]", files),
              "E0102 3:14 a catalogue's name must be a string, not an integer\n"
              "E0104 3:17 a catalogue's name is empty\n"
              "E0104 3:26 catalogue `a` is named twice [first named here 3:21]");
    EXPECT_EQ(with_catalogues("\"a\"", files), "E0102 3:13 `catalogue` must be a list, not a string");
}

TEST(InputCatalogues, there_are_at_most_16) {
    Files files;
    std::string list;
    for (int i = 0; i < 17; ++i) {
        files[fmt::format("{}", i)] = "device = \"gateway\"\n";
        list += fmt::format("{}\"{}\"", list.empty() ? "" : ",\n", i);
        const std::string findings = with_catalogues("[" + list + "]", files);
        EXPECT_EQ(findings, i < 16 ? "fine" : "E0104 19:1 `catalogue` has 17 elements, more than 16") << i;
    }
}

TEST(InputDeclarations, a_declaration_adds_a_row) {
    const Outcome outcome =
        read(head + governor +
             "[[governor.declare]]\nnumber = 2990\nname = \"TorqueActual\"\nkind = \"measurement\"\n"
             "width = 16\nsigned = true\n" +
             gateway);
    EXPECT_EQ(show(outcome.findings), "fine");
    ASSERT_EQ(outcome.settings().declarations.size(), 1U);
    EXPECT_EQ(outcome.settings().declarations[0]->name, "TorqueActual");
    EXPECT_NE(outcome.catalogue->find(parameter::Device::governor, "torqueactual"), nullptr);
}

TEST(InputDeclarations, a_declared_measurement_still_cannot_be_set) {
    const Outcome outcome =
        read(head + gateway + governor +
             "TorqueActual = 1\n[[governor.declare]]\nnumber = 2990\nname = \"TorqueActual\"\n"
             "kind = \"measurement\"\nwidth = 16\nsigned = true\n");
    EXPECT_EQ(show(outcome.findings), "E0107 13:1 2990 TorqueActual is a measurement and cannot be set");
}

TEST(InputDeclarations, mistakes_in_declarations_do_not_end_the_reading) {
    const Outcome outcome =
        read(head + gateway + governor + "4406 = 2\n[[governor.declare]]\nnumbr = 2990\n");
    const std::string findings = show(outcome.findings);
    EXPECT_NE(findings.find("E0111 13:8"), std::string::npos) << findings;
    EXPECT_NE(findings.find("E0101 15:1"), std::string::npos) << findings;
}

TEST(InputDeclarations, a_declaration_is_a_table) {
    EXPECT_EQ(show(read(head + gateway + "[governor]\ndeclare = [1]\n" + governor).findings),
              "E0102 10:12 a declaration must be a table, not an integer");
}

}  // namespace
}  // namespace cgw
