// The configuration image: as it is, and at an address in the formats of programmers.
#include <fmt/format.h>

#include "emit/artefacts.hpp"
#include "firmware_file/intel_hex.hpp"
#include "firmware_file/s_record.hpp"
#include "image_writer/image_writer.hpp"

namespace cgw::emit {
namespace {

// The header record tells which configuration it is, the count that no record is missing.
std::string s_record_of(const Plant& plant, const firmware_file::Memory& memory) {
    firmware_file::SRecord file;
    file.memory = memory;
    file.headers = {
        {0, base::to_bytes(fmt::format("cgw {} {}", plant.tool_version_text, plant.configuration_id_text))}};
    file.counted = true;
    return firmware_file::write_s_record(file);
}

std::string intel_hex_of(const firmware_file::Memory& memory) {
    firmware_file::IntelHex file;
    file.memory = memory;
    return firmware_file::write_intel_hex(file);
}

}  // namespace

base::Bytes emit_image(const Plant& plant, const Options& options) {
    base::Bytes image = image_writer::write_image({.settings = plant.settings,
                                                   .configuration = plant.configuration,
                                                   .dictionary = plant.dictionary,
                                                   .configuration_id = plant.configuration_id,
                                                   .tool_version = plant.tool_version,
                                                   .labels = options.labels});
    if (options.format == "ihex") {
        return base::to_bytes(intel_hex_of({options.base, image}));
    }
    if (options.format == "srec") {
        return base::to_bytes(s_record_of(plant, {options.base, image}));
    }
    return image;
}

}  // namespace cgw::emit
