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

// The configuration id is that of the model.
inline base::Bytes image_by_hand(bool labels = true, const std::string& title = "") {
    SamplePlant plant;
    plant.settings.title = title.empty() ? plant.settings.title : title;
    plant.configuration_id = parameter::configuration_id(plant.settings);
    return plant.image(labels);
}

inline std::vector<base::Bytes> sample_images() {
    return {image_of_sample("genset.toml"), image_of_sample("minimal.toml"),
            image_of_sample("manual-example.toml"), image_by_hand(), image_by_hand(false)};
}

}  // namespace cgw::test
