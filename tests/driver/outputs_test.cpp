#include "driver/outputs.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "driver/check_file.hpp"
#include "driver/plant.hpp"

namespace cgw::driver {

TEST(DependencyFile, escapes_what_make_and_ninja_would_split_or_expand) {
    EXPECT_EQ(dependency_file("out/a b.bin", {"x.toml", "costs $5 #1.toml"}),
              "out/a\\ b.bin: \\\n  x.toml \\\n  costs\\ $$5\\ \\#1.toml\n"
              "costs\\ $$5\\ \\#1.toml:\n");
}

TEST(DependencyFile, has_an_empty_rule_for_each_file_but_the_first) {
    EXPECT_EQ(dependency_file("o", {"x", "y", "z"}), "o: \\\n  x \\\n  y \\\n  z\ny:\nz:\n");
    EXPECT_EQ(dependency_file("o", {"x"}), "o: \\\n  x\n");
    EXPECT_EQ(dependency_file("o", {"-", "y"}), "o: \\\n  y\ny:\n");
    EXPECT_EQ(dependency_file("o", {}), "o:\n");
}

TEST(BuildArtefacts, have_the_names_that_are_listed) {
    const CheckedFile file = check_file(CGW_SAMPLES "/minimal.toml");
    ASSERT_TRUE(file.valid());
    const auto plant = Plant::make(file);
    std::vector<std::string> names;
    for (const Artefact& artefact : build_artefacts(plant->view())) {
        names.push_back(artefact.file_name);
        EXPECT_FALSE(artefact.content.empty()) << artefact.file_name;
    }
    EXPECT_EQ(names, build_file_names());
    std::sort(names.begin(), names.end());
    EXPECT_EQ(std::unique(names.begin(), names.end()), names.end());
}

TEST(BuildArtefacts, carry_the_name_of_the_data_sheet) {
    emit::Options options;
    options.eds_name = "starboard.eds";
    const std::vector<std::string> names = build_file_names(options);
    EXPECT_EQ(std::count(names.begin(), names.end(), "starboard.eds"), 1);
    EXPECT_EQ(std::count(names.begin(), names.end(), "starboard.dcf"), 1);
    EXPECT_EQ(std::count(names.begin(), names.end(), "gateway-config.bin"), 1);
    for (const std::string& name : names) {
        EXPECT_EQ(name.find("CANopenGateway"), std::string::npos) << name;
    }
}

TEST(BuildArtefacts, hold_the_name_that_their_file_has) {
    const CheckedFile file = check_file(CGW_SAMPLES "/minimal.toml");
    ASSERT_TRUE(file.valid());
    const auto plant = Plant::make(file);
    emit::Options options;
    options.eds_name = "starboard.eds";
    for (const Artefact& artefact : build_artefacts(plant->view(), options)) {
        const std::string text(artefact.content.begin(), artefact.content.end());
        if (artefact.file_name.starts_with("starboard") && text.starts_with("[FileInfo]")) {
            EXPECT_NE(text.find("FileName=" + artefact.file_name + "\r\n"), std::string::npos)
                << artefact.file_name;
        }
    }
}

}  // namespace cgw::driver
