#include "driver/device_description.hpp"

#include <gtest/gtest.h>

#include "diagnostic/rules/eds.hpp"
#include "diagnostic/rules/files.hpp"
#include "diagnostic/rules/firmware.hpp"
#include "dictionary/difference.hpp"
#include "driver/data_sheet.hpp"
#include "driver/outputs.hpp"
#include "driver/plant.hpp"
#include "support/scratch_directory.hpp"

namespace cgw::driver {
namespace {

// An artefact of the sample, as a file.
std::string artefact(const test::ScratchDirectory& directory, const std::string& emitter) {
    const CheckedFile file = check_file(CGW_SAMPLES "/genset.toml");
    const auto plant = Plant::make(file);
    const base::Bytes bytes = emit::find_emitter(emitter)->emit(plant->view(), {});
    return directory.write(emitter + ".file", std::string(bytes.begin(), bytes.end()));
}

dictionary::Side side_of(const DeviceDescription& description) {
    return {.dictionary = description.dictionary,
            .node_id = description.node_id,
            .bare = description.kind == DescriptionKind::image};
}

}  // namespace

TEST(DeviceDescription, is_the_same_from_parameter_file_eds_dcf_xdd_xdc_and_image) {
    const test::ScratchDirectory directory;
    const auto plant = read_device_description(CGW_SAMPLES "/genset.toml");
    ASSERT_TRUE(plant->valid());
    EXPECT_EQ(plant->kind, DescriptionKind::parameter_file);
    EXPECT_EQ(plant->node_id, 12);
    const std::pair<std::string, DescriptionKind> kinds[] = {{"eds", DescriptionKind::data_sheet},
                                                             {"dcf", DescriptionKind::configuration_file},
                                                             {"image", DescriptionKind::image},
                                                             {"xdd", DescriptionKind::xml_description},
                                                             {"xdc", DescriptionKind::xml_configuration}};
    for (const auto& [emitter, kind] : kinds) {
        const auto read = read_device_description(artefact(directory, emitter));
        ASSERT_TRUE(read->valid()) << emitter;
        EXPECT_EQ(read->kind, kind);
        EXPECT_EQ(read->dictionary.objects.size(), plant->dictionary.objects.size());
        EXPECT_TRUE(dictionary::differences(side_of(*plant), side_of(*read)).same()) << emitter;
    }
}

TEST(DeviceDescription, an_image_carries_node_number_and_configuration_id) {
    const test::ScratchDirectory directory;
    const auto image = read_device_description(artefact(directory, "image"));
    const auto plant = read_device_description(CGW_SAMPLES "/genset.toml");
    EXPECT_EQ(image->node_id, 12);
    EXPECT_EQ(image->configuration_id, plant->configuration_id);
    EXPECT_EQ(image->configuration_id.size(), 16U);
}

TEST(DeviceDescription, a_damaged_image_is_refused_with_the_number_that_firmware_shows) {
    const test::ScratchDirectory directory;
    const auto read = read_device_description(directory.write("cut.bin", "CGWI"));
    EXPECT_FALSE(read->valid());
    EXPECT_FALSE(read->unreadable);
    ASSERT_EQ(read->findings.all().size(), 1U);
    EXPECT_EQ(read->findings.all()[0].rule, &diagnostic::rules::image_refused);
    EXPECT_NE(read->findings.all()[0].message.find("status 1"), std::string::npos);
}

TEST(DeviceDescription, a_parameter_file_that_fails_a_check_describes_nothing) {
    const auto read = read_device_description(CGW_SAMPLES "/bad/crossed-node-numbers.toml");
    EXPECT_EQ(read->kind, DescriptionKind::parameter_file);
    EXPECT_FALSE(read->valid());
    EXPECT_TRUE(read->dictionary.objects.empty());
}

TEST(DeviceDescription, reports_what_is_not_there_or_too_large_or_no_description) {
    const auto missing = read_device_description("/nonexistent/device.eds");
    EXPECT_TRUE(missing->unreadable);
    const auto endless = read_device_description("/dev/zero");
    EXPECT_FALSE(endless->unreadable);
    EXPECT_EQ(endless->findings.all().at(0).rule, &diagnostic::rules::file_too_large);
    const auto empty = read_device_description("/dev/null");
    EXPECT_EQ(empty->findings.all().at(0).rule, &diagnostic::rules::eds_text);
}

TEST(DataSheet, keeps_the_text_it_was_read_from) {
    const std::string text = "[1000]\r\nParameterName=Device Type\nDataType=7\nAccessType=ro\n";
    const DataSheet file = read_data_sheet_text("some.eds", text);
    ASSERT_TRUE(file.sheet.has_value());
    EXPECT_EQ(file.document->text(), text);
    EXPECT_EQ(file.sources.at("some.eds"), text);
    EXPECT_EQ(file.sheet->dictionary.objects.at(0).index, 0x1000);
}

}  // namespace cgw::driver
