#include "driver/scenario_file.hpp"

#include <utility>

#include "base/files.hpp"
#include "driver/plant.hpp"
#include "driver/report_unreadable.hpp"
#include "emit/emitter.hpp"
#include "toml/document.hpp"

namespace cgw::driver {

ScenarioFile read_scenario_file(const std::string& path) {
    base::Result<std::string> text = base::read_file(path, toml::maximum_file_size);
    if (text) {
        return read_scenario_text(path, std::move(*text));
    }
    ScenarioFile file;
    file.unreadable = report_unreadable(path, text.error(), file.findings);
    return file;
}

ScenarioFile read_scenario_text(const std::string& path, std::string text) {
    ScenarioFile file;
    file.scenario = scenario::read_scenario(text, path, file.findings);
    file.sources[path] = std::move(text);
    file.findings.sort();
    return file;
}

base::Result<base::Bytes> image_bytes(const CheckedFile& file) {
    const base::Result<Plant> plant = Plant::make(file);
    if (!plant) {
        return tl::unexpected(plant.error());
    }
    return emit::find_emitter("image")->emit(plant->view(), {});
}

}  // namespace cgw::driver
