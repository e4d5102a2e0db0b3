#include "driver/import_data_sheet.hpp"

#include <gtest/gtest.h>

#include "driver/plant.hpp"
#include "support/golden.hpp"
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

TEST_P(ImportDataSheet, with_the_plant_it_comes_from_makes_the_same_configuration) {
    for (const std::string emitter : {"eds", "dcf", "xdd"}) {
        const ImportedDataSheet imported =
            import_data_sheet(description(emitter), "new.toml", {.plant = &original});
        EXPECT_TRUE(imported.file.valid());
        EXPECT_TRUE(imported.differences.same());
        EXPECT_TRUE(imported.contradictions.empty()) << imported.contradictions.front();
        EXPECT_TRUE(imported.undetermined.empty()) << imported.undetermined.front();
        EXPECT_EQ(parameter::canonical_text(imported.file.settings),
                  parameter::canonical_text(original.settings));
        const parameter::Settings& settings = imported.file.settings;
        EXPECT_EQ(settings.document.created, original.settings.document.created);
        EXPECT_EQ(settings.document.author, original.settings.document.author);
        EXPECT_EQ(settings.document.revision, original.settings.document.revision);
        EXPECT_EQ(settings.network_nodes.size(), original.settings.network_nodes.size());
        EXPECT_EQ(settings.can1_bit_timing.has_value(), original.settings.can1_bit_timing.has_value());
        EXPECT_EQ(settings.can2_bit_timing.has_value(), original.settings.can2_bit_timing.has_value());
    }
}

// The data sheet counts, whatever the plant says beside it; only which switch is in which bit it never says.
TEST_P(ImportDataSheet, with_any_other_plant_configures_the_gateway_of_the_data_sheet) {
    for (const std::string sample : {"genset", "minimal", "manual-example"}) {
        const CheckedFile other = check_file(CGW_SAMPLES "/" + sample + ".toml");
        if (other.configuration.switches.empty() && !original.configuration.switches.empty()) {
            continue;
        }
        const ImportedDataSheet imported =
            import_data_sheet(description("dcf"), "new.toml", {.plant = &other});
        for (const dictionary::Difference& each : imported.differences.all) {
            ADD_FAILURE() << sample << ": " << subject_text(each) << " " << each.aspect_text << ": " << each.a
                          << " -> " << each.b;
        }
        EXPECT_EQ(imported.contradictions.empty(), sample == GetParam()) << sample;
    }
}

INSTANTIATE_TEST_SUITE_P(Samples, ImportDataSheet, testing::Values("genset", "minimal", "manual-example"),
                         [](const auto& test) {
                             std::string name = test.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

namespace {

// The data sheet of genset.toml, and genset.toml with one text in it replaced.
class ImportWithPlant : public testing::Test {
  protected:
    test::ScratchDirectory directory;
    const std::string text = test::read_text(CGW_SAMPLES "/genset.toml");

    ImportedDataSheet import(const std::string& before, const std::string& after) {
        const CheckedFile genset = check_file(CGW_SAMPLES "/genset.toml");
        const auto plant = Plant::make(genset);
        const base::Bytes bytes = emit::find_emitter("dcf")->emit(plant->view(), {});
        const auto sheet =
            read_device_description(directory.write("gateway.dcf", std::string(bytes.begin(), bytes.end())));
        std::string changed = text;
        const std::size_t at = changed.find(before);
        EXPECT_NE(at, std::string::npos) << before;
        changed.replace(at, before.size(), after);
        const CheckedFile other = check_text("plant.toml", changed);
        EXPECT_TRUE(other.valid()) << after;
        return import_data_sheet(*sheet, "new.toml", {.plant = &other});
    }
};

using Texts = std::vector<std::string>;

}  // namespace

TEST_F(ImportWithPlant, tells_what_contradicts_the_data_sheet_and_takes_the_data_sheet) {
    const struct {
        std::string before;
        std::string after;
        Texts contradictions;
    } cases[] = {
        {"[2000, 2031, 2300, 2918]", "[2000, 2031, 2300]", {}},
        {"[2000, 2031, 2300, 2918]",
         "[2000, 0, 2031, 2300]",
         {"governor 16401 CanOpTPDO4Assign(1): 2031, not 0",
          "governor 16402 CanOpTPDO4Assign(2): 2300, not 2031",
          "governor 16403 CanOpTPDO4Assign(3): 2918, not 2300"}},
        {"[125, 500, 1000]", "[140, 500, 1000]", {}},  // 8 main cycles as well
        {"[125, 500, 1000]", "[125, 600, 1000]", {"governor 16461 CanOpTPDO4-16Cyc(1): 500 ms, not 600 ms"}},
        {"title = \"Genset 2, starboard\"",
         "title = \"Genset 3\"",
         {"title: Genset 2, starboard, not Genset 3"}},
        {"FunctIdleSpeed = 1", "FunctIdleSpeed = 5", {}},
        {"\n910 = 6 ", "\n910 = 5 ", {"governor 910: 6, not 5"}},
        {"AssignIn_CurrentLoad = 9",
         "AssignIn_CurrentLoad = 10",
         {"governor 917 AssignIn_CurrentLoad: 9, not 10"}},
        {"CanOpenMyNodeID = 12", "CanOpenMyNodeID = 13", {"gateway 427 CanOpenMyNodeID: 12, not 13"}},
        {"CanBaudrate = 250", "CanBaudrate = 250  # as on the label", {}},
    };
    for (const auto& each : cases) {
        const ImportedDataSheet imported = import(each.before, each.after);
        EXPECT_EQ(imported.contradictions, each.contradictions) << each.after;
        EXPECT_TRUE(imported.differences.same()) << each.after;
        EXPECT_TRUE(imported.file.valid()) << each.after;
        for (const std::string& told : each.contradictions) {
            EXPECT_NE(imported.text.find("# - " + told), std::string::npos) << told;
        }
    }
}

}  // namespace cgw::driver
