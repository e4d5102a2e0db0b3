// Any text is read to its end; a valid file gives every artefact, and both its image and its entry sheet say
// what the file says.
#include "authoring/clone.hpp"
#include "catalogue/catalogue.hpp"
#include "check/checks.hpp"
#include "check/not_verified.hpp"
#include "driver/decompile.hpp"
#include "driver/outputs.hpp"
#include "driver/plant.hpp"
#include "fuzz/fuzz.hpp"
#include "input/parameter_file.hpp"
#include "input/parameter_table.hpp"
#include "parameter/canonical_model.hpp"

namespace cgw::fuzz {
namespace {

constexpr const char* path = "plant.toml";

// As driver::check_text() does it, but for the catalogues, which are no files here.
driver::CheckedFile check(const Parts& parts) {
    driver::CheckedFile file;
    file.path = path;
    file.catalogue = std::make_unique<parameter::Catalogue>(catalogue::shipped_rows());
    const auto load = [&](const std::string& name) -> base::Result<std::string> {
        if (name.size() % 7 == 0) {
            return base::failure("cannot read");
        }
        return parts.second;
    };
    input::ReadResult read =
        input::read_parameter_file(parts.first, path, *file.catalogue, load, file.findings);
    file.complete = read.usable && !file.findings.has_errors();
    file.sources = std::move(read.file.sources);
    file.sources[path] = parts.first;
    file.settings = std::move(read.file.settings);
    if (read.usable) {
        file.configuration = config::resolve(file.settings, *file.catalogue);
        const check::Context context{file.settings, *file.catalogue, file.configuration, file.findings};
        check::check(context);
        file.not_verified = check::not_verified(context);
    }
    file.findings.sort();
    return file;
}

void demand_model_comes_back(const parameter::Settings& settings) {
    const auto model = parameter::read_canonical_text(parameter::canonical_text(settings));
    demand(model.has_value(), "the canonical text can be read");
    demand(model->title == settings.title && model->main_cycle_us == settings.main_cycle_us,
           "the canonical text says the same");
}

void demand_image_comes_back(const driver::CheckedFile& file) {
    const base::Bytes bytes = image_of(file, true);
    image::Image image;
    demand(image::Image::open(bytes, image) == image::Status::ok, "our own image is accepted");
    const driver::DecompiledImage made = driver::decompile(image, "decompiled.toml");
    demand(made.exact && made.file.valid(), "our own image gives a valid file");
    demand(made.identical() || !made.lost.empty(), "our own image comes back");
}

void demand_sheet_comes_back(const driver::CheckedFile& file, const emit::Plant& plant) {
    for (const char* format : {"md", "csv"}) {
        emit::Options options;
        options.format = format;
        const base::Bytes sheet = emit::find_emitter("entry-sheet")->emit(plant, options);
        for (const parameter::Device device : {parameter::Device::governor, parameter::Device::gateway}) {
            diagnostic::Findings findings;
            const input::PrintedTable table = input::read_parameter_table(
                std::string(sheet.begin(), sheet.end()), "sheet", device, *file.catalogue, findings);
            demand(!findings.has_errors(), "our own sheet can be read");
            for (const auto& [number, assignment] : file.settings.of(device).all()) {
                const auto value = table.values.find(number);
                const double read = value == table.values.end() ? 0 : value->second.value;
                demand(read == assignment.value, "our own sheet says the same");
            }
        }
    }
}

void demand_clones(const driver::CheckedFile& file, const std::string& text) {
    diagnostic::Findings findings;
    const std::uint8_t node = file.configuration.node_id == 17 ? 18 : 17;
    const auto copy =
        authoring::clone_text(text, file.settings, file.configuration, {node, "a copy", true}, findings);
    demand(copy.has_value() || findings.has_errors(), "a plant is copied, or a finding says why not");
    demand_sound({path, findings.all()}, file.sources);
}

}  // namespace

void parameter_file(Input input) {
    const Parts parts = split(input, "#### catalogue");
    const driver::CheckedFile file = check(parts);
    demand_sound({file.path, file.findings.all(), file.not_verified}, file.sources);
    if (!file.valid()) {
        return;
    }
    demand(file.complete, "a valid file is complete");
    demand_model_comes_back(file.settings);
    if (sometimes(input, 3)) {
        demand_image_comes_back(file);
    }
    if (sometimes(input, 5)) {
        demand_clones(file, parts.first);
    }
    if (!sometimes(input, 2)) {
        return;
    }
    const auto plant = driver::Plant::make(file);
    demand(plant.has_value(), "a valid file makes a plant");
    demand(!driver::build_artefacts(plant->view()).empty(), "a valid file gives artefacts");
    demand_sheet_comes_back(file, plant->view());
}

}  // namespace cgw::fuzz
