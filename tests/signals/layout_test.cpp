// Layouts of the samples, as a whole and in their parts.
#include <gtest/gtest.h>

#include <sstream>

#include "base/utf8.hpp"
#include "driver/plant.hpp"
#include "signal_support.hpp"
#include "signals/layout.hpp"
#include "support/golden.hpp"

namespace cgw::signals {
namespace {

Sheet sheet_of(const std::string& sample) {
    const driver::CheckedFile file = driver::check_file(CGW_SAMPLES "/" + sample + ".toml");
    return {.title = file.settings.title,
            .configuration_id = driver::short_configuration_id(file.settings),
            .node_id = file.configuration.node_id,
            .frames = frames_of(file.settings, *file.catalogue, file.configuration)};
}

}  // namespace

TEST(Layout, of_the_samples_is_the_golden_one) {
    test::expect_golden("frames/genset.txt", render_layout_text(sheet_of("genset")));
    test::expect_golden("frames/genset.md", render_layout_markdown(sheet_of("genset")));
    test::expect_golden("frames/genset.json", render_layout_json(sheet_of("genset")));
    test::expect_golden("frames/manual-example.txt", render_layout_text(sheet_of("manual-example")));
}

TEST(Layout, fits_80_columns_whatever_the_names) {
    const std::string long_name(200, 'm');
    const parameter::Row named = test::make_row(2001, long_name);
    parameter::Row scaled =
        test::scaled_row(2002, "Größe der Öffnung am Abgasturbolader hinten links", -1, 1);
    scaled.unit = "‰";
    config::Configuration configuration = test::manual_configuration();
    test::tpdo(configuration, 4).mapping.clear();
    test::add_output(configuration, 4, named);
    test::add_output(configuration, 4, scaled);
    Sheet sheet{.title = "x", .configuration_id = "0123456789abcdef", .node_id = 1, .frames = {}};
    sheet.frames = test::frames_of(configuration);
    std::istringstream lines(render_layout_text(sheet));
    for (std::string line; std::getline(lines, line);) {
        if (line.find(long_name) == std::string::npos) {  // one word is never broken
            EXPECT_LE(base::width_of(line), 80U) << line;
        }
    }
}

TEST(Layout, breaks_long_names_where_words_begin) {
    const parameter::Row row = test::make_row(2906, "AmbientPressure");
    config::Configuration configuration = test::empty_configuration();
    test::add_output(configuration, 4, row);
    EXPECT_EQ(diagram_of(test::frames_of(configuration).front()),
              "byte   0       1\n"
              "bit    0..7    8..15\n"
              "      +---------------+\n"
              "      | Ambient       |\n"
              "      | Pressure      |\n"
              "      | 2001h:1       |\n"
              "      +---------------+\n");
}

TEST(Layout, works_a_value_out_both_ways) {
    parameter::Row row = test::scaled_row(2000, "Speed", 0, 4000);
    row.unit = "1/min";
    const Example example = example_of(test::signal_of(row));
    EXPECT_EQ(example.asked, "3000 1/min");
    EXPECT_EQ(example.raw, 49151);
    EXPECT_EQ(example.bytes, "FF BF");
    EXPECT_EQ(example.shown, "2999.98 1/min");
    EXPECT_EQ(example_of(test::signal_of(test::make_row(2001, "Raw"))).asked, "49151 raw");
}

}  // namespace cgw::signals
