// One slip in a [[governor.declare]] is one finding, and what is left of the table stays usable.
#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "catalogue/catalogue.hpp"
#include "catalogue/findings_text.hpp"
#include "parameter/catalogue.hpp"
#include "toml/document.hpp"

namespace {

using cgw::parameter::Catalogue;
using cgw::parameter::Device;
using cgw::parameter::List;
using cgw::parameter::Row;

const std::string not_a_name =
    " is no name: it starts with a letter, has up to 64 letters, digits and _ - : . /\n";
const std::string unit_rule = "declaration-invalid: a unit has 1 to 16 bytes and no control characters\n";
const std::string bit = "kind = \"measurement\"\nbit = true\n";
const std::string word = "kind = \"measurement\"\nwidth = 16\nsigned = false\n";

class RefusedDeclaration : public testing::Test {
  protected:
    // Cells start in line 2; every declaration meets the shipped rows alone. The finding's code goes to
    // `code`.
    std::string declare(const std::string& cells) {
        catalogue.emplace(cgw::catalogue::shipped_rows());
        findings = {};
        const auto document = cgw::toml::parse("[[declare]]\n" + cells + "\n", "plant.toml", findings);
        if (document) {
            EXPECT_EQ(cgw::catalogue::read_declaration(document->find("declare")->value.elements[0],
                                                       "plant.toml", *catalogue, findings),
                      nullptr);
        }
        code = findings.all().empty() ? "" : findings.all()[0].rule->code;
        return cgw::test::findings_text(findings);
    }
    const Row* find(int number) const {
        return catalogue->find(Device::governor, static_cast<std::uint16_t>(number));
    }

