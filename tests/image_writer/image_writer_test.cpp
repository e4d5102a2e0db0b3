#include "image_writer/image_writer.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "image/image.hpp"
#include "support/image_bytes.hpp"
#include "support/sample_plant.hpp"

namespace cgw::test {
namespace {

using image::SectionId;

// An opened image with the bytes it looks at.
struct Opened {
    explicit Opened(base::Bytes written) : bytes(std::move(written)) {
        EXPECT_EQ(image::Image::open(bytes, image), image::Status::ok);
    }

    image::Label label(std::uint16_t number) const {
        image::Label label;
        EXPECT_TRUE(image.find_label(number, label)) << number;
        return label;
    }

    base::Bytes bytes;
    image::Image image;
};

TEST(ImageWriter, writes_the_same_bytes_for_the_same_configuration) {
    EXPECT_EQ(SamplePlant().image(), SamplePlant().image());
}

TEST(ImageWriter, writes_the_header_of_the_layout) {
    const base::Bytes bytes = SamplePlant().image();
    EXPECT_EQ(std::string(bytes.begin(), bytes.begin() + 4), "CGWI");
    EXPECT_EQ(wire::load_u16(&bytes[image::header::section_count]), 13);
    EXPECT_EQ(wire::load_u32(&bytes[image::header::total_size]), bytes.size());
    EXPECT_EQ(bytes[image::header::configuration_id], 0xA0);
    EXPECT_EQ(bytes.size() % 4, 0U);
}

TEST(ImageWriter, aligns_every_value_to_its_own_size) {
    const Opened opened(SamplePlant().image());
    const object::ObjectTable objects = opened.image.objects();
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const object::ObjectEntry entry = objects.entry(i);
        EXPECT_EQ(entry.offset % entry.length, 0) << std::hex << entry.index;
    }
    EXPECT_EQ(offset_of(opened.bytes, SectionId::object_values) % 4, 0U);
}

TEST(ImageWriter, resolves_values_with_the_node_id) {
    SamplePlant plant;
    const Opened opened(plant.image());
    const auto found = opened.image.objects().find(0x1800, 1);
    EXPECT_EQ(object::load_value(opened.image.initial_values(), found.entry), 0x185U);
}

TEST(ImageWriter, marks_mappable_objects_and_those_that_only_an_rpdo_writes) {
    const Opened opened(SamplePlant().image());
    const object::ObjectTable objects = opened.image.objects();
    EXPECT_EQ(objects.find(0x2003, 1).entry.flags, object::flag_pdo_mappable | object::flag_sdo_read_only);
    EXPECT_EQ(objects.find(0x2001, 1).entry.flags, object::flag_pdo_mappable);
    EXPECT_EQ(objects.find(0x2003, 0).entry.flags, 0);
    EXPECT_EQ(objects.find(0x1001, 0).entry.access, object::Access::constant);
}

TEST(ImageWriter, truncates_a_value_to_its_type) {
    SamplePlant plant;
    for (dictionary::Object& object : plant.dictionary.objects) {
        if (object.index == 0x2002) {
            object.variables[1].default_value.number = static_cast<std::uint32_t>(-5);
        }
    }
    const Opened opened(plant.image());
    const auto found = opened.image.objects().find(0x2002, 1);
    EXPECT_EQ(object::load_value(opened.image.initial_values(), found.entry), 0xFFFBU);
    const auto next = opened.image.objects().find(0x2002, 2);
    EXPECT_EQ(object::load_value(opened.image.initial_values(), next.entry), 0U);
}

TEST(ImageWriter, gives_a_parameter_sent_twice_one_signal) {
    SamplePlant plant;
    plant.tpdo(5).mapping.push_back(plant.tpdo(4).mapping[0]);
    const Opened opened(plant.image());
    EXPECT_EQ(opened.image.signal_count(), 7U);
    EXPECT_EQ(opened.image.pdo(4).mapping[1].parameter, 2000);
}

TEST(ImageWriter, gives_sensors_that_share_a_channel_a_signal_each) {
    SamplePlant plant;
    plant.configuration.sensors = {{&plant.setpoint, 1}, {&plant.pressure, 1}};
    plant.rpdo(3).active = false;
    plant.rpdo(3).mapping.clear();
    const Opened opened(plant.image());
    image::Signal signal;
    EXPECT_TRUE(opened.image.find_signal(906, signal));
    EXPECT_EQ(opened.image.sensor(1).channel, 1);
}

TEST(ImageWriter, takes_external_limits_from_the_reference_parameters) {
    SamplePlant plant;
    plant.set_reference(980, 0.5);
    plant.set_reference(981, 20);
    const Opened opened(plant.image());
    const image::Label oil = opened.label(2905);
    ASSERT_TRUE(oil.has_scaling);
    EXPECT_EQ(oil.external_minimum, 0.5);
    EXPECT_EQ(oil.external_maximum, 20.0);
    EXPECT_EQ(oil.unit, "bar");
}

TEST(ImageWriter, writes_no_scaling_when_the_reference_parameters_say_nothing) {
    SamplePlant unset;
    EXPECT_FALSE(Opened(unset.image()).label(2905).has_scaling);
    SamplePlant equal;
    equal.set_reference(980, 4);
    equal.set_reference(981, 4);
    EXPECT_FALSE(Opened(equal.image()).label(2905).has_scaling);
}

TEST(ImageWriter, labels_switches_and_skips_rows_without_name) {
    const Opened opened(SamplePlant().image());
    EXPECT_EQ(opened.label(811).name, "FunctIdleSpeed");
    image::Label none;
    EXPECT_FALSE(opened.image.find_label(835, none));
    EXPECT_FALSE(opened.image.find_label(2101, none));
}

TEST(ImageWriter, stores_each_text_once) {
    SamplePlant plant;
    plant.position.name = plant.temperature.name = "Temperature";
    const Opened opened(plant.image());
    EXPECT_EQ(opened.label(2300).name.data(), opened.label(2201).name.data());
}

TEST(ImageWriter, makes_texts_safe_to_show) {
    SamplePlant plant;
    plant.settings.title = "a\nb\x7F\xC2\x85\xFF";
    EXPECT_EQ(Opened(plant.image()).label(0).name, "a b  ?");
}

TEST(ImageWriter, cuts_a_long_title_at_a_whole_character) {
    SamplePlant plant;
    plant.settings.title = std::string(254, 'x') + "ü" + "y";
    EXPECT_EQ(Opened(plant.image()).label(0).name, std::string(254, 'x'));
    plant.settings.title = std::string(253, 'x') + "ü" + "y";
    EXPECT_EQ(Opened(plant.image()).label(0).name, std::string(253, 'x') + "ü");
}

TEST(ImageWriter, keeps_the_canonical_model_with_the_labels) {
    const SamplePlant plant;
    const base::Bytes labelled = plant.image();
    const base::Bytes bare = plant.image(false);
    EXPECT_EQ(Opened(labelled).image.model(), parameter::canonical_text(plant.settings));
    EXPECT_EQ(Opened(bare).image.model(), "");
}

TEST(ImageWriter, leaves_out_a_model_that_would_make_the_image_too_large) {
    SamplePlant plant;
    plant.settings.title =
        std::string(image::maximum_size - plant.image().size() + plant.settings.title.size(), 'x');
    const base::Bytes fits_or_not = plant.image();
    EXPECT_LE(fits_or_not.size(), image::maximum_size);
    plant.settings.title += std::string(1000, 'x');
    const base::Bytes image = plant.image();
    EXPECT_EQ(Opened(image).image.model(), "");
    EXPECT_EQ(Opened(image).label(2000).name, "Speed");
}

TEST(ImageWriter, never_hands_out_an_image_that_the_reader_refuses) {
    SamplePlant crossed;
    crossed.configuration.governor_node = 4;
    EXPECT_THROW(crossed.image(), std::logic_error);
    SamplePlant dangling;
    dangling.tpdo(4).mapping[0].sub_index = 50;
    EXPECT_THROW(dangling.image(), std::logic_error);
    SamplePlant reserved;
    reserved.tpdo(5).cob_id = 0x585;
    EXPECT_THROW(reserved.image(), std::logic_error);
}

}  // namespace
}  // namespace cgw::test
