#include "driver/decompile.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "authoring/from_image.hpp"
#include "base/sha256.hpp"
#include "base/wrap.hpp"
#include "driver/plant.hpp"
#include "image_writer/image_writer.hpp"
#include "inspect/fields.hpp"

namespace cgw::driver {
namespace {

constexpr std::size_t comment_width = 90;
constexpr std::string_view id_part = "configuration id";

bool same_bytes(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

std::vector<std::string> differing_parts(const image::Image& a, const image::Image& b) {
    std::vector<std::string> parts;
    if (!same_bytes(a.configuration_id(), b.configuration_id())) {
        parts.emplace_back(id_part);
    }
    for (const inspect::Record& record : inspect::all_records()) {
        if (record.is_section()) {
            const image::Records& of_a = a.records(record.section);
            const image::Records& of_b = b.records(record.section);
            if (!same_bytes({of_a.data, of_a.size}, {of_b.data, of_b.size})) {
                parts.emplace_back(record.name);
            }
        }
    }
    return parts;
}

// The image of the file, with labels if the one it came from has them.
base::Bytes compile(const CheckedFile& file, bool labels) {
    const auto plant = Plant::make(file);
    const emit::Plant view = plant.value().view();
    return image_writer::write_image({.settings = view.settings,
                                      .configuration = view.configuration,
                                      .dictionary = view.dictionary,
                                      .configuration_id = view.configuration_id,
                                      .tool_version = view.tool_version,
                                      .labels = labels});
}

void compare_with(const image::Image& image, DecompiledImage& decompiled) {
    if (!decompiled.file.valid()) {
        return;
    }
    decompiled.new_id = short_configuration_id(decompiled.file.settings);
    const bool labels = image.records(image::SectionId::labels).data != nullptr;
    const base::Bytes bytes = compile(decompiled.file, labels);
    image::Image again;
    if (image::Image::open(bytes, again) != image::Status::ok) {
        decompiled.differing.emplace_back("everything");
        return;
    }
    decompiled.differing = differing_parts(image, again);
    decompiled.other_version = !same_bytes(image.bytes(), bytes) && decompiled.differing.empty();
}

void add_remark(std::vector<std::string>& remarks, std::string_view text) {
    const std::vector<std::string> lines = base::wrap(text, comment_width);
    remarks.insert(remarks.end(), lines.begin(), lines.end());
}

std::vector<std::string> remarks_of(const image::Image& image, const DecompiledImage& decompiled) {
    std::vector<std::string> remarks;
    const std::string id = base::short_id(image.configuration_id());
    add_remark(remarks, fmt::format("From the image of configuration {}, by cgw image decompile.", id));
    if (decompiled.identical()) {
        add_remark(remarks, decompiled.other_version
                                ? "It compiles to the identical image but for the version of cgw in it."
                                : "It compiles to the identical image.");
    } else if (decompiled.file.valid()) {
        add_remark(remarks, fmt::format("It compiles to another image, of configuration {}; different: {}.",
                                        decompiled.new_id, fmt::join(decompiled.differing, ", ")));
    } else {
        add_remark(remarks, "It is not valid as it stands; cgw check tells why.");
    }
    if (!decompiled.lost.empty()) {
        add_remark(remarks, "What the image does not hold, and is lost:");
        for (const std::string& lost : decompiled.lost) {
            add_remark(remarks, "- " + lost);
        }
    }
    add_remark(remarks, "Comments, [document], [network] and bit_timing are in no image.");
    return remarks;
}

}  // namespace

bool DecompiledImage::works_alike() const {
    constexpr std::string_view harmless[] = {id_part, "labels", "strings", "model"};
    return file.valid() && std::all_of(differing.begin(), differing.end(), [&](const std::string& part) {
               return std::find(std::begin(harmless), std::end(harmless), part) != std::end(harmless);
           });
}

DecompiledImage decompile(const image::Image& image, const std::string& path) {
    DecompiledImage decompiled;
    authoring::FileFromImage made = authoring::file_from_image(image, {});
    decompiled.exact = made.has_model;
    decompiled.lost = std::move(made.lost);
    decompiled.file = check_text(path, made.text);
    compare_with(image, decompiled);
    // Comments change nothing of what the text means, only the lines of findings.
    decompiled.text = authoring::file_from_image(image, remarks_of(image, decompiled)).text;
    decompiled.file = check_text(path, decompiled.text);
    return decompiled;
}

}  // namespace cgw::driver
