// Whatever image is accepted gives a parameter file that can be read, and what that file compiles to comes
// back from its own image as it was.
#include <algorithm>

#include "authoring/from_image.hpp"
#include "diagnostic/rules/files.hpp"
#include "diagnostic/rules/keys.hpp"
#include "driver/decompile.hpp"
#include "fuzz/fuzz.hpp"
#include "parameter/settings.hpp"

namespace cgw::fuzz {
namespace {

constexpr const char* path = "decompiled.toml";

bool is_about_form(const diagnostic::Diagnostic& finding) {
    namespace rules = diagnostic::rules;
    const diagnostic::Rule* const form[] = {
        &rules::toml_syntax, &rules::toml_nesting, &rules::toml_number_range, &rules::file_not_utf8,
        &rules::key_unknown, &rules::key_type,     &rules::parameter_unknown, &rules::parameter_duplicate};
    return std::find(std::begin(form), std::end(form), finding.rule) != std::end(form);
}

void demand_well_formed(const driver::CheckedFile& file) {
    for (const diagnostic::Diagnostic& finding : file.findings.all()) {
        demand(!is_about_form(finding), "a decompiled file is well-formed: " + finding.message);
    }
    demand_sound({file.path, file.findings.all(), file.not_verified}, file.sources);
}

// Our own image comes back, with labels and without.
void demand_round_trip(const driver::CheckedFile& file, bool labels) {
    const base::Bytes bytes = image_of(file, labels);
    image::Image image;
    demand(image::Image::open(bytes, image) == image::Status::ok, "our own image is accepted");
    const driver::DecompiledImage again = driver::decompile(image, path);
    demand(again.file.valid(), "our own image gives a valid file");
    demand(labels ? again.identical() : again.works_alike(), "our own image comes back");
}

}  // namespace

void decompile(Input input) {
    image::Image image;
    if (image::Image::open(input, image) != image::Status::ok) {
        return;
    }
    const auto basis = sometimes(input, 2) ? authoring::Basis::sections : authoring::Basis::bare;
    demand_well_formed(driver::check_text(path, authoring::file_from_image(image, {"a remark"}, basis).text));
    const driver::DecompiledImage made = driver::decompile(image, path);
    demand_well_formed(made.file);
    if (!made.file.valid()) {
        return;
    }
    if (made.exact && made.lost.empty()) {
        const auto id = parameter::configuration_id(made.file.settings);
        demand(std::equal(id.begin(), id.end(), image.configuration_id().begin()),
               "a file from the model has the image's configuration id");
    }
    demand_round_trip(made.file, !sometimes(input, 3));
}

}  // namespace cgw::fuzz
