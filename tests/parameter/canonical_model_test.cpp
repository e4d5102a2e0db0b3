#include "parameter/canonical_model.hpp"

#include <gtest/gtest.h>

#include <deque>

namespace cgw::parameter {
namespace {

// The smallest text there is.
const std::string head = "cgw-configuration 1\ntitle \"\"\nidentity 0 0 0\nmain-cycle-us 15625\n";

// That text with this line in the place of its kind, or at the end.
std::string text_with(const std::string& line) {
    const std::string kind = "\n" + line.substr(0, line.find(' ')) + " ";
    const std::size_t at = head.find(kind);
    if (at == std::string::npos) {
        return head + line + "\n";
    }
    std::string text = head;
    return text.replace(at + 1, text.find('\n', at + 1) - at - 1, line);
}

// The model as settings, whose text is the one it was read from.
std::string text_of(const CanonicalModel& model) {
    std::deque<Row> rows;
    Settings settings;
    settings.title = model.title;
    settings.identity = model.identity;
    settings.main_cycle_us = model.main_cycle_us;
    for (const CanonicalRow& row : model.rows) {
        settings.declarations.push_back(&rows.emplace_back(row.row()));
    }
    for (const CanonicalValue& value : model.values) {
        const Row& row = rows.emplace_back(Row{.device = value.device, .number = value.number});
        (value.device == Device::governor ? settings.governor : settings.gateway)
            .assign({.row = &row, .value = value.value});
    }
    return canonical_text(settings);
}

void expect_round_trip(const std::string& text) {
    const std::optional<CanonicalModel> model = read_canonical_text(text);
    ASSERT_TRUE(model) << text;
    EXPECT_EQ(text_of(*model), text);
}

TEST(CanonicalModel, is_read_back_with_all_that_the_text_says) {
    const std::string text =
        "cgw-configuration 1\n"
        "title \"Genset \\\"2\\\" \\\\ m³\\u0001\\t\"\n"
        "identity 65535 9912 4294967295\n"
        "main-cycle-us 15625\n"
        "row governor 812 \"FunctDroop\" parameter switch\n"
        "row governor 2990 \"TorqueActual\" measurement 16 signed \"%\" "
        "-32768..32767 -100..100.5\n"
        "row gateway 4811 \"\" function switch-type\n"
        "governor 400 0.5\n"
        "governor 65535 -1e+20\n"
        "gateway 16404 642\n";
    const std::optional<CanonicalModel> model = read_canonical_text(text);
    ASSERT_TRUE(model);
    EXPECT_EQ(model->title, "Genset \"2\" \\ m³\x01\t");
    EXPECT_EQ(model->identity.software_version, 65535U);
    EXPECT_EQ(model->identity.serial_date, 9912U);
    EXPECT_EQ(model->identity.serial_number, 4294967295U);
    EXPECT_EQ(model->main_cycle_us, 15625U);
    ASSERT_EQ(model->rows.size(), 3U);
    EXPECT_EQ(model->rows[0].role, Role::switch_assignment);
    const CanonicalRow& torque = model->rows[1];
    EXPECT_EQ(torque.device, Device::governor);
    EXPECT_EQ(torque.number, 2990);
    EXPECT_EQ(torque.name, "TorqueActual");
    EXPECT_EQ(torque.list, List::measurement);
    EXPECT_EQ(torque.width, 16);
    EXPECT_TRUE(torque.is_signed);
    EXPECT_EQ(torque.unit, "%");
    ASSERT_TRUE(torque.scaling);
    EXPECT_EQ(torque.scaling->internal_minimum, -32768);
    EXPECT_EQ(torque.scaling->external_maximum, 100.5);
    EXPECT_EQ(model->rows[2].device, Device::gateway);
    EXPECT_EQ(model->rows[2].list, List::function);
    EXPECT_EQ(model->rows[2].role, Role::switch_type);
    ASSERT_EQ(model->values.size(), 3U);
    EXPECT_EQ(model->values[1].number, 65535);
    EXPECT_EQ(model->values[1].value, -1e20);
    EXPECT_EQ(model->values[2].device, Device::gateway);
    EXPECT_EQ(text_of(*model), text);
}

TEST(CanonicalModel, of_nothing_is_read_back) {
    EXPECT_EQ(canonical_text(Settings{}), head);
    const std::optional<CanonicalModel> model = read_canonical_text(head);
    ASSERT_TRUE(model);
    EXPECT_TRUE(model->title.empty() && model->rows.empty() && model->values.empty());
    expect_round_trip(head);
}

TEST(CanonicalModel, gives_the_same_text_whatever_a_row_holds) {
    for (const char* row : {
             "governor 900 \"Se\" parameter sensor",
             "governor 4900 \"Se\" function sensor-type",
             "governor 4811 \"Sw\" function switch-type",
             "governor 500 \"Plain\" parameter",
             "governor 6000 \"Curve(0)\" curve",
             "gateway 2990 \"Foo\" measurement 0 unsigned \"\"",
             "governor 2990 \"Foo\" measurement 1 unsigned \"\"",
             "governor 2990 \"Foo\" measurement 8 signed \"1/min\" 0..0 @980..@981",
             "governor 2990 \"Foo\" measurement 16 unsigned \"V\" -2147483648..2147483647 ?..1e-07",
             "governor 2990 \"Foo\" measurement 16 unsigned \"V\" 0..100 -0.5..?",
         }) {
        expect_round_trip(text_with(std::string("row ") + row));
    }
}

TEST(CanonicalModel, keeps_ends_that_are_parameters_or_blank) {
    const auto model = read_canonical_text(
        text_with("row governor 2918 \"P\" measurement 16 unsigned \"kW\" 0..65535 @992..?"));
    ASSERT_TRUE(model);
    const Scaling& scaling = model->rows.front().scaling.value();
    EXPECT_EQ(scaling.external_minimum_parameter, 992);
    EXPECT_EQ(scaling.external_maximum_parameter, 0);
    EXPECT_FALSE(scaling.external_minimum);
    EXPECT_FALSE(scaling.external_maximum);
}

TEST(CanonicalModel, refuses_another_version_and_a_text_that_is_cut) {
    EXPECT_FALSE(read_canonical_text(""));
    EXPECT_FALSE(read_canonical_text("cgw-configuration 1"));
    EXPECT_FALSE(read_canonical_text("cgw-configuration 2\n"));
    EXPECT_FALSE(read_canonical_text("title \"x\"\n"));
    EXPECT_FALSE(read_canonical_text(head + "cgw-configuration 2\n"));
    const std::string text = text_with("governor 401 1");
    ASSERT_TRUE(read_canonical_text(text));
    for (std::size_t size = 0; size < text.size(); ++size) {
        EXPECT_EQ(read_canonical_text(text.substr(0, size)).has_value(), size == head.size()) << size;
    }
}

// Such a text would have another SHA-256 when cgw wrote it again.
TEST(CanonicalModel, is_refused_when_it_is_not_as_cgw_writes_it) {
    const std::string text = head +
                             "row governor 812 \"FunctDroop\" parameter switch\n"
                             "row governor 2990 \"TorqueActual\" measurement 16 signed \"%\" 0..1 @980..?\n"
                             "governor 400 0.5\n"
                             "governor 401 1\n";
    expect_round_trip(text);
    for (const auto& [old, with] : std::vector<std::pair<std::string, std::string>>{
             {"governor 401 1\n", "governor 401 1\ngovernor 401 2\n"},
             {"governor 401 1\n", "governor 401 1\ngovernor 401 1\n"},
             {"governor 401 1\n", "governor 401 0\n"},
             {"governor 401 1\n", "governor 401 1.0\n"},
             {"governor 401 1\n", "governor 0401 1\n"},
             {"governor 400 0.5\ngovernor 401 1\n", "governor 401 1\ngovernor 400 0.5\n"},
             {"identity 0 0 0\n", ""},
             {"identity 0 0 0\n", "identity 0 0 0\nidentity 0 0 0\n"},
             {"\"FunctDroop\"", "\"Funct\\u0044roop\""},
             {"@980", "@0980"}}) {
        std::string changed = text;
        EXPECT_FALSE(read_canonical_text(changed.replace(changed.find(old), old.size(), with))) << with;
    }
    EXPECT_FALSE(read_canonical_text(text + "\n"));
}

TEST(CanonicalModel, refuses_lines_that_have_another_form) {
    for (const char* line : {
             "",
             " ",
             "colour red",
             "governor",
             "governor 401",
             "governor 401 ",
             "governor 401 1 ",
             "governor 401 1 2",
             "governor  401 1",
             " governor 401 1",
             "governor 0 1",
             "governor 65536 1",
             "governor x 1",
             "governor 401 x",
             "governor 401 inf",
             "governor 401 nan",
             "governor 401 1e400",
             "gateway -401 1",
             "Governor 401 1",
             "main-cycle-us",
             "main-cycle-us -1",
             "main-cycle-us 4294967296",
             "main-cycle-us 1.5",
             "main-cycle-us 1 ",
             "identity 1 2",
             "identity 1 2 3 4",
             "identity 1 2 -3",
             "identity 4294967296 2 3",
             "identity 1 x 3",
         }) {
        EXPECT_FALSE(read_canonical_text(text_with(line))) << line;
    }
}

TEST(CanonicalModel, refuses_texts_that_are_no_strings) {
    for (const char* title : {
             "",
             "x",
             "\"x",
             "x\"",
             "\"",
             "\"x\"y",
             "\"x\" ",
             "\"x\" y",
             "\"\\\"",
             "\"\\x41\"",
             "\"\\u00\"",
             "\"\\u0\"",
             "\"\\u00zz\"",
             "\"\\u0080\"",
             "\"\\u-001\"",
             "\"\\",
             "\"\xC3\"",
             "\"\xFF\"",
             "\"\xED\xA0\x80\"",
         }) {
        EXPECT_FALSE(read_canonical_text(text_with(std::string("title ") + title))) << title;
    }
    std::string bare = head;
    EXPECT_FALSE(read_canonical_text(bare.replace(bare.find("title \"\""), 8, "title")));
}

TEST(CanonicalModel, refuses_rows_that_have_another_form) {
    for (const char* row : {
             "",
             "governor",
             "engine 2990 \"T\" parameter",
             "governor 0 \"T\" parameter",
             "governor 65536 \"T\" parameter",
             "governor 2990 T parameter",
             "governor 2990 \"T\"",
             "governor 2990 \"T\" list",
             "governor 2990 \"T\" parameter knob",
             "governor 2990 \"T\" parameter switch switch",
             "governor 2990 \"T\" parameter ",
             "governor 2990 \"T\" measurement",
             "governor 2990 \"T\" measurement 17 signed \"%\"",
             "governor 2990 \"T\" measurement -1 signed \"%\"",
             "governor 2990 \"T\" measurement 16 maybe \"%\"",
             "governor 2990 \"T\" measurement 16 signed",
             "governor 2990 \"T\" measurement 16 signed %",
             "governor 2990 \"T\" measurement 16 signed \"%\" 0..1",
             "governor 2990 \"T\" measurement 16 signed \"%\" 0..1 0..1 0",
             "governor 2990 \"T\" measurement 16 signed \"%\" 0-1 0..1",
             "governor 2990 \"T\" measurement 16 signed \"%\" 0..1 01",
             "governor 2990 \"T\" measurement 16 signed \"%\" 0.5..1 0..1",
             "governor 2990 \"T\" measurement 16 signed \"%\" ..1 0..1",
             "governor 2990 \"T\" measurement 16 signed \"%\" -2147483649..1 0..1",
             "governor 2990 \"T\" measurement 16 signed \"%\" 0..2147483648 0..1",
             "governor 2990 \"T\" measurement 16 signed \"%\" 0..1 x..1",
             "governor 2990 \"T\" measurement 16 signed \"%\" 0..1 0..",
             "governor 2990 \"T\" measurement 16 signed \"%\" 0..1 @0..1",
             "governor 2990 \"T\" measurement 16 signed \"%\" 0..1 @x..1",
             "governor 2990 \"T\" measurement 16 signed \"%\" 0..1 0..@65536",
             "governor 2990 \"T\" measurement 16 signed \"%\" 0..1 ??..1",
         }) {
        EXPECT_FALSE(read_canonical_text(text_with(std::string("row ") + row))) << row;
    }
}

}  // namespace
}  // namespace cgw::parameter
