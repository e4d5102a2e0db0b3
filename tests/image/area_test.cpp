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

TEST(StatedImage, is_none_where_no_image_begins_or_it_is_cut) {
    const base::Bytes bytes = SamplePlant().image();
    EXPECT_EQ(image::stated_image(bytes).size(), bytes.size());
    EXPECT_TRUE(image::stated_image({}).empty());
    EXPECT_TRUE(image::stated_image(std::span(bytes).first(bytes.size() - 1)).empty());
    EXPECT_TRUE(image::stated_image(base::Bytes(8192, 0xFF)).empty());
    for (const std::uint64_t size :
         {std::uint64_t{0}, std::uint64_t{67}, std::uint64_t{65537}, std::uint64_t{0xFFFFFFFF}}) {
        base::Bytes area = changed(bytes, image::header::total_size, 4, size);
        area.resize(100'000);
        EXPECT_TRUE(image::stated_image(area).empty()) << size;
    }
    EXPECT_TRUE(image::stated_image(changed(bytes, image::header::header_size, 2, 63)).empty());
}

image::Status opened(const base::Bytes& area) {
    image::Image image;
    return image::Image::open(image::image_in(area), image);
}

TEST(ImageInArea, is_none_in_an_erased_area) {
    for (const std::uint8_t erased : {std::uint8_t{0x00}, std::uint8_t{0xFF}}) {
        base::Bytes area(8192, erased);
        EXPECT_TRUE(image::image_in(area).empty());
        EXPECT_EQ(opened(area), image::Status::too_small);
        area.back() ^= 0x10;
        EXPECT_EQ(opened(area), image::Status::bad_magic);
    }
    EXPECT_TRUE(image::image_in({}).empty());
}

TEST(ImageInArea, is_refused_as_damaged_and_not_as_missing_when_its_beginning_is) {
    using image::Status;
    struct Damage {
        std::size_t at;
        std::size_t width;
        std::uint64_t value;
        Status status;
    };
    const base::Bytes bytes = SamplePlant().image();
    constexpr Damage damages[] = {
        {image::header::magic, 1, 'c', Status::bad_magic},
        {image::header::magic, 4, 0xFFFFFFFF, Status::bad_magic},
        {image::header::total_size, 4, 0, Status::size_mismatch},
        {image::header::total_size, 4, 67, Status::size_mismatch},
        {image::header::total_size, 4, 65537, Status::size_mismatch},
        {image::header::total_size, 4, 0xFFFFFFFF, Status::size_mismatch},
        {image::header::header_size, 2, 63, Status::bad_header_size},
        {image::header::header_size, 2, 0xFFFC, Status::bad_header_size},
    };
    for (const Damage& damage : damages) {
        base::Bytes area = changed(bytes, damage.at, damage.width, damage.value);
        for (const std::size_t room : {std::size_t{16384}, std::size_t{100'000}}) {
            area.resize(room, 0xFF);
            EXPECT_EQ(opened(area), damage.status) << damage.at << ' ' << damage.value << ' ' << room;
        }
    }
    EXPECT_EQ(opened({bytes.begin(), bytes.end() - 1}), Status::size_mismatch);
}

}  // namespace
}  // namespace cgw::test
