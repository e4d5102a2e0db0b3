// Accidents: flipped bits, lost and added bytes, and whatever else can happen to a file.
#include <gtest/gtest.h>

#include <random>

#include "support/image_bytes.hpp"
#include "support/sample_plant.hpp"

namespace cgw::test {
namespace {

using image::Image;
using image::Status;

// Uses everything a reader could use; the sanitizers watch.
std::size_t read_all(const Image& image) {
    std::size_t sum = image.identity().vendor + image.can1().own_node + image.can2().own_node +
                      image.governor().main_cycle_us + image.heartbeat().producer_us + image.crc();
    for (std::size_t i = 0; i < image::pdo::count; ++i) {
        sum += image.pdo(i).cob_id;
    }
    for (std::size_t i = 0; i < image.switch_count(); ++i) {
        sum += image.switch_function(i).number;
    }
    for (std::size_t i = 0; i < image.sensor_count(); ++i) {
        sum += image.sensor(i).number;
    }
    for (std::size_t i = 0; i < image.signal_count(); ++i) {
        sum += image.signal(i).number;
    }
    for (std::size_t i = 0; i < image.label_count(); ++i) {
        for (const char c : std::string(image.label(i).name) + std::string(image.label(i).unit)) {
            sum += static_cast<unsigned char>(c);
        }
    }
    for (std::size_t i = 0; i < image.objects().size(); ++i) {
        sum += object::load_value(image.initial_values(), image.objects().entry(i));
    }
    return sum;
}

// In a buffer of its own size, so that the address sanitizer sees any read beyond it.
Status open_exactly(const std::uint8_t* bytes, std::size_t size) {
    const base::Bytes copy(bytes, bytes + size);
    Image image;
    const Status status = Image::open(copy, image);
    if (status == Status::ok) {
        read_all(image);
    }
    return status;
}

TEST(ImageIntegrity, accepts_what_the_writer_wrote) {
    EXPECT_EQ(open(SamplePlant().image()), Status::ok);
    EXPECT_EQ(open(SamplePlant().image(false)), Status::ok);
}

TEST(ImageIntegrity, refuses_every_single_bit_flip) {
    base::Bytes bytes = SamplePlant().image();
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
        const auto mask = static_cast<std::uint8_t>(1U << (bit % 8));
        bytes[bit / 8] ^= mask;
        ASSERT_NE(open(bytes), Status::ok) << "byte " << bit / 8 << ", bit " << bit % 8;
        bytes[bit / 8] ^= mask;
    }
    EXPECT_EQ(open(bytes), Status::ok);
}

TEST(ImageIntegrity, refuses_every_truncation) {
    const base::Bytes bytes = SamplePlant().image();
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        ASSERT_EQ(open_exactly(bytes.data(), size),
                  size < image::minimum_size ? Status::too_small : Status::size_mismatch)
            << size;
    }
}

TEST(ImageIntegrity, refuses_a_truncation_whose_size_and_crc_were_mended) {
    const base::Bytes bytes = SamplePlant().image();
    for (std::size_t size = image::minimum_size; size < bytes.size(); ++size) {
        base::Bytes shorter(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
        wire::store_u32(&shorter[image::header::total_size], static_cast<std::uint32_t>(size));
        sign(shorter);
        ASSERT_EQ(open_exactly(shorter.data(), size), Status::bad_directory) << size;
    }
}

TEST(ImageIntegrity, refuses_an_extension_by_any_byte) {
    base::Bytes bytes = SamplePlant().image();
    bytes.push_back(0);
    for (unsigned value = 0; value < 256; ++value) {
        bytes.back() = static_cast<std::uint8_t>(value);
        ASSERT_EQ(open(bytes), Status::size_mismatch);
    }
}

TEST(ImageIntegrity, leaves_the_view_untouched_when_it_refuses) {
    const base::Bytes good = SamplePlant().image();
    Image image;
    ASSERT_EQ(Image::open(good, image), Status::ok);
    ASSERT_EQ(Image::open({}, image), Status::too_small);
    EXPECT_EQ(image.bytes().data(), good.data());
    EXPECT_EQ(image.can2().own_node, 5);
}

TEST(ImageIntegrity, never_reads_outside_whatever_signed_bytes_say) {
    const base::Bytes good = SamplePlant().image();
    std::mt19937 random(20040519);  // NOLINT: the same bytes every time
    const auto below = [&](std::size_t limit) { return random() % limit; };
    std::array<unsigned, 14> seen{};
    for (int round = 0; round < 6000; ++round) {
        base::Bytes bytes = good;
        for (std::size_t change = 1 + below(3); change > 0; --change) {
            // Half of the changes hit the header and the directory, where bytes steer the reader.
            const std::size_t position = below(below(2) == 0 ? 208 : bytes.size());
            bytes[position] = static_cast<std::uint8_t>(below(4) == 0 ? 0xFF : below(256));
        }
        if (below(8) == 0) {
            bytes.resize(below(bytes.size() + 16));
        }
        if (bytes.size() >= image::minimum_size) {
            if (below(2) == 0) {
                wire::store_u32(&bytes[image::header::total_size], static_cast<std::uint32_t>(bytes.size()));
            }
            sign(bytes);
        }
        ++seen.at(static_cast<std::size_t>(open_exactly(bytes.data(), bytes.size())));
    }
    for (const Status status : {Status::ok, Status::bad_directory, Status::bad_section,
                                Status::bad_object_table, Status::bad_mapping, Status::bad_label}) {
        EXPECT_GT(seen.at(static_cast<std::size_t>(status)), 0U) << image::to_text(status);
    }
    EXPECT_EQ(seen.at(static_cast<std::size_t>(Status::bad_crc)), 0U);
}

}  // namespace
}  // namespace cgw::test
