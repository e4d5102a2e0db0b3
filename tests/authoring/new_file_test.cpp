#include "authoring/new_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>

#include "catalogue/catalogue.hpp"
#include "driver/check_file.hpp"
#include "parameter/value_text.hpp"

namespace cgw {
namespace {

using authoring::Start;
using parameter::Device;

const parameter::Catalogue& shipped() {
    static const parameter::Catalogue catalogue(catalogue::shipped_rows());
    return catalogue;
}

std::string written() {
    return authoring::new_file_text("", shipped());
}

// The lines marked FILL IN with values behind them, as a user would write them.
std::string filled_in(std::string text) {
    const std::map<std::string, std::string> values = {{"416 CanBaudrate", "250"},
                                                       {"416 HzmCanBaudrate", "250"},
                                                       {"426 CanOpenBaudrate", "125"},
                                                       {"427 CanOpenMyNodeID", "1"},
                                                       {"428 CanOpenPartnerNodeID", "127"}};
    for (const auto& [label, value] : values) {
        const std::string line = "# \"" + label + "\" =\n";
        const std::size_t at = text.find(line);
        EXPECT_NE(at, std::string::npos) << label;
        text.replace(at, line.size(), "\"" + label + "\" = " + value + "\n");
    }
    return text;
}

std::vector<std::string> findings(const std::string& text) {
    const driver::CheckedFile file = driver::check_text("new.toml", text);
    std::vector<std::string> all;
    for (const diagnostic::Diagnostic& finding : file.findings.all()) {
        all.push_back(finding.message);
    }
    return all;
}

TEST(NewFile, has_five_values_to_fill_in_and_is_refused_with_one_error_for_each) {
    const std::string text = written();
    const auto all = findings(text);
    std::size_t to_fill_in = 0;
    for (const Start& start : authoring::starts()) {
        if (start.how != Start::How::fill_in) {
            continue;
        }
        ++to_fill_in;
        const std::string label = parameter::label(*shipped().find(start.device, start.number));
        const auto names_it = [&](const std::string& message) {
            return message.find(label) != std::string::npos;
        };
        EXPECT_EQ(std::count_if(all.begin(), all.end(), names_it), 1) << label;
    }
    EXPECT_EQ(to_fill_in, 5U);
    EXPECT_EQ(all.size(), 5U);
    EXPECT_NE(text.find("# 5 values cannot be guessed"), std::string::npos);
}

TEST(NewFile, has_no_findings_once_they_are_filled_in) {
    EXPECT_EQ(findings(filled_in(written())), std::vector<std::string>{});
}

// The remarks at 428 and 430, done as they say.
TEST(NewFile, says_what_a_plant_without_a_partner_writes) {
    std::string text = filled_in(written());
    const auto write = [&text](const std::string& old_line, const std::string& line) {
        const std::size_t at = text.find(old_line);
        ASSERT_NE(at, std::string::npos) << old_line;
        text.replace(at, old_line.size(), line);
    };
    EXPECT_NE(text.find("# without a partner write 0 here and at 430\n\"428 "), std::string::npos);
    EXPECT_NE(text.find("# without a partner (428 = 0) write 0 here as well\n\"430 "), std::string::npos);
    write("\"428 CanOpenPartnerNodeID\" = 127", "\"428 CanOpenPartnerNodeID\" = 0");
    EXPECT_EQ(findings(text).size(), 1U);
    write(" = 2000\n", " = 0\n");
    EXPECT_EQ(findings(text), std::vector<std::string>{});
}

TEST(NewFile, gets_help_with_each_value_that_is_missing) {
    const driver::CheckedFile file = driver::check_text("new.toml", written());
    for (const diagnostic::Diagnostic& finding : file.findings.all()) {
        EXPECT_NE(finding.help, "") << finding.message;
        if (finding.message.starts_with("427 ")) {
            EXPECT_EQ(finding.help, "below [gateway.parameters] write 427 = VALUE, where VALUE is 1..127");
        }
    }
}

TEST(NewFile, has_no_findings_with_its_examples_either) {
    const std::string text = std::regex_replace(
        filled_in(written()), std::regex("\n# (\"[0-9]+ [^\n]* = |\\[network|nodes = )"), "\n$1");
    EXPECT_NE(text.find("\n\"4827 Type_Setpoint2Or1\" = 3\n"), std::string::npos);
    EXPECT_NE(text.find("\n[network]\nnodes = "), std::string::npos);
    EXPECT_EQ(findings(text), std::vector<std::string>{});
}

TEST(NewFile, explains_each_parameter_with_the_words_of_its_row) {
    const std::string text = written();
    for (const Start& start : authoring::starts()) {
        const parameter::Row& row = *shipped().find(start.device, start.number);
        const std::string words = std::string(row.text) + "\n# " + parameter::range_text(row);
        EXPECT_NE(text.find(words), std::string::npos) << row.number;
    }
    EXPECT_NE(text.find("# 2000 Speed, 2031 SpeedSetp, 2300 ActPos\n"), std::string::npos);
}

TEST(NewFile, takes_a_title_and_has_a_blank_one_to_fill_in_otherwise) {
    const std::string titled = authoring::new_file_text("Genset \"2\"", shipped());
    EXPECT_NE(titled.find("\ntitle = \"Genset \\\"2\\\"\"\n"), std::string::npos);
    EXPECT_NE(written().find("\n# title = \"\"\n"), std::string::npos);
}

}  // namespace
}  // namespace cgw
