// Images of the shipped samples and of the plant made by hand.
#pragma once

#include <string>
#include <vector>

#include "driver/check_file.hpp"
#include "driver/plant.hpp"
#include "emit/emitter.hpp"
#include "support/sample_plant.hpp"

namespace cgw::test {

inline base::Bytes image_of_sample(const std::string& name) {
    const driver::CheckedFile file = driver::check_file(std::string(CGW_SAMPLES) + "/" + name);
    EXPECT_TRUE(file.valid()) << name;
    const auto plant = driver::Plant::make(file);
    return emit::find_emitter("image")->emit(plant.value().view(), {});
}

inline std::vector<base::Bytes> sample_images() {
    return {image_of_sample("genset.toml"), image_of_sample("minimal.toml"),
            image_of_sample("manual-example.toml"), SamplePlant().image(), SamplePlant().image(false)};
}

}  // namespace cgw::test
