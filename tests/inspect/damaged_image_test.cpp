// Damaged images: told as far as sense can be made, marked where they break, never a crash.
#include <gtest/gtest.h>

#include <random>

#include "inspect/annotation.hpp"
#include "inspect/sample_images.hpp"
#include "support/image_bytes.hpp"

namespace cgw::inspect {
namespace {

// "buses 2 of 2: CAN2 own_node: must be 1..127", one line for each thing that is wrong.
std::vector<std::string> wrongs(const Annotation& annotation) {
    std::vector<std::string> lines;
    for (const Group& group : annotation.groups) {
        if (!group.wrong.empty()) {
            lines.push_back(group.title + ": " + group.wrong);
        }
        for (const Item& item : group.items) {
            if (!item.wrong.empty()) {
                lines.push_back(group.title + " " + item.name + ": " + item.wrong);
            }
        }
    }
    return lines;
}

using Lines = std::vector<std::string>;

// Exactly once, in order, no byte left out; refused images say where.
void expect_told(const base::Bytes& bytes, const Annotation& annotation) {
    std::size_t next = 0;
    for (const Group& group : annotation.groups) {
        for (const Item& item : group.items) {
            ASSERT_EQ(item.offset, next) << group.title << " " << item.name;
            next += item.size;
        }
    }
    ASSERT_EQ(next, bytes.size());
    ASSERT_EQ(annotation.status, test::open(bytes));
    ASSERT_EQ(annotation.status == image::Status::ok && annotation.model_fits, wrongs(annotation).empty());
    ASSERT_FALSE(annotation_text(annotation, bytes, "x").empty());
}

base::Bytes sample() {
    return test::image_by_hand();
}

TEST(DamagedImage, is_told_after_every_truncation) {
    const base::Bytes image = sample();
    for (std::size_t size = 0; size < image.size(); size += size < 230 ? 3 : 97) {
        const base::Bytes shorter(image.begin(), image.begin() + static_cast<std::ptrdiff_t>(size));
        ASSERT_NO_FATAL_FAILURE(expect_told(shorter, annotate(shorter))) << size;
    }
}

TEST(DamagedImage, is_told_after_bit_flips_with_wrong_and_right_crc) {
    const base::Bytes image = sample();
    for (std::size_t bit = 0; bit < 8 * image.size(); bit += 499) {
        base::Bytes flipped = image;
        flipped[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
        ASSERT_NO_FATAL_FAILURE(expect_told(flipped, annotate(flipped))) << bit;
        test::sign(flipped);
        ASSERT_NO_FATAL_FAILURE(expect_told(flipped, annotate(flipped))) << bit << " signed";
    }
}

TEST(DamagedImage, is_told_when_it_is_noise_behind_a_header) {
    std::mt19937 engine(7);
    for (int round = 0; round < 20; ++round) {
        base::Bytes bytes = sample();
        const std::size_t from = 8 + engine() % 300;
        for (std::size_t i = from; i < bytes.size(); ++i) {
            bytes[i] = static_cast<std::uint8_t>(engine());
        }
        if (round % 2 == 0) {
            wire::store_u32(&bytes[12], static_cast<std::uint32_t>(bytes.size()));
            test::sign(bytes);
        }
        ASSERT_NO_FATAL_FAILURE(expect_told(bytes, annotate(bytes))) << round;
    }
}

TEST(DamagedImage, is_marked_at_the_field_that_no_image_has_so) {
    const base::Bytes image = sample();
    const std::size_t buses = test::offset_of(image, image::SectionId::buses);
    const std::size_t pdos = test::offset_of(image, image::SectionId::pdos);
    const std::size_t objects = test::offset_of(image, image::SectionId::objects);
    const std::size_t labels = test::offset_of(image, image::SectionId::labels);
    const struct {
        std::size_t at, width;
        std::uint32_t value;
        const char* wrong;
    } damages[] = {
        {buses + 16, 1, 200, "buses 2 of 2: CAN2 own_node: must be 1..127"},
        {buses + 4, 2, 251, "buses 1 of 2: CAN1 bit_rate_kbit: must be 0, 125, 250, 500 or 1000"},
        {buses + 2, 1, 7, "buses 1 of 2: CAN1 manual_timing: must be 0 or 1"},
        {buses + 3, 1, 1, "buses 1 of 2: CAN1 reserved: reserved: must be 0"},
        {pdos + 1, 1, 3, "pdos 1 of 20: TPDO1 number: must be 1"},
        {pdos + 3 * 40 + 16, 4, 0x20090110, "pdos 4 of 20: TPDO4 mapping[0]: there is no such object"},
        {objects + 8 + 2, 1, 0, ""},  // 1001h:0 is what it was
        {objects + 8, 2, 0x1000, "objects 2 of 37: 1000h:0 index: objects must ascend, each once"},
        {objects + 6, 2, 4, "objects 1 of 37: 1000h:0 offset: must be 0"},
        {labels + 4, 4, 60000,
         "labels 1 of 8: title name_offset: the text ends behind the 120 bytes of `strings`"},
        {54, 1, 1, "header reserved: reserved: must be 0"},
        {64 + 4, 4, 212, "directory: identity offset: must be 220"},
        {64 + 12, 2, 1, "directory: identity id: ids must ascend"},
    };
    for (const auto& damage : damages) {
        const base::Bytes changed = test::changed(image, damage.at, damage.width, damage.value);
        const Lines lines = wrongs(annotate(changed));
        if (*damage.wrong == '\0') {
            EXPECT_EQ(lines, Lines{});
        } else {
            ASSERT_FALSE(lines.empty()) << damage.wrong;
            EXPECT_EQ(lines.front(), damage.wrong);
        }
    }
}

TEST(DamagedImage, is_marked_at_the_crc_and_where_the_damage_can_be_seen) {
    base::Bytes image = sample();
    image[test::offset_of(image, image::SectionId::pdos) + 2] = 9;
    const Annotation annotation = annotate(image);
    EXPECT_EQ(annotation.status, image::Status::bad_crc);
    EXPECT_EQ(annotation.status_beyond_crc, image::Status::bad_section);
    const Lines lines = wrongs(annotation);
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_EQ(lines[0], "pdos 1 of 20: TPDO1 active: must be 0 or 1");
    EXPECT_TRUE(lines[1].starts_with("trailer crc32: the bytes before have 0x")) << lines[1];
}

TEST(DamagedImage, is_marked_at_its_section_where_no_field_is_wrong_by_itself) {
    const base::Bytes image = sample();
    const std::size_t at = test::offset_of(image, image::SectionId::pdos) + 4 * 40 + 4;
    const base::Bytes changed = test::changed(image, at, 2, 0x185);  // TPDO5 takes TPDO1's identifier
    EXPECT_EQ(wrongs(annotate(changed)),
              Lines{"pdos 1 of 20: TPDO1: a record holds a value that no configuration can have"});
}

TEST(DamagedImage, of_another_kind_is_not_read_beyond_its_first_bytes) {
    const base::Bytes text(100, 'a');
    const Annotation annotation = annotate(text);
    EXPECT_EQ(annotation.status, image::Status::bad_magic);
    EXPECT_EQ(wrongs(annotation).front(),
              "header magic: not a configuration image: those begin with \"CGWI\"");
    const base::Bytes major = test::changed(sample(), 4, 2, 2);
    EXPECT_EQ(wrongs(annotate(major)), Lines{"header format_major: must be 1"});
    EXPECT_EQ(annotate(major).groups.back().title, "what follows is not read");
}

TEST(DamagedImage, shows_bytes_behind_its_end) {
    base::Bytes image = sample();
    image.insert(image.end(), 10, 0xFF);
    const Lines lines = wrongs(annotate(image));
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_EQ(lines[1], "bytes behind the image appended: behind the end that the header states");
}

TEST(DamagedImage, of_a_later_minor_shows_what_it_adds_and_is_not_wrong) {
    base::Bytes image = sample();
    image.insert(image.begin() + image::header::size, {1, 2, 3, 4});
    wire::store_u16(&image[image::header::format_minor], 1);
    wire::store_u16(&image[image::header::header_size], image::header::size + 4);
    wire::store_u32(&image[image::header::total_size], static_cast<std::uint32_t>(image.size()));
    for (std::size_t i = 0; i + 1 < image::section_ids; ++i) {
        std::uint8_t* const offset = &image[image::header::size + 4 + i * 12 + image::directory::offset];
        wire::store_u32(offset, wire::load_u32(offset) + 4);
    }
    test::sign(image);
    const Annotation annotation = annotate(image);
    EXPECT_EQ(annotation.status, image::Status::ok);
    EXPECT_EQ(wrongs(annotation), Lines{});
    EXPECT_EQ(annotation.groups.front().items.back().name, "more");
}

}  // namespace
}  // namespace cgw::inspect
