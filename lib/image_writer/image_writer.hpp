// Dictionary and configuration to a configuration image (image/layout.hpp). Deterministic.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "base/bytes.hpp"
#include "config/configuration.hpp"
#include "dictionary/dictionary.hpp"
#include "parameter/settings.hpp"

namespace cgw::image_writer {

struct Source {
    const parameter::Settings& settings;
    const config::Configuration& configuration;
    const dictionary::Dictionary& dictionary;
    std::array<std::uint8_t, 32> configuration_id{};
    std::array<std::uint16_t, 3> tool_version{};
    bool labels = true;  // and the model, where the image still has room for it
};

// The settings must have passed every check. What was written is verified by the reader before it is
// handed out; an image that the reader refuses is a fault of this program: std::logic_error.
base::Bytes write_image(const Source& source);

}  // namespace cgw::image_writer
