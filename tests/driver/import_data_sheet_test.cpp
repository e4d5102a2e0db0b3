#include "driver/import_data_sheet.hpp"

#include <gtest/gtest.h>

#include "driver/plant.hpp"
#include "support/scratch_directory.hpp"

namespace cgw::driver {
namespace {

class ImportDataSheet : public testing::TestWithParam<const char*> {
  protected:
    test::ScratchDirectory directory;
    CheckedFile original = check_file(std::string(CGW_SAMPLES "/") + GetParam() + ".toml");

    DeviceDescription description(const std::string& emitter) {
        const auto plant = Plant::make(original);
        const base::Bytes bytes = emit::find_emitter(emitter)->emit(plant->view(), {});
        return *read_device_description(
            directory.write("gateway." + emitter, std::string(bytes.begin(), bytes.end())));
    }

    double governor(const ImportedDataSheet& imported, std::uint16_t number) const {
        return imported.file.settings.governor.value(number);
    }
};

}  // namespace

TEST_P(ImportDataSheet, finds_every_word_sensor_identifier_and_time_again) {
    const ImportedDataSheet imported = import_data_sheet(description("dcf"), "new.toml", {});
    const auto is_determined = [](std::uint16_t number) {
        return (number >= 900 && number < 930) || (number >= 4900 && number < 4930) ||
               (number >= 14401 && number <= 14402);
    };
    for (const auto& [number, assignment] : original.settings.governor.all()) {
        if (is_determined(number)) {
            EXPECT_EQ(governor(imported, number), assignment.value) << number;
        }
    }
    const config::Configuration& a = original.configuration;
    const config::Configuration& b = imported.file.configuration;
    EXPECT_EQ(a.node_id, b.node_id);
    EXPECT_EQ(a.can2.bit_rate_kbit, b.can2.bit_rate_kbit);
    EXPECT_EQ(a.partner_node_id, b.partner_node_id);
    EXPECT_EQ(a.heartbeat_consumer.effective_us, b.heartbeat_consumer.effective_us);
    EXPECT_EQ(a.heartbeat_producer.effective_us, b.heartbeat_producer.effective_us);
    for (std::size_t i = 0; i < facts::tpdo_count; ++i) {
        EXPECT_EQ(a.pdos[i].active, b.pdos[i].active) << i;
        EXPECT_EQ(a.pdos[i].cob_id, b.pdos[i].cob_id) << i;
        EXPECT_EQ(a.pdos[i].mapping.size(), b.pdos[i].mapping.size()) << i;
        if (a.pdos[i].active) {
            EXPECT_EQ(a.pdos[i].time.effective_us, b.pdos[i].time.effective_us) << i;
        }
    }
}

TEST_P(ImportDataSheet, differs_in_nothing_but_the_switches) {
    const ImportedDataSheet imported = import_data_sheet(description("eds"), "new.toml", {.node_id = 12});
    for (const dictionary::Difference& each : imported.differences.all) {
        const bool of_switches = each.index == 0x1400 || each.index == 0x1600 || each.index == 0x2003;
        EXPECT_TRUE(of_switches) << subject_text(each) << " " << each.aspect_text << ": " << each.a << " -> "
                                 << each.b;
    }
    EXPECT_NE(imported.text.find("does not say"), std::string::npos);
}

TEST_P(ImportDataSheet, keeps_the_title) {
    const ImportedDataSheet imported = import_data_sheet(description("eds"), "new.toml", {});
    EXPECT_EQ(imported.file.settings.title, original.settings.title);
    const ImportedDataSheet renamed = import_data_sheet(description("eds"), "new.toml", {.title = "Other"});
    EXPECT_EQ(renamed.file.settings.title, "Other");
}

TEST_P(ImportDataSheet, says_that_an_eds_states_no_node_number_and_bit_rate) {
    const auto says = [](const ImportedDataSheet& imported, std::string_view what) {
        return std::any_of(imported.undetermined.begin(), imported.undetermined.end(),
                           [&](const std::string& each) { return each.find(what) != std::string::npos; });
    };
    const ImportedDataSheet of_eds = import_data_sheet(description("eds"), "new.toml", {});
    EXPECT_TRUE(says(of_eds, "(427)"));
    EXPECT_TRUE(says(of_eds, "(426)"));
    EXPECT_FALSE(says(import_data_sheet(description("eds"), "new.toml", {.node_id = 12}), "(427)"));
    EXPECT_FALSE(says(import_data_sheet(description("dcf"), "new.toml", {}), "(427)"));
}

INSTANTIATE_TEST_SUITE_P(Samples, ImportDataSheet, testing::Values("genset", "minimal", "manual-example"),
                         [](const auto& test) {
                             std::string name = test.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

}  // namespace cgw::driver
