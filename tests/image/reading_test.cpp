// Round trip: what the writer was given is what the reader says.
#include <gtest/gtest.h>

#include <algorithm>

#include "support/image_bytes.hpp"
#include "support/sample_plant.hpp"

namespace cgw::test {
namespace {

class ImageReading : public testing::Test {
  protected:
    void SetUp() override { ASSERT_EQ(image::Image::open(bytes_, image_), image::Status::ok); }

    SamplePlant plant_;
    base::Bytes bytes_ = plant_.image();
    image::Image image_;
};

TEST_F(ImageReading, tells_who_wrote_it_and_from_what) {
    EXPECT_EQ(image_.format_major(), 1);
    EXPECT_EQ(image_.format_minor(), 0);
    EXPECT_EQ(image_.tool_version(), (std::array<std::uint16_t, 3>{1, 2, 3}));
    const auto id = image_.configuration_id();
    EXPECT_TRUE(
        std::equal(id.begin(), id.end(), plant_.configuration_id.begin(), plant_.configuration_id.end()));
    EXPECT_EQ(image_.bytes().size(), bytes_.size());
    EXPECT_EQ(image_.crc(), wire::load_u32(&bytes_[bytes_.size() - 4]));
}

TEST_F(ImageReading, gives_identity_and_buses) {
    const image::Identity identity = image_.identity();
    EXPECT_EQ(identity.vendor, 0x161U);
    EXPECT_EQ(identity.product, 0x1B59U);
    EXPECT_EQ(identity.revision, 12U);
    EXPECT_EQ(identity.serial, 0x01970102U);
    const image::Bus can1 = image_.can1();
    EXPECT_EQ(can1.own_node, 7);
    EXPECT_EQ(can1.peer_node, 3);
    EXPECT_FALSE(can1.manual_timing);
    EXPECT_EQ(can1.bit_rate_kbit, 250);
    EXPECT_EQ(can1.start_up_delay_ms, 1500U);
    const image::Bus can2 = image_.can2();
    EXPECT_EQ(can2.own_node, 5);
    EXPECT_EQ(can2.peer_node, 127);
    EXPECT_TRUE(can2.manual_timing);
    EXPECT_EQ(can2.registers, (std::array<std::uint8_t, 6>{3, 1, 1, 5, 4, 2}));
    EXPECT_EQ(can2.start_up_delay_ms, 0U);
}

TEST_F(ImageReading, gives_the_governors_half_and_the_heartbeats) {
    const image::Governor governor = image_.governor();
    EXPECT_EQ(governor.own_node, 3);
    EXPECT_EQ(governor.gateway_node, 7);
    EXPECT_EQ(governor.bit_rate_kbit, 250);
    EXPECT_FALSE(governor.manual_timing);
    EXPECT_TRUE(governor.send_errors);
    EXPECT_FALSE(governor.send_status);
    EXPECT_EQ(governor.start_up_delay_ms, 1000U);
    EXPECT_EQ(governor.main_cycle_us, 15625U);
    EXPECT_EQ(image_.heartbeat().producer_us, 1'008'000U);
    EXPECT_EQ(image_.heartbeat().consumer_us, 96'000U);
    EXPECT_EQ(image_.heartbeat().consumer_node, 127);
}

TEST_F(ImageReading, gives_an_active_transmit_pdo) {
    const image::Pdo pdo = image_.pdo(4);
    EXPECT_FALSE(pdo.receive);
    EXPECT_EQ(pdo.number, 5);
    EXPECT_TRUE(pdo.active);
    EXPECT_TRUE(pdo.cob_id_from_parameter);
    EXPECT_EQ(pdo.cob_id, 0x282);
    EXPECT_EQ(pdo.transmission_type, 254);
    EXPECT_EQ(pdo.asked_ms, 200);
    EXPECT_EQ(pdo.cycles, 12);
    EXPECT_EQ(pdo.effective_us, 187'500U);
    EXPECT_EQ(pdo.word_count, 1);
    EXPECT_EQ(pdo.mapping[0].index, 0x2001);
    EXPECT_EQ(pdo.mapping[0].sub_index, 3);
    EXPECT_EQ(pdo.mapping[0].bits, 16);
    EXPECT_EQ(pdo.mapping[0].parameter, 2905);
    EXPECT_EQ(pdo.mapping[1].index, 0);
}

TEST_F(ImageReading, keeps_identifier_and_time_of_an_inactive_pdo) {
    const image::Pdo pdo = image_.pdo(5);
    EXPECT_FALSE(pdo.active);
    EXPECT_EQ(pdo.cob_id, 0x682);
    EXPECT_EQ(pdo.asked_ms, 10);
    EXPECT_EQ(pdo.effective_us, 15'625U);
    EXPECT_EQ(pdo.word_count, 0);
}

TEST_F(ImageReading, gives_receive_pdos_with_their_dummies) {
    const image::Pdo pdo = image_.pdo(18);
    EXPECT_TRUE(pdo.receive);
    EXPECT_EQ(pdo.number, 3);
    EXPECT_EQ(pdo.cob_id, 0x405);
    EXPECT_EQ(pdo.word_count, 3);
    EXPECT_EQ(pdo.mapping[1].index, 0x0006);
    EXPECT_EQ(pdo.mapping[1].parameter, 0);
    EXPECT_EQ(pdo.mapping[2].index, 0x2004);
    EXPECT_EQ(pdo.mapping[2].sub_index, 7);
    EXPECT_EQ(pdo.mapping[2].parameter, 906);
}

TEST_F(ImageReading, gives_switches_and_sensors) {
    ASSERT_EQ(image_.switch_count(), 2U);
    EXPECT_EQ(image_.switch_function(1).number, 835);
    EXPECT_EQ(image_.switch_function(1).bit, 5);
    EXPECT_TRUE(image_.switch_function(1).low_active);
    EXPECT_FALSE(image_.switch_function(0).low_active);
    ASSERT_EQ(image_.sensor_count(), 2U);
    EXPECT_EQ(image_.sensor(1).number, 906);
    EXPECT_EQ(image_.sensor(1).channel, 7);
}

TEST_F(ImageReading, finds_signals_by_number) {
    ASSERT_EQ(image_.signal_count(), 7U);
    image::Signal signal;
    ASSERT_TRUE(image_.find_signal(2000, signal));
    EXPECT_EQ(signal.internal_maximum, 64000);
    ASSERT_TRUE(image_.find_signal(2201, signal));
    EXPECT_EQ(signal.width, 8);
    EXPECT_TRUE(signal.is_signed);
    EXPECT_EQ(signal.internal_minimum, -128);
    EXPECT_EQ(signal.internal_maximum, 127);
    ASSERT_TRUE(image_.find_signal(900, signal));
    EXPECT_EQ(signal.width, 16);
    EXPECT_EQ(signal.internal_maximum, 65535);
    EXPECT_FALSE(image_.find_signal(1, signal));
    EXPECT_FALSE(image_.find_signal(2001, signal));
    EXPECT_FALSE(image_.find_signal(29999, signal));
}

TEST_F(ImageReading, gives_objects_and_initial_values) {
    const object::ObjectTable objects = image_.objects();
    const auto cob_id = objects.find(0x1800, 1);
    ASSERT_EQ(cob_id.found, object::Found::yes);
    EXPECT_EQ(object::load_value(image_.initial_values(), cob_id.entry), 0x185U);
    const auto input = objects.find(0x2004, 7);
    ASSERT_EQ(input.found, object::Found::yes);
    EXPECT_EQ(input.entry.flags, object::flag_pdo_mappable | object::flag_sdo_read_only);
    EXPECT_EQ(objects.find(0x2004, 8).found, object::Found::no_sub_index);
    EXPECT_EQ(objects.find(0x1005, 0).found, object::Found::no_object);
}

TEST_F(ImageReading, finds_labels_by_number) {
    image::Label label;
    ASSERT_TRUE(image_.find_label(0, label));
    EXPECT_EQ(label.name, plant_.settings.title);
    ASSERT_TRUE(image_.find_label(2000, label));
    EXPECT_EQ(label.name, "Speed");
    EXPECT_EQ(label.unit, "1/min");
    ASSERT_TRUE(label.has_scaling);
    EXPECT_EQ(label.external_minimum, 0.0);
    EXPECT_EQ(label.external_maximum, 4000.0);
    EXPECT_FALSE(image_.find_label(2101, label));
}

TEST_F(ImageReading, has_no_labels_when_they_were_left_out) {
    const base::Bytes bytes = plant_.image(false);
    image::Image image;
    ASSERT_EQ(image::Image::open(bytes, image), image::Status::ok);
    image::Label label;
    EXPECT_EQ(image.label_count(), 0U);
    EXPECT_FALSE(image.find_label(0, label));
    EXPECT_LT(bytes.size(), bytes_.size());
}

TEST(ImageStatus, has_a_text_of_its_own_for_every_code) {
    std::vector<std::string_view> texts;
    for (unsigned code = 0; code <= 13; ++code) {
        const std::string_view text = image::to_text(static_cast<image::Status>(code));
        EXPECT_EQ(std::count(texts.begin(), texts.end(), text), 0) << text;
        texts.push_back(text);
    }
    EXPECT_EQ(image::to_text(static_cast<image::Status>(14)), "unknown");
    EXPECT_EQ(std::count(texts.begin(), texts.end(), std::string_view("unknown")), 0);
}

}  // namespace
}  // namespace cgw::test
