#include "driver/decompile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "authoring/from_image.hpp"
#include "base/sha256.hpp"
#include "base/wrap.hpp"
#include "driver/image_parts.hpp"
#include "driver/plant.hpp"
#include "image_writer/image_writer.hpp"

namespace cgw::driver {
namespace {

constexpr std::size_t comment_width = 90;
bool same_bytes(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

// What a gateway does not look at.
bool is_harmless(const PartDifference& part) {
    constexpr std::string_view for_people[] = {"labels", "strings", "model"};
    switch (part.kind) {
        case PartKind::version:
        case PartKind::format:
        case PartKind::configuration_id:
            return true;
        case PartKind::section:
            return std::find(std::begin(for_people), std::end(for_people), part.name) != std::end(for_people);
        case PartKind::header:
        case PartKind::later_section:
            break;
    }
    return false;
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
    const base::Bytes bytes = compile(decompiled.file, decompiled.labels);
    image::Image again;
    if (image::Image::open(bytes, again) != image::Status::ok) {
        decompiled.differing.emplace_back("everything");
        return;
    }
    decompiled.harmless = true;
    for (const PartDifference& part : differing_parts(image, again)) {
        decompiled.harmless = decompiled.harmless && is_harmless(part);
        if (part.kind == PartKind::version) {
            decompiled.other_version = true;
        } else {
            decompiled.differing.push_back(part.name);
        }
    }
    if (decompiled.differing.empty() && !decompiled.other_version && !same_bytes(image.bytes(), bytes)) {
        throw std::logic_error("two images differ in no part that is known");
    }
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
        add_remark(remarks, fmt::format("{} to the identical image{}.", decompiled.compiles(),
                                        decompiled.other_version ? " but for the version of cgw in it" : ""));
    } else if (decompiled.file.valid()) {
        add_remark(remarks, fmt::format("{} to another image, of configuration {}; different: {}.",
                                        decompiled.compiles(), decompiled.new_id,
                                        fmt::join(decompiled.differing, ", ")));
    } else {
        add_remark(remarks, "It is not valid as it stands; cgw check tells why.");
    }
    if (!decompiled.lost.empty()) {
        add_remark(remarks, "What is lost:");
        for (const std::string& lost : decompiled.lost) {
            add_remark(remarks, "- " + lost);
        }
    }
    add_remark(remarks, "Comments, [document], [network] and bit_timing are in no image.");
    return remarks;
}

}  // namespace

bool DecompiledImage::works_alike() const {
    return file.valid() && harmless;
}

std::string_view DecompiledImage::compiles() const {
    return labels ? "It compiles" : "With --no-labels it compiles";
}

DecompiledImage decompile(const image::Image& image, const std::string& path) {
    DecompiledImage decompiled;
    authoring::FileFromImage made = authoring::file_from_image(image, {});
    decompiled.exact = made.has_model;
    decompiled.lost = std::move(made.lost);
    const std::vector<std::string> later = parts_of_a_later_minor(image);
    decompiled.lost.insert(decompiled.lost.end(), later.begin(), later.end());
    decompiled.labels = image.records(image::SectionId::labels).data != nullptr;
    decompiled.file = check_text(path, made.text);
    compare_with(image, decompiled);
    // Comments change nothing of what the text means, only the lines of findings.
    decompiled.text = authoring::file_from_image(image, remarks_of(image, decompiled)).text;
    decompiled.file = check_text(path, decompiled.text);
    return decompiled;
}

}  // namespace cgw::driver
