#include "link/governor_half.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/sample_plant.hpp"

namespace cgw::link {
namespace {

class Half : public testing::Test {
  protected:
    Half() { EXPECT_EQ(image::Image::open(bytes_, image_), image::Status::ok); }

    std::vector<std::uint16_t> values(ItemKind kind) const {
        const GovernorHalf half(image_);
        std::vector<std::uint16_t> found;
        for (std::uint16_t index = 0; index < half.count(); ++index) {
            const Item item = half.item(index);
            if (item.kind == kind) {
                EXPECT_EQ(item.position, found.size());
                found.push_back(item.value);
            }
        }
        return found;
    }

    test::SamplePlant plant_;
    base::Bytes bytes_ = plant_.image();
    image::Image image_;
};

using Values = std::vector<std::uint16_t>;

TEST_F(Half, names_both_devices_and_the_main_cycle) {
    EXPECT_EQ(values(ItemKind::version), (Values{1}));
    EXPECT_EQ(values(ItemKind::governor_node), (Values{3}));
    EXPECT_EQ(values(ItemKind::gateway_node), (Values{7}));
    EXPECT_EQ(values(ItemKind::send_errors), (Values{1}));
    EXPECT_EQ(values(ItemKind::send_status), (Values{0}));
    EXPECT_EQ(values(ItemKind::main_cycle), (Values{15'625, 0}));
}

TEST_F(Half, holds_every_word_of_every_analogue_pdo) {
    const Values words = values(ItemKind::assignment);
    ASSERT_EQ(words.size(), 52U);
    EXPECT_EQ(Values(words.begin(), words.begin() + 6), (Values{2000, 2300, 2101, 2201, 2905, 0}));
    EXPECT_EQ(values(ItemKind::cycles).size(), 13U);
    EXPECT_EQ(values(ItemKind::cycles)[1], 12);
    EXPECT_EQ(values(ItemKind::monitoring), (Values{0, 6, 0, 0}));
}

TEST_F(Half, holds_switches_and_sensors) {
    EXPECT_EQ(values(ItemKind::switches), (Values{2}));
    EXPECT_EQ(values(ItemKind::switch_number), (Values{811, 835}));
    EXPECT_EQ(values(ItemKind::switch_bit), (Values{1, 0x105}));  // the second is low-active
    EXPECT_EQ(values(ItemKind::sensors), (Values{2}));
    EXPECT_EQ(values(ItemKind::sensor_number), (Values{900, 906}));
    EXPECT_EQ(values(ItemKind::sensor_channel), (Values{1, 7}));
}

}  // namespace
}  // namespace cgw::link
