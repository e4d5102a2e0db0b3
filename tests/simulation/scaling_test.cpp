#include "simulation/scaling.hpp"

#include "support/sample_plant.hpp"

namespace cgw::simulation {
namespace {

TEST(Scaling, converts_both_ways) {
    const Scale scale{0, 65535, -100, 1000, false};
    EXPECT_DOUBLE_EQ(scale.to_engineering(0), -100);
    EXPECT_DOUBLE_EQ(scale.to_engineering(65535), 1000);
    EXPECT_EQ(scale.to_word(-100), 0U);
    EXPECT_EQ(scale.to_word(1000), 65535U);
    EXPECT_NEAR(scale.to_engineering(scale.to_word(82.5)), 82.5, 0.01);
}

TEST(Scaling, applies_the_sign_of_the_word) {
    const Scale scale{-32768, 32767, -100, 100, true};
    EXPECT_EQ(scale.to_word(-100), 0x8000U);
    EXPECT_DOUBLE_EQ(scale.to_engineering(0x8000), -100);
    EXPECT_LT(scale.to_engineering(0xFFFF), 0);
    EXPECT_GT(scale.to_engineering(0x0001), 0);
}

TEST(Scaling, stops_at_the_ends_of_the_range) {
    const Scale scale{100, 200, 0, 10, false};
    EXPECT_EQ(scale.to_word(-5), 100U);
    EXPECT_EQ(scale.to_word(50), 200U);
}

TEST(Scaling, survives_an_empty_external_range) {
    EXPECT_EQ((Scale{10, 20, 3, 3, false}).to_word(3), 10U);
}

TEST(Scaling, takes_ranges_from_signal_and_label) {
    const test::SamplePlant plant;
    const base::Bytes bytes = plant.image();
    image::Image image;
    ASSERT_EQ(image::Image::open(bytes, image), image::Status::ok);
    const Scale speed = scale_of(image, 2000, 0, 1);
    EXPECT_EQ(speed.internal_maximum, 64000);
    EXPECT_DOUBLE_EQ(speed.external_maximum, 4000);
}

TEST(Scaling, takes_the_given_range_without_a_label) {
    const test::SamplePlant plant;
    const base::Bytes bytes = plant.image(false);
    image::Image image;
    ASSERT_EQ(image::Image::open(bytes, image), image::Status::ok);
    const Scale speed = scale_of(image, 2000, -1, 1);
    EXPECT_EQ(speed.internal_maximum, 64000);
    EXPECT_DOUBLE_EQ(speed.external_minimum, -1);
    EXPECT_DOUBLE_EQ(speed.external_maximum, 1);
}

}  // namespace
}  // namespace cgw::simulation
