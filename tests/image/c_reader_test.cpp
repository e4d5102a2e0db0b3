// The plain-C reader against the C++ one: every value of good images, and its verdict about all kinds of bad
// ones.
#include <gtest/gtest.h>

#include <random>
#include <string_view>

#include "c_reader.h"
#include "driver/check_file.hpp"
#include "driver/plant.hpp"
#include "emit/emitter.hpp"
#include "image/area.hpp"
#include "support/image_values.hpp"
#include "support/later_image.hpp"
#include "support/sample_plant.hpp"

namespace cgw::test {
namespace {

using image::Status;

base::Bytes image_of(const std::string& path, bool labels) {
    const driver::CheckedFile file = driver::check_file(path);
    EXPECT_TRUE(file.valid()) << path;
    emit::Options options;
    options.labels = labels;
    return emit::find_emitter("image")->emit(driver::Plant::make(file).value().view(), options);
}

// One image after the other, with and without labels.
const std::vector<base::Bytes>& good_images() {
    static const std::vector<base::Bytes> images = [] {
        std::vector<base::Bytes> made;
        for (const std::string& path :
             {std::string(CGW_SAMPLES "/genset.toml"), std::string(CGW_SAMPLES "/minimal.toml"),
              std::string(CGW_SAMPLES "/manual-example.toml"), std::string(CGW_TEST_DATA "/full.toml")}) {
            made.push_back(image_of(path, true));
            made.push_back(image_of(path, false));
        }
        made.push_back(SamplePlant().image());
        return made;
    }();
    return images;
}

void append(void* to, std::uint64_t value) {
    static_cast<Numbers*>(to)->push_back(value);
}

// From a copy that ends where the image ends, so that AddressSanitizer sees what is read behind it.
Status c_status(const base::Bytes& bytes, Numbers* values = nullptr) {
    const base::Bytes exact(bytes.begin(), bytes.end());
    Numbers unused;
    return static_cast<Status>(
        c_reader_dump(exact.data(), exact.size(), append, values == nullptr ? &unused : values));
}

Numbers values_of(const base::Bytes& bytes) {
    image::Image image;
    EXPECT_EQ(image::Image::open(bytes, image), Status::ok);
    return test::values_of(image);
}

// Up to code 9 both say the same. Above it, C knows only values and texts that lie outside.
void expect_agreement(const base::Bytes& bytes, const std::string& what) {
    const Status cpp = open(bytes);
    const Status c = c_status(bytes);
    if (cpp <= Status::section_missing) {
        ASSERT_EQ(c, cpp) << what;
    } else {
        ASSERT_TRUE(c == Status::ok || c == Status::bad_object_table || c == Status::bad_label)
            << what << ": " << static_cast<int>(c) << ", C++ " << static_cast<int>(cpp);
    }
}

TEST(ImageInC, reads_every_value_as_the_cpp_reader_does) {
    for (const base::Bytes& bytes : good_images()) {
        Numbers values;
        ASSERT_EQ(c_status(bytes, &values), Status::ok);
        EXPECT_EQ(values, values_of(bytes));
        EXPECT_GT(values.size(), 500U);
    }
}

TEST(ImageInC, finds_objects_signals_and_labels_by_number) {
    for (const base::Bytes& bytes : good_images()) {
        EXPECT_EQ(c_reader_finds(bytes.data(), bytes.size()), 1);
    }
}

// A boot loader sees regions, not files.
TEST(ImageInC, sees_as_much_of_a_region_as_the_firmware_does) {
    const base::Bytes good = SamplePlant().image(false);
    std::vector<base::Bytes> regions = {{},
                                        base::Bytes(8192, 0xFF),
                                        base::Bytes(8192, 0x00),
                                        base::Bytes(100'000, 0xFF),
                                        base::Bytes(100'000, 0x33)};
    regions.back()[0] = 'C';
    for (const std::size_t size : {good.size() - 1, good.size(), good.size() + 1, std::size_t{100'000}}) {
        for (std::size_t at = 0; at < image::header::size; ++at) {
            for (const unsigned change : {0U, 1U, 0x80U, 0xFFU}) {
                base::Bytes region = good;
                region[at] = static_cast<std::uint8_t>(region[at] ^ change);
                region.resize(size, 0xFF);
                regions.push_back(region);
            }
        }
    }
    for (const base::Bytes& region : regions) {
        ASSERT_EQ(c_reader_in(region.data(), region.size()), image::image_in(region).size());
        const auto c = static_cast<Status>(c_reader_open_region(region.data(), region.size()));
        ASSERT_EQ(c, open(base::Bytes(image::image_in(region).begin(), image::image_in(region).end())));
    }
}

TEST(ImageInC, opens_an_embedded_image_and_knows_an_erased_region) {
    base::Bytes region = SamplePlant().image(false);
    region.resize(8192, 0xFF);
    EXPECT_EQ(c_reader_open_region(region.data(), region.size()), 0U);
    const base::Bytes erased(8192, 0xFF);
    EXPECT_EQ(c_reader_open_region(erased.data(), erased.size()), 1U);
}

TEST(ImageInC, refuses_an_image_that_was_cut_off_anywhere) {
    for (const base::Bytes& bytes : {good_images().front(), SamplePlant().image(false)}) {
        for (std::size_t size = 0; size < bytes.size(); ++size) {
            const base::Bytes cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
            ASSERT_NE(c_status(cut), Status::ok) << size;
            expect_agreement(cut, std::to_string(size));
        }
    }
    expect_agreement(base::Bytes(image::maximum_size + 1), "too large");
}

TEST(ImageInC, refuses_every_flipped_bit) {
    base::Bytes bytes = SamplePlant().image();
    for (std::size_t at = 0; at < bytes.size(); ++at) {
        const auto bit = static_cast<std::uint8_t>(1U << (at % 8));
        bytes[at] ^= bit;
        ASSERT_NE(c_status(bytes), Status::ok) << at;
        expect_agreement(bytes, std::to_string(at));
        bytes[at] ^= bit;
    }
}

// With a right CRC the damage is seen by what comes after it.
TEST(ImageInC, agrees_about_every_changed_byte_with_a_right_crc) {
    const base::Bytes good = SamplePlant().image();
    for (std::size_t at = 0; at < good.size() - image::crc_size; ++at) {
        for (const unsigned change : {1U << (at % 8), 0xFFU}) {
            expect_agreement(changed(good, at, 1, good[at] ^ change), std::to_string(at));
        }
    }
}

TEST(ImageInC, agrees_about_random_changes_with_a_right_crc) {
    std::mt19937 random(20260301);  // the same each time
    const base::Bytes good = SamplePlant().image();
    for (unsigned round = 0; round < 3000; ++round) {
        base::Bytes bytes = good;
        // Mostly in header and directory; half of the images claim to be of a later minor.
        for (unsigned i = random() % 4; i < 5; ++i) {
            bytes[random() % (i == 4 ? bytes.size() - image::crc_size : 208U)] =
                static_cast<std::uint8_t>(random());
        }
        wire::store_u32(&bytes[0], wire::load_u32(image::magic));
        wire::store_u16(&bytes[image::header::format_major], image::format_major);
        wire::store_u16(&bytes[image::header::format_minor], static_cast<std::uint16_t>(round % 2));
        wire::store_u16(&bytes[image::header::header_size], image::header::size);
        wire::store_u32(&bytes[image::header::total_size], static_cast<std::uint32_t>(bytes.size()));
        if (round % 4 < 2) {
            wire::store_u16(&bytes[image::header::section_count], 12);
        }
        sign(bytes);
        expect_agreement(bytes, "round " + std::to_string(round));
    }
}

TEST(ImageInC, reads_what_a_later_minor_lengthened) {
    const base::Bytes good = SamplePlant().image();
    std::vector<Part> parts = parts_of(good);
    for (Part& part : parts) {
        if (is_records(part)) {
            lengthen(part, 4);
        }
    }
    parts.push_back({image::section_ids, 6, base::Bytes(18, 0xEE)});
    const base::Bytes later = join(good, parts, 1, 80);
    Numbers values;
    ASSERT_EQ(c_status(later, &values), Status::ok);
    EXPECT_EQ(values, values_of(later));
    EXPECT_EQ(c_reader_finds(later.data(), later.size()), 1);
    EXPECT_EQ(c_status(join(good, parts, 0, image::header::size)), Status::bad_directory);
    parts.erase(parts.begin() + 10);
    EXPECT_EQ(c_status(join(good, parts, 1, 80)), Status::section_missing);  // strings without labels
}

TEST(ImageInC, agrees_about_bytes_that_are_no_image) {
    std::mt19937 random(407);
    for (unsigned round = 0; round < 2000; ++round) {
        base::Bytes bytes(random() % 300);
        for (std::uint8_t& byte : bytes) {
            byte = static_cast<std::uint8_t>(random());
        }
        expect_agreement(bytes, "round " + std::to_string(round));
    }
}

TEST(ImageInC, agrees_about_every_missing_section) {
    const base::Bytes good = SamplePlant().image();
    const std::vector<Part> parts = parts_of(good);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        std::vector<Part> rest = parts;
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
        expect_agreement(join(good, rest, 0, image::header::size),
                         "without section " + std::to_string(i + 1));
    }
}

TEST(ImageInC, refuses_what_stands_between_the_last_section_and_the_crc) {
    base::Bytes bytes = SamplePlant().image();
    bytes.insert(bytes.end() - image::crc_size, 4, 0);
    bytes = changed(bytes, image::header::total_size, 4, bytes.size());
    EXPECT_EQ(open(bytes), Status::bad_directory);
    EXPECT_EQ(c_status(bytes), Status::bad_directory);
}

// What it claims above code 9: nothing that lies outside, not even its last byte.
TEST(ImageInC, refuses_values_and_texts_that_lie_outside) {
    const base::Bytes good = SamplePlant().image();
    image::Image image;
    ASSERT_EQ(image::Image::open(good, image), Status::ok);
    const std::size_t object = offset_of(good, image::SectionId::objects);
    const std::size_t behind = image.initial_values().size() - image.objects().entry(0).length + 1;
    EXPECT_EQ(c_status(changed(good, object + CGW_IMAGE_OBJECT_OFFSET, 2, behind)), Status::bad_object_table);
    EXPECT_EQ(c_status(changed(good, object + CGW_IMAGE_OBJECT_OFFSET, 2, behind - 1)), Status::ok);
    EXPECT_EQ(c_status(changed(good, object + CGW_IMAGE_OBJECT_OFFSET, 2, 0xFFFF)), Status::bad_object_table);
    EXPECT_EQ(c_status(changed(good, object + CGW_IMAGE_OBJECT_TYPE, 1, 8)), Status::bad_object_table);

    const std::size_t label = offset_of(good, image::SectionId::labels);
    const std::size_t strings = size_of(good, image::SectionId::strings);
    const std::size_t name = strings - image.label(0).name.size() + 1;
    EXPECT_EQ(c_status(changed(good, label + image::label::name_offset, 4, name)), Status::bad_label);
    EXPECT_EQ(c_status(changed(good, label + image::label::name_offset, 4, name - 1)), Status::ok);
    for (const std::size_t offset : {image::label::name_offset, image::label::unit_offset}) {
        EXPECT_EQ(c_status(changed(good, label + offset, 4, 0xFFFF'FFFF)), Status::bad_label);
        EXPECT_EQ(c_status(changed(good, label + offset, 4, strings + 1)), Status::bad_label);
    }
}

}  // namespace
}  // namespace cgw::test
