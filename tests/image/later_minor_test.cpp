// What a later minor version may add, and that this reader takes it.
#include <gtest/gtest.h>

#include "support/image_bytes.hpp"
#include "support/sample_plant.hpp"

namespace cgw::test {
namespace {

using image::SectionId;
using image::Status;
namespace directory = image::directory;
namespace header = image::header;

struct Part {
    std::uint16_t id = 0;
    std::size_t record_size = 1;
    base::Bytes bytes;
};

std::vector<Part> parts_of(const base::Bytes& image) {
    std::vector<Part> parts;
    for (std::uint16_t id = 1; id < image::section_ids; ++id) {
        const auto section = static_cast<SectionId>(id);
        const auto from = image.begin() + static_cast<std::ptrdiff_t>(offset_of(image, section));
        parts.push_back({id, wire::load_u16(&image[entry_of(section) + directory::record_size]),
                         base::Bytes(from, from + static_cast<std::ptrdiff_t>(size_of(image, section)))});
    }
    return parts;
}

// Every record `more` bytes longer, filled with FFh.
void lengthen(Part& part, std::size_t more) {
    base::Bytes longer;
    for (std::size_t at = 0; at < part.bytes.size(); at += part.record_size) {
        const auto from = part.bytes.begin() + static_cast<std::ptrdiff_t>(at);
        longer.insert(longer.end(), from, from + static_cast<std::ptrdiff_t>(part.record_size));
        longer.insert(longer.end(), more, 0xFF);
    }
    part.bytes = longer;
    part.record_size += more;
}

base::Bytes join(const base::Bytes& old, const std::vector<Part>& parts, std::uint16_t minor,
                 std::size_t header_size) {
    base::Bytes bytes(old.begin(), old.begin() + header::size);
    bytes.resize(header_size, 0xFF);
    bytes.resize(header_size + parts.size() * directory::entry_size);
    std::size_t entry = header_size;
    for (const Part& part : parts) {
        bytes.resize((bytes.size() + 3) / 4 * 4);
        wire::store_u16(&bytes[entry + directory::id], part.id);
        wire::store_u16(&bytes[entry + directory::record_size], static_cast<std::uint16_t>(part.record_size));
        wire::store_u32(&bytes[entry + directory::offset], static_cast<std::uint32_t>(bytes.size()));
        wire::store_u32(&bytes[entry + directory::size], static_cast<std::uint32_t>(part.bytes.size()));
        entry += directory::entry_size;
        bytes.insert(bytes.end(), part.bytes.begin(), part.bytes.end());
    }
    bytes.resize((bytes.size() + 3) / 4 * 4 + image::crc_size);
    wire::store_u16(&bytes[header::format_minor], minor);
    wire::store_u16(&bytes[header::header_size], static_cast<std::uint16_t>(header_size));
    wire::store_u16(&bytes[header::section_count], static_cast<std::uint16_t>(parts.size()));
    wire::store_u32(&bytes[header::total_size], static_cast<std::uint32_t>(bytes.size()));
    sign(bytes);
    return bytes;
}

bool is_records(const Part& part) {
    return part.id != static_cast<std::uint16_t>(SectionId::object_values) &&
           part.id != static_cast<std::uint16_t>(SectionId::strings) &&
           part.id != static_cast<std::uint16_t>(SectionId::model);
}

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
    parts.push_back({14, 6, base::Bytes(18, 0xEE)});
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
    added.push_back({14, 1, base::Bytes(4)});
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
