#include "driver/outputs.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "driver/check_file.hpp"
#include "driver/plant.hpp"

namespace cgw::driver {

TEST(DependencyFile, escapes_what_make_and_ninja_would_split_or_expand) {
    EXPECT_EQ(dependency_file("out/a b.bin", {"x.toml", "costs $5 #1.toml"}),
              "out/a\\ b.bin: \\\n  x.toml \\\n  costs\\ $$5\\ \\#1.toml\n");
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

}  // namespace cgw::driver
