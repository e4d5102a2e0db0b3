// Any text is read for a scenario, and what it names is looked up in a plant.
#include "driver/scenario_file.hpp"
#include "fuzz/fuzz.hpp"

namespace cgw::fuzz {
namespace {

const image::Image& genset() {
    static const base::Bytes bytes = image_of(driver::check_file(CGW_SAMPLES "/genset.toml"), true);
    static const image::Image image = [] {
        image::Image opened;
        demand(image::Image::open(bytes, opened) == image::Status::ok, "the genset's image is accepted");
        return opened;
    }();
    return image;
}

}  // namespace

void scenario(Input input) {
    driver::ScenarioFile file =
        driver::read_scenario_text("scenario.toml", std::string(input.begin(), input.end()));
    if (file.valid()) {
        scenario::bind(file.scenario, genset(), file.findings);
    }
    demand_sound({"scenario.toml", file.findings.all()}, file.sources);
}

}  // namespace cgw::fuzz