    std::optional<Catalogue> catalogue;
    cgw::diagnostic::Findings findings;
    std::string code;
};

TEST_F(RefusedDeclaration, counts_a_refused_name_as_given) {
    EXPECT_EQ(declare("number = 2990\nname = \"A B\"\n" + bit),
              "3:8 declaration-invalid: `A B`" + not_a_name);
    EXPECT_EQ(code, "E0113");
    EXPECT_EQ(declare("number = 2990\nname = 5\n" + bit),
              "3:8 key-type: `name` is a string, not an integer\n");
    EXPECT_EQ(declare("number = 812\nname = \"A B\"\nkind = \"switch\""),
              "3:8 declaration-invalid: `A B`" + not_a_name);
}

TEST_F(RefusedDeclaration, takes_names_of_printable_characters_without_blanks_only) {
    for (const std::string name : {"", "   ", "4X", "Größe", "a(1)"}) {
        EXPECT_EQ(declare("number = 2990\nname = \"" + name + "\"\n" + bit),
                  "3:8 declaration-invalid: `" + name + "`" + not_a_name);
    }
    EXPECT_EQ(declare("number = 2990\nname = \"" + std::string(65, 'n') + "\"\n" + bit),
              "3:8 declaration-invalid: `" + std::string(65, 'n') + "`" + not_a_name);
}

TEST_F(RefusedDeclaration, counts_a_refused_bit_or_width_as_given) {
    EXPECT_EQ(declare("number = 2990\nname = \"T\"\nkind = \"measurement\"\nbit = 1"),
              "5:7 key-type: `bit` is a boolean, not an integer\n");
    EXPECT_EQ(declare("number = 2990\nname = \"T\"\nkind = \"measurement\"\nwidth = 32\nsigned = true\n"
                      "internal = [0, 65535]"),
              "5:9 declaration-invalid: width 32 is neither 8 nor 16\n");
    EXPECT_EQ(declare("number = 2990\nname = \"T\"\nkind = \"measurement\"\nwidth = 16\nsigned = 1\n"
                      "internal = [-5, 5]"),
              "6:10 key-type: `signed` is a boolean, not an integer\n");
    EXPECT_EQ(declare("number = 2990\nname = \"T\"\nkind = \"measurement\"\nwidth = 16\ninternal = [-5, 5]"),
              "1:1 key-missing: `signed` of 2990 is missing\n");
    EXPECT_FALSE(find(2990)->scaling);
}

TEST_F(RefusedDeclaration, compares_no_refused_cell_with_the_catalogue) {
    EXPECT_EQ(
        declare("number = 2918\ninternal = [0, 6.535]"),
        "3:12 declaration-invalid: internal [0, 6.535] is not a range of integers within -32768..65535\n");
    EXPECT_EQ(code, "E0113");
    EXPECT_EQ(find(2918)->scaling->internal_maximum, 65535);
    EXPECT_EQ(declare("number = 2918\nsigned = \"yes\""),
              "3:10 key-type: `signed` is a boolean, not a string\n");
    EXPECT_EQ(declare("number = 2918\nbit = 1"), "3:7 key-type: `bit` is a boolean, not an integer\n");
    EXPECT_EQ(declare("number = 2918\nname = \"\""), "3:8 declaration-invalid: ``" + not_a_name);
}

TEST_F(RefusedDeclaration, of_a_switch_leaves_both_its_numbers_settable) {
    EXPECT_EQ(declare("number = 850\nname = \"FunctX\"\nkind = \"switch\""),
              "4:8 declaration-invalid: 850 is no switch: its numbers are 810..849 and 4810..4849 of the "
              "governor\n");
    EXPECT_EQ(code, "E0113");
    ASSERT_NE(find(850), nullptr);
    EXPECT_TRUE(find(850)->settable());
    EXPECT_EQ(find(850)->name, "FunctX");
    ASSERT_NE(find(4850), nullptr);
    EXPECT_TRUE(find(4850)->settable());
    EXPECT_NE(declare("number = 4930\nname = \"ChanType_X\"\nkind = \"sensor\""), "");
    EXPECT_TRUE(find(930)->settable());
    EXPECT_TRUE(find(4930)->settable());
}

TEST_F(RefusedDeclaration, of_an_unknown_kind_becomes_what_its_cells_and_number_suggest) {
    EXPECT_EQ(declare("number = 7001\nname = \"X\"\nkind = \"valve\""),
              "4:8 key-value: unknown kind `valve`\n");
    EXPECT_EQ(code, "E0104");
    EXPECT_TRUE(find(7001)->settable());
    EXPECT_EQ(declare("number = 2990\nname = \"X\"\nkind = \"mesurement\""),
              "4:8 key-value: unknown kind `mesurement`\n");
    EXPECT_EQ(find(2990)->list, List::measurement);
    EXPECT_EQ(find(2990)->width, 16);
    EXPECT_EQ(declare("number = 7001\nname = \"X\"\nkind = \"mesurement\"\nbit = true"),
              "4:8 key-value: unknown kind `mesurement`\n");
    EXPECT_EQ(find(7001)->list, List::measurement);
    EXPECT_EQ(declare("number = 905\nkind = \"mesurement\"\nbit = true"),
              "3:8 key-value: unknown kind `mesurement`\n");
    EXPECT_TRUE(find(905)->settable());
}

TEST_F(RefusedDeclaration, of_a_kind_that_cannot_be_declared_says_no_more) {
    EXPECT_EQ(declare("number = 810\nkind = \"switch\"\nname = \"Other\""),
              "2:10 declaration-invalid: 810 is the engine stop, which is known and cannot be declared\n");
    EXPECT_EQ(declare("number = 401\nkind = \"parameter\"\nname = \"Other\""),
              "3:8 key-value: a declaration's kind is measurement, switch or sensor, not parameter\n");
}

TEST_F(RefusedDeclaration, with_a_name_that_is_taken_keeps_its_number) {
    EXPECT_EQ(declare("number = 2990\nname = \"speed\"\n" + bit),
              "3:8 declaration-invalid: the name speed belongs to 2000 already\n");
    EXPECT_EQ(code, "E0113");
    ASSERT_NE(find(2990), nullptr);
    EXPECT_EQ(find(2990)->name, "");
    EXPECT_TRUE(find(2990)->is_bit());
    EXPECT_EQ(catalogue->find(Device::governor, "speed")->number, 2000);
}

TEST_F(RefusedDeclaration, shows_control_characters_as_question_marks) {
    EXPECT_EQ(declare("number = 2990\nname = \"A\\u0000\\u001bB\"\n" + bit),
              "3:8 declaration-invalid: `A??B`" + not_a_name);
    EXPECT_EQ(declare("number = 2990\nname = \"X\"\nkind = \"\\u001b[31m\""),
              "4:8 key-value: unknown kind `?[31m`\n");
    EXPECT_EQ(declare("number = 2990\nname = \"X\"\n\"\\u001b\\u0000\" = 1\n" + bit),
              "4:1 key-unknown: unknown key `??`\n");
}

TEST_F(RefusedDeclaration, takes_units_of_16_bytes_without_control_characters) {
    for (const std::string unit : {"", "a\\u0000", "\\u001b", "\\u0085", "\\u007f", "12345678901234567"}) {
        EXPECT_EQ(declare("number = 2990\nname = \"X\"\nunit = \"" + unit + "\"\n" + bit), "4:8 " + unit_rule)
            << unit;
        EXPECT_EQ(code, "E0113");
    }
}

TEST_F(RefusedDeclaration, has_an_internal_range_that_fits_width_and_sign) {
    EXPECT_EQ(declare("number = 2990\nname = \"X\"\nkind = \"measurement\"\nwidth = 8\nsigned = false\n"
                      "internal = [0, 65535]\nexternal = [0, 100]"),
              "7:12 declaration-invalid: internal [0, 65535] does not fit 8 bits, unsigned\n");
    EXPECT_EQ(code, "E0113");
    EXPECT_FALSE(find(2990)->scaling);
    EXPECT_EQ(declare("number = 2990\nname = \"X\"\n" + word + "internal = [-1, 100]\nexternal = [0, 1]"),
              "7:12 declaration-invalid: internal [-1, 100] does not fit 16 bits, unsigned\n");
    EXPECT_FALSE(find(2990)->scaling);
}

TEST_F(RefusedDeclaration, has_limits_that_differ) {
    EXPECT_EQ(declare("number = 2990\nname = \"X\"\n" + word + "internal = [0, 9]\nexternal = [3, 3]"),
              "8:12 declaration-invalid: `external` does not ascend: 3 to 3\n");
    EXPECT_EQ(code, "E0113");
    EXPECT_EQ(declare("number = 2990\nname = \"X\"\n" + word +
                      "internal = [0, 9]\nexternal = [{ parameter = 999 }, { parameter = 999 }]"),
              "8:12 declaration-invalid: `external` has parameter 999 for both limits\n");
    EXPECT_EQ(declare("number = 2990\nname = \"X\"\n" + word + "internal = [7, 7]\nexternal = [0, 1]"),
              "7:12 declaration-invalid: internal [7, 7] is not a range of integers within -32768..65535\n");
    EXPECT_FALSE(find(2990)->scaling);
}

TEST_F(RefusedDeclaration, of_a_bit_has_no_external_range_either) {
    EXPECT_EQ(declare("number = 2990\nname = \"X\"\n" + bit + "external = [0, 1]"),
              "6:12 declaration-invalid: a bit has no external range\n");
}

TEST_F(RefusedDeclaration, of_a_known_form_is_not_judged_by_the_form_it_contradicts) {
    EXPECT_EQ(declare("number = 2350\nsigned = true"),
              "3:10 declaration-contradiction: `2350 FuelQuantity` has signed false already, not true\n");
    EXPECT_EQ(code, "E0114");
}

}  // namespace

// A misspelt cell is that finding only: it is not missing as well.
TEST_F(RefusedDeclaration, a_misspelt_cell_is_one_finding) {
    for (const std::string& cells :
         {"numbr = 2990\nname = \"Torque\"\n" + word, "number = 2990\nnam = \"Torque\"\n" + word,
          std::string(
              "number = 2990\nname = \"Torque\"\nkin = \"measurement\"\nwidth = 16\nsigned = false\n"),
          std::string(
              "number = 2990\nname = \"Torque\"\nkind = \"measurement\"\nwidht = 16\nsigned = false\n"),
          std::string(
              "number = 2990\nname = \"Torque\"\nkind = \"measurement\"\nwidth = 16\nsignd = false\n")}) {
        const std::string text = declare(cells);
        EXPECT_EQ(findings.all().size(), 1U) << cells << text;
        EXPECT_NE(text.find("unknown key"), std::string::npos) << text;
    }
}
