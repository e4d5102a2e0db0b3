// An image taken apart gives a file that compiles to the identical image.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "driver/decompile.hpp"
#include "driver/plant.hpp"
#include "image_writer/image_writer.hpp"
#include "properties/random_plant.hpp"
#include "support/image_bytes.hpp"

namespace cgw::test {
namespace {

constexpr std::uint32_t plants = 30;

base::Bytes image_of(const driver::CheckedFile& file, bool labels) {
    const auto plant = driver::Plant::make(file);
    const emit::Plant view = plant.value().view();
    return image_writer::write_image({.settings = view.settings,
                                      .configuration = view.configuration,
                                      .dictionary = view.dictionary,
                                      .configuration_id = view.configuration_id,
                                      .tool_version = view.tool_version,
                                      .labels = labels});
}

driver::DecompiledImage decompiled(const base::Bytes& bytes) {
    image::Image image;
    EXPECT_EQ(image::Image::open(bytes, image), image::Status::ok);
    return driver::decompile(image, "decompiled.toml");
}

std::string everything(const driver::DecompiledImage& made) {
    return fmt::format("differing: {}; lost: {}\n{}", fmt::join(made.differing, ", "),
                       fmt::join(made.lost, "; "), made.text);
}

void expect_round_trip(const base::Bytes& image) {
    const driver::DecompiledImage made = decompiled(image);
    ASSERT_TRUE(made.identical()) << everything(made);
    EXPECT_TRUE(made.exact && made.lost.empty() && !made.other_version) << everything(made);
    EXPECT_EQ(image_of(driver::check_text("again.toml", made.text), true), image);
}

TEST(Decompile, gives_files_that_compile_to_the_identical_image) {
    std::uint32_t valid = 0;
    for (std::uint32_t seed = 1; seed <= plants; ++seed) {
        const driver::CheckedFile file =
            driver::check_text("plant.toml", RandomPlant(seed, seed % 3 != 0).text(seed));
        if (file.valid()) {
            ++valid;
            ASSERT_NO_FATAL_FAILURE(expect_round_trip(image_of(file, true))) << "seed " << seed;
        }
    }
    EXPECT_GT(valid, plants / 4);
}

// What the gateway does is in the image, whatever else is left out.
TEST(Decompile, gives_files_that_work_alike_where_there_are_no_labels) {
    for (std::uint32_t seed = 1; seed <= plants; ++seed) {
        const driver::CheckedFile file = driver::check_text("plant.toml", RandomPlant(seed, true).text(seed));
        if (!file.valid()) {
            continue;
        }
        const driver::DecompiledImage made = decompiled(image_of(file, false));
        ASSERT_TRUE(made.works_alike()) << "seed " << seed << " " << everything(made);
        EXPECT_FALSE(made.lost.empty() || made.exact);
        EXPECT_NE(made.text.find("# - title, and names"), std::string::npos) << made.text;
        EXPECT_EQ(made.differing, std::vector<std::string>{"configuration id"}) << "seed " << seed;
        EXPECT_NE(made.text.find("of configuration " + made.new_id), std::string::npos) << made.text;
    }
}

TEST(Decompile, brings_the_samples_back) {
    for (const char* sample : {"genset.toml", "minimal.toml", "manual-example.toml"}) {
        const driver::CheckedFile file = driver::check_file(std::string(CGW_SAMPLES) + "/" + sample);
        ASSERT_TRUE(file.valid()) << sample;
        expect_round_trip(image_of(file, true));
        EXPECT_TRUE(decompiled(image_of(file, false)).works_alike()) << sample;
    }
}

constexpr const char* smallest = R"(format = 1
[governor.parameters]
401 = 1
403 = 1
416 = 250
4406 = 1
[gateway.parameters]
401 = 1
402 = 1
416 = 250
426 = 125
427 = 1
429 = 800
4400 = 1
)";

TEST(Decompile, keeps_titles_and_declarations_of_every_kind) {
    const driver::CheckedFile file = driver::check_text("plant.toml", R"(format = 1
title = "a \"quoted\" \\ and ü"
[governor]
main_cycle_us = 10000
[governor.parameters]
401 = 1
403 = 1
416 = 250
4406 = 1
400 = 0.125
980 = 0
981 = 12.5
16400 = [2990, 2991, 2992, 2905]
16460 = 100
811 = -3
4811 = 3
[gateway.parameters]
401 = 1
402 = 1
416 = 250
426 = 125
427 = 1
429 = 801
4400 = 1
[gateway]
identity = { software_version = 65535, serial_date = 9912, serial_number = 65535 }
[[governor.declare]]
number = 2990
name = "With-Marks_:./"
kind = "measurement"
unit = "m³"
width = 8
signed = true
internal = [-128, 127]
external = [{ parameter = 980 }, 1e-7]
[[governor.declare]]
number = 2991
name = "NoScaling"
kind = "measurement"
width = 16
signed = false
[[governor.declare]]
number = 2992
name = "InternalOnly"
kind = "measurement"
width = 16
signed = false
internal = [5, 100]
[[governor.declare]]
number = 2993
name = "ABit"
kind = "measurement"
bit = true
[[governor.declare]]
number = 812
name = "MySwitch"
kind = "switch"
[[governor.declare]]
number = 4929
name = "MySensorType"
kind = "sensor"
)");
    ASSERT_TRUE(file.valid()) << file.findings.all().front().message;
    expect_round_trip(image_of(file, true));
}

TEST(Decompile, says_which_rows_of_a_catalogue_file_are_lost_and_works_alike_without_them) {
    const driver::CheckedFile file = driver::check_file(CGW_TEST_DATA "/decompile/plant.toml");
    ASSERT_TRUE(file.valid()) << file.findings.all().front().message;
    const driver::DecompiledImage made = decompiled(image_of(file, true));
    EXPECT_EQ(
        made.lost,
        (std::vector<std::string>{
            "rows of a catalogue file, which no declaration can say: governor 820, governor 821, "
            "governor 830, governor 831, governor 5000, gateway 500, gateway 501",
            "names out of a catalogue file, which no declaration can say: 2990 Measured(0), 2991 Measured(1)",
            "values of parameters that only a catalogue file knows: governor 5000, gateway 500"}));
    EXPECT_TRUE(made.exact && made.works_alike() && !made.identical()) << everything(made);
    EXPECT_EQ(made.differing, (std::vector<std::string>{"configuration id", "labels", "strings", "model"}));
    for (const char* written : {"# - rows of a catalogue file",
                                "name = \"Single\"\nkind = \"measurement\"\nunit = \"kW\"\nwidth = 8\n",
                                "name = \"Measurement2990\"\n", "number = 16460\n\n"}) {
        EXPECT_NE(made.text.find(written), std::string::npos) << written << made.text;
    }
}

TEST(Decompile, says_when_another_version_wrote_the_image) {
    const base::Bytes image = image_of(driver::check_text("plant.toml", smallest), true);
    const driver::DecompiledImage made = decompiled(changed(image, image::header::tool_version, 2, 7));
    EXPECT_TRUE(made.identical() && made.other_version);
    EXPECT_NE(made.text.find("identical image but for the version of cgw"), std::string::npos) << made.text;
}

// A model of another plant beside the sections of this one: nobody can say which of the two is meant.
TEST(Decompile, does_not_believe_a_model_without_the_id) {
    const base::Bytes image = image_of(driver::check_text("plant.toml", smallest), true);
    const driver::DecompiledImage made = decompiled(changed(image, image::header::configuration_id, 1, 0));
    EXPECT_FALSE(made.exact);
}

}  // namespace
}  // namespace cgw::test
