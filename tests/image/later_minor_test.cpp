// What a later minor version may add, and that this reader takes it.
#include <gtest/gtest.h>

#include "support/later_image.hpp"
#include "support/sample_plant.hpp"

namespace cgw::test {
namespace {

using image::SectionId;
using image::Status;
namespace header = image::header;

TEST(LaterMinor, joins_back_to_the_same_image) {
    const base::Bytes old = SamplePlant().image();
    EXPECT_EQ(join(old, parts_of(old), 0, header::size), old);
}

TEST(LaterMinor, may_add_sections_lengthen_records_and_the_header) {
    const SamplePlant plant;
    const base::Bytes old = plant.image();
    std::vector<Part> parts = parts_of(old);
    for (Part& part : parts) {
        if (is_records(part)) {
            lengthen(part, 4);
        }
    }
    parts.push_back({image::section_ids, 6, base::Bytes(18, 0xEE)});
    parts.push_back({900, 1, {}});
    const base::Bytes bytes = join(old, parts, 1, 80);
    image::Image image;
    ASSERT_EQ(image::Image::open(bytes, image), Status::ok);

    EXPECT_EQ(image.format_minor(), 1);
    EXPECT_EQ(image.pdo(4).cob_id, 0x282);
    EXPECT_EQ(image.can2().own_node, 5);
    EXPECT_EQ(image.sensor(1).number, 906);
    image::Label label;
    ASSERT_TRUE(image.find_label(2000, label));
    EXPECT_EQ(label.name, "Speed");
    const auto found = image.objects().find(0x1018, 4);
    ASSERT_EQ(found.found, object::Found::yes);
    EXPECT_EQ(object::load_value(image.initial_values(), found.entry), 0x01970102U);
}

TEST(LaterMinor, may_use_reserved_bytes_and_lengthen_the_value_block) {
    const base::Bytes old = SamplePlant().image();
    std::vector<Part> parts = parts_of(old);
    parts[1].bytes[image::bus::reserved] = 0xFF;
    parts[2].bytes[image::governor::reserved_2] = 0xFF;
    parts[6].bytes.resize(parts[6].bytes.size() + 5, 0xFF);
    base::Bytes bytes = join(old, parts, 1, header::size);
    EXPECT_EQ(open(changed(bytes, header::reserved, 1, 1)), Status::ok);
}

TEST(LaterMinor, is_still_held_to_everything_this_minor_defines) {
    const base::Bytes old = SamplePlant().image();
    const std::vector<Part> parts = parts_of(old);
    const base::Bytes later = join(old, parts, 0xFFFF, header::size);
    ASSERT_EQ(open(later), Status::ok);
    EXPECT_EQ(open(changed(later, offset_of(old, SectionId::buses), 1, 0)), Status::bad_section);

    std::vector<Part> shorter = parts;
    shorter[9] = {10, 4, base::Bytes(8)};
    EXPECT_EQ(open(join(old, shorter, 1, header::size)), Status::bad_directory);
    std::vector<Part> lost = parts;
    lost.erase(lost.begin() + 7);
    EXPECT_EQ(open(join(old, lost, 1, header::size)), Status::section_missing);
    EXPECT_EQ(open(join(old, parts, 1, 66)), Status::bad_header_size);
}

TEST(LaterMinor, is_what_additions_need) {
    const base::Bytes old = SamplePlant().image();
    std::vector<Part> added = parts_of(old);
    added.push_back({image::section_ids, 1, base::Bytes(4)});
    EXPECT_EQ(open(join(old, added, 0, header::size)), Status::bad_directory);
    std::vector<Part> longer = parts_of(old);
    lengthen(longer[7], 4);
    EXPECT_EQ(open(join(old, longer, 0, header::size)), Status::bad_directory);
    std::vector<Part> values = parts_of(old);
    values[6].bytes.push_back(0);
    EXPECT_EQ(open(join(old, values, 0, header::size)), Status::bad_object_table);
}

}  // namespace
}  // namespace cgw::test
