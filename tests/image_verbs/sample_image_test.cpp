// The images of the shipped samples, from the parameter file to the reader.
#include <gtest/gtest.h>

#include "driver/check_file.hpp"
#include "driver/plant.hpp"
#include "emit/emitter.hpp"
#include "support/image_bytes.hpp"

namespace cgw::test {
namespace {

using image::Status;

constexpr const char* samples[] = {"genset.toml", "minimal.toml", "manual-example.toml"};
constexpr std::uint16_t first_measurement = 2000;  // sensors (9nn) may have no name (D13)
constexpr std::uint32_t invalid_bit = 0x80000000;

class SampleImage : public testing::TestWithParam<const char*> {
  protected:
    void SetUp() override {
        file_ = driver::check_file(std::string(CGW_SAMPLES) + "/" + GetParam());
        ASSERT_TRUE(file_.valid());
        const auto plant = driver::Plant::make(file_);
        ASSERT_TRUE(plant.has_value());
        bytes_ = emit::find_emitter("image")->emit(plant->view(), {});
        ASSERT_EQ(image::Image::open(bytes_, image_), Status::ok);
    }

    std::uint32_t object(std::uint16_t index, std::uint8_t sub_index) const {
        const auto lookup = image_.objects().find(index, sub_index);
        EXPECT_EQ(lookup.found, object::Found::yes) << std::hex << index << ":" << int{sub_index};
        return lookup.found == object::Found::yes ? object::load_value(image_.initial_values(), lookup.entry)
                                                  : 0;
    }

    driver::CheckedFile file_;
    base::Bytes bytes_;
    image::Image image_;
};

// All bits of the fullest sample; of the others every seventh, which visits every bit position of a byte.
TEST_P(SampleImage, is_refused_after_a_single_bit_flip) {
    const std::size_t step = std::string_view(GetParam()) == samples[0] ? 1 : 7;
    for (std::size_t bit = 0; bit < 8 * bytes_.size(); bit += step) {
        const auto mask = static_cast<std::uint8_t>(1U << (bit % 8));
        bytes_[bit / 8] ^= mask;
        ASSERT_NE(open(bytes_), Status::ok) << "byte " << bit / 8 << ", bit " << bit % 8;
        bytes_[bit / 8] ^= mask;
    }
}

TEST_P(SampleImage, is_refused_after_any_truncation) {
    for (std::size_t size = 0; size < bytes_.size(); ++size) {
        const base::Bytes shorter(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(size));
        ASSERT_NE(open(shorter), Status::ok) << size;
    }
}

// What the gateway does (the PDO table) is what a master reads (the objects).
TEST_P(SampleImage, tells_the_master_what_the_gateway_does) {
    for (std::size_t i = 0; i < image::pdo::count; ++i) {
        const image::Pdo pdo = image_.pdo(i);
        const auto communication =
            static_cast<std::uint16_t>((pdo.receive ? 0x1400 : 0x1800) + pdo.number - 1);
        const auto mapping = static_cast<std::uint16_t>(communication + 0x200);
        EXPECT_EQ(object(communication, 1), pdo.cob_id | (pdo.active ? 0U : invalid_bit)) << i;
        EXPECT_EQ(object(communication, 2), pdo.transmission_type) << i;
        EXPECT_EQ(object(mapping, 0), pdo.word_count) << i;
        for (std::uint8_t word = 0; word < pdo.word_count; ++word) {
            const image::MappedObject& mapped = pdo.mapping[word];
            const std::uint32_t entry =
                (std::uint32_t{mapped.index} << 16) | (std::uint32_t{mapped.sub_index} << 8) | mapped.bits;
            EXPECT_EQ(object(mapping, static_cast<std::uint8_t>(word + 1)), entry) << i;
        }
    }
    EXPECT_EQ(object(0x1018, 1), image_.identity().vendor);
    EXPECT_EQ(object(0x1018, 4), image_.identity().serial);
    EXPECT_EQ(object(0x1017, 0), image_.heartbeat().producer_us / 1000);
    EXPECT_EQ(object(0x1200, 1), 0x600U + image_.can2().own_node);
}

TEST_P(SampleImage, names_every_measurement_it_sends) {
    image::Label title;
    ASSERT_TRUE(image_.find_label(0, title));
    EXPECT_EQ(title.name, file_.settings.title);
    for (std::size_t i = 0; i < image_.signal_count(); ++i) {
        const std::uint16_t number = image_.signal(i).number;
        image::Label label;
        EXPECT_TRUE(number < first_measurement || image_.find_label(number, label)) << number;
    }
}

INSTANTIATE_TEST_SUITE_P(Shipped, SampleImage, testing::ValuesIn(samples), [](const auto& sample) {
    std::string name = sample.param;
    for (char& c : name) {
        c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    }
    return name;
});

}  // namespace
}  // namespace cgw::test
