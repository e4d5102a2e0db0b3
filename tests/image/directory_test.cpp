// Images with a wrong header or directory.
#include <gtest/gtest.h>

#include "support/image_bytes.hpp"
#include "support/sample_plant.hpp"

namespace cgw::test {
namespace {

using image::SectionId;
using image::Status;
namespace directory = image::directory;
namespace header = image::header;

const base::Bytes& good() {
    static const base::Bytes bytes = SamplePlant().image();
    return bytes;
}

TEST(ImageHeader, is_refused_when_the_magic_differs) {
    EXPECT_EQ(open(changed(good(), header::magic + 3, 1, 'J')), Status::bad_magic);
}

TEST(ImageHeader, is_refused_for_any_other_major) {
    EXPECT_EQ(open(changed(good(), header::format_major, 2, 2)), Status::unsupported_major);
    EXPECT_EQ(open(changed(good(), header::format_major, 2, 0)), Status::unsupported_major);
}

TEST(ImageHeader, is_refused_when_its_size_is_not_that_of_the_format) {
    for (const std::uint64_t size : {0U, 60U, 66U, 68U, 0xFFFCU}) {
        EXPECT_EQ(open(changed(good(), header::header_size, 2, size)), Status::bad_header_size) << size;
    }
}

TEST(ImageHeader, is_refused_when_reserved_bytes_are_used) {
    for (std::size_t i = header::reserved; i < header::size; ++i) {
        EXPECT_EQ(open(changed(good(), i, 1, 1)), Status::bad_header_size) << i;
    }
}

TEST(ImageHeader, is_refused_when_the_stated_size_is_wrong) {
    EXPECT_EQ(open(changed(good(), header::total_size, 4, good().size() + 4)), Status::size_mismatch);
    EXPECT_EQ(open(changed(good(), header::total_size, 4, 0)), Status::size_mismatch);
}

TEST(ImageHeader, is_refused_when_the_crc_does_not_match) {
    base::Bytes bytes = good();
    bytes[header::configuration_id] ^= 1U;
    EXPECT_EQ(open(bytes), Status::bad_crc);
}

TEST(ImageSize, is_refused_below_the_minimum_and_above_the_maximum) {
    EXPECT_EQ(open({}), Status::too_small);
    EXPECT_EQ(open(base::Bytes(image::minimum_size - 1)), Status::too_small);
    EXPECT_EQ(open(base::Bytes(image::minimum_size)), Status::bad_magic);
    EXPECT_EQ(open(base::Bytes(image::maximum_size)), Status::bad_magic);
    EXPECT_EQ(open(base::Bytes(image::maximum_size + 1)), Status::too_large);
}

TEST(ImageDirectory, is_refused_when_it_does_not_fit_the_bytes) {
    EXPECT_EQ(open(changed(good(), header::section_count, 2, 0xFFFF)), Status::bad_directory);
    EXPECT_EQ(open(changed(good(), header::section_count, 2, 12)), Status::bad_directory);
    EXPECT_EQ(open(changed(good(), header::section_count, 2, 14)), Status::bad_directory);
}

TEST(ImageDirectory, is_refused_when_ids_do_not_ascend_or_are_unknown) {
    EXPECT_EQ(open(changed(good(), entry_of(SectionId::identity), 2, 0)), Status::bad_directory);
    EXPECT_EQ(open(changed(good(), entry_of(SectionId::buses), 2, 1)), Status::bad_directory);
    EXPECT_EQ(open(changed(good(), entry_of(SectionId::buses), 2, 3)), Status::bad_directory);
    EXPECT_EQ(open(changed(good(), entry_of(SectionId::model), 2, 14)), Status::bad_directory);
}

TEST(ImageDirectory, is_refused_when_offsets_overlap_leave_gaps_or_point_outside) {
    const std::size_t entry = entry_of(SectionId::sensors);
    const std::size_t offset = offset_of(good(), SectionId::sensors);
    for (const std::uint64_t wrong : {std::uint64_t{0}, std::uint64_t{offset - 4}, std::uint64_t{offset + 4},
                                      std::uint64_t{offset + 1}, std::uint64_t{0xFFFFFFFC}}) {
        EXPECT_EQ(open(changed(good(), entry + directory::offset, 4, wrong)), Status::bad_directory) << wrong;
    }
}

TEST(ImageDirectory, is_refused_when_a_size_is_wrong) {
    const std::size_t entry = entry_of(SectionId::signals);
    for (const std::uint64_t wrong : {0ULL, 12ULL, 83ULL, 96ULL, 0xFFFFFFFCULL}) {
        EXPECT_EQ(open(changed(good(), entry + directory::size, 4, wrong)), Status::bad_directory) << wrong;
    }
}

TEST(ImageDirectory, is_refused_when_a_record_size_is_wrong) {
    for (const std::uint64_t wrong : {0U, 1U, 6U, 11U, 14U, 84U, 0xFFFFU}) {
        const std::size_t entry = entry_of(SectionId::signals);
        EXPECT_EQ(open(changed(good(), entry + directory::record_size, 2, wrong)), Status::bad_directory)
            << wrong;
    }
    EXPECT_EQ(open(changed(good(), entry_of(SectionId::pdos) + directory::record_size, 2, 80)),
              Status::bad_directory);
}

TEST(ImageDirectory, is_refused_when_padding_is_not_zero) {
    const std::size_t end = offset_of(good(), SectionId::model) + size_of(good(), SectionId::model);
    const std::size_t crc = good().size() - image::crc_size;
    const std::size_t values = offset_of(good(), SectionId::object_values);
    const std::size_t values_end = values + size_of(good(), SectionId::object_values);
    ASSERT_NE(values_end % 4, 0U);
    EXPECT_EQ(open(changed(good(), values_end, 1, 1)), Status::bad_directory);
    for (std::size_t i = end; i < crc; ++i) {
        EXPECT_EQ(open(changed(good(), i, 1, 1)), Status::bad_directory);
    }
}

// The image without one of its sections, moved together and signed.
base::Bytes without(SectionId id) {
    std::vector<std::uint8_t> directory_bytes;
    base::Bytes body;
    const std::size_t count = image::section_ids - 2;
    std::size_t at = header::size + count * directory::entry_size;
    for (std::size_t i = 1; i < image::section_ids; ++i) {
        const auto section = static_cast<SectionId>(i);
        if (section == id) {
            continue;
        }
        const auto entry = good().begin() + static_cast<std::ptrdiff_t>(entry_of(section));
        base::Bytes record(entry, entry + directory::entry_size);
        wire::store_u32(&record[directory::offset], static_cast<std::uint32_t>(at + body.size()));
        directory_bytes.insert(directory_bytes.end(), record.begin(), record.end());
        const auto from = good().begin() + static_cast<std::ptrdiff_t>(offset_of(good(), section));
        body.insert(body.end(), from, from + static_cast<std::ptrdiff_t>(size_of(good(), section)));
        body.resize((body.size() + 3) / 4 * 4);
    }
    base::Bytes bytes(good().begin(), good().begin() + header::size);
    bytes.insert(bytes.end(), directory_bytes.begin(), directory_bytes.end());
    bytes.insert(bytes.end(), body.begin(), body.end());
    bytes.resize(bytes.size() + image::crc_size);
    wire::store_u16(&bytes[header::section_count], count);
    wire::store_u32(&bytes[header::total_size], static_cast<std::uint32_t>(bytes.size()));
    sign(bytes);
    return bytes;
}

TEST(ImageSections, are_missed_one_by_one) {
    for (std::uint16_t id = 1; id <= 12; ++id) {
        EXPECT_EQ(open(without(static_cast<SectionId>(id))), Status::section_missing) << id;
    }
}

TEST(ImageSections, may_lack_the_model) {
    EXPECT_EQ(open(without(SectionId::model)), Status::ok);
}

}  // namespace
}  // namespace cgw::test
