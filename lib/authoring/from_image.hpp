// A parameter file from a configuration image.
#pragma once

#include <string>
#include <vector>

#include "authoring/parameter_file_text.hpp"
#include "image/image.hpp"

namespace cgw::authoring {

struct FileFromImage {
    std::string text;               // without what `lost` says
    std::vector<std::string> lost;  // what the image does not say, one sentence without period each
    bool has_model = false;  // the image holds the canonical model: all that makes up the configuration
};

// From the canonical model where the image has one, and its SHA-256 is the configuration id; else the best
// that PDOs, buses, objects and labels allow. `remarks`: lines of comment at the top.
// sections: as if there were no model; bare: and no labels either, as a gateway reads it
enum class Basis : std::uint8_t { model, sections, bare };
FileFromImage file_from_image(const image::Image& image, const std::vector<std::string>& remarks,
                              Basis basis = Basis::model);

// True when the model's SHA-256 is the configuration id, or there is no model.
bool model_fits(const image::Image& image);

}  // namespace cgw::authoring
