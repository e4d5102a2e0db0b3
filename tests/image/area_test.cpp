#include "image/area.hpp"

#include <gtest/gtest.h>

#include "support/image_bytes.hpp"
#include "support/sample_plant.hpp"

namespace cgw::test {
namespace {

TEST(ImageInArea, has_the_size_that_the_image_states) {
    const base::Bytes bytes = SamplePlant().image();
    base::Bytes area = bytes;
    EXPECT_EQ(image::image_in(area).size(), bytes.size());
    area.resize(bytes.size() + 1000, 0xFF);
    const std::span<const std::uint8_t> found = image::image_in(area);
    ASSERT_EQ(found.size(), bytes.size());
    image::Image image;
    EXPECT_EQ(image::Image::open(found, image), image::Status::ok);
}

TEST(ImageInArea, is_none_where_no_image_begins_or_it_is_cut) {
    const base::Bytes bytes = SamplePlant().image();
    EXPECT_TRUE(image::image_in({}).empty());
    EXPECT_TRUE(image::image_in(std::span(bytes).first(bytes.size() - 1)).empty());
    EXPECT_TRUE(image::image_in(base::Bytes(8192, 0xFF)).empty());
    for (const std::uint64_t size :
         {std::uint64_t{0}, std::uint64_t{67}, std::uint64_t{65537}, std::uint64_t{0xFFFFFFFF}}) {
        base::Bytes area = changed(bytes, image::header::total_size, 4, size);
        area.resize(100'000);
        EXPECT_TRUE(image::image_in(area).empty()) << size;
    }
    EXPECT_TRUE(image::image_in(changed(bytes, image::header::header_size, 2, 63)).empty());
}

}  // namespace
}  // namespace cgw::test
