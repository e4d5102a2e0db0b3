#include "driver/device_description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/bytes.hpp"
#include "base/files.hpp"
#include "base/sha256.hpp"
#include "convert/formats.hpp"
#include "driver/check_file.hpp"
#include "driver/data_sheet.hpp"
#include "driver/plant.hpp"
#include "driver/report_unreadable.hpp"
#include "image/area.hpp"
#include "image_writer/dictionary_of.hpp"
#include "toml/document.hpp"
#include "xdd/reader.hpp"

namespace cgw::driver {
namespace {

constexpr std::array<std::string_view, 6> kind_names{"EDS", "DCF", "parameter file", "image", "XDD", "XDC"};

bool is_image(std::string_view bytes) {
    return bytes.starts_with(
        std::string_view(reinterpret_cast<const char*>(image::magic), sizeof image::magic));
}

// The tables of one are sections to an EDS, and none that it could have.
bool is_parameter_file(const eds::Document& document) {
    constexpr std::array<std::string_view, 3> tables{"governor", "governor.parameters", "gateway.parameters"};
    return std::any_of(tables.begin(), tables.end(),
                       [&](std::string_view table) { return document.find(table) != nullptr; });
}

// What is neither XML nor a data sheet is told as what its name says.
bool is_named_xml(std::string_view path) {
    const convert::Format* const format = convert::format_of_file(path);
    return format != nullptr &&
           (format->medium == convert::Medium::xdd || format->medium == convert::Medium::xdc);
}

void take_image(DeviceDescription& description, const std::string& text) {
    description.kind = DescriptionKind::image;
    const base::Bytes bytes = base::to_bytes(text);
    image::Image image;
    const image::Status status = image::Image::open(image::image_in(bytes), image);
    if (status != image::Status::ok) {
        report_refused(description.path, status, description.findings);
        return;
    }
    description.dictionary = image_writer::dictionary_of(image);
    description.node_id = image.can2().own_node;
    description.configuration_id = base::short_id(image.configuration_id());
}

base::Result<void> take_parameter_file(DeviceDescription& description, std::string text) {
    description.kind = DescriptionKind::parameter_file;
    CheckedFile file = check_text(description.path, std::move(text));
    description.sources = std::move(file.sources);
    description.unreadable = file.unreadable;
    const bool valid = file.valid();
    description.findings = std::move(file.findings);
    if (!valid) {
        return {};
    }
    const auto plant = Plant::make(file);
    if (!plant) {
        return tl::unexpected(plant.error());
    }
    description.dictionary = plant->view().dictionary;
    description.node_id = file.configuration.node_id;
    description.configuration_id = plant->view().configuration_id_text;
    return {};
}

void take_data_sheet(DeviceDescription& description, std::string text) {
    convert::PassedOver passed_over = convert::passed_over_in(text);
    description.sections = std::move(passed_over.sections);
    description.unread = std::move(passed_over.unread);
    DataSheet file = read_data_sheet_text(description.path, std::move(text));
    description.dictionary = std::move(file.sheet->dictionary);
    description.commissioning = std::move(file.sheet->commissioning);
    if (description.commissioning) {
        description.kind = DescriptionKind::configuration_file;
        description.node_id = description.commissioning->node_id;
    }
    description.findings = std::move(file.findings);
    description.sources = std::move(file.sources);
}

void take_xml(DeviceDescription& description, std::string text) {
    xdd::Sheet sheet = xdd::read(text, description.path, description.findings);
    description.findings.sort();
    description.unread = std::move(sheet.unread);
    description.sources.emplace(description.path, std::move(text));
    description.kind =
        sheet.commissioning ? DescriptionKind::xml_configuration : DescriptionKind::xml_description;
    description.dictionary = std::move(sheet.dictionary);
    description.commissioning = std::move(sheet.commissioning);
    if (description.commissioning) {
        description.node_id = description.commissioning->node_id;
    }
}

}  // namespace

std::string_view to_text(DescriptionKind kind) {
    return kind_names[static_cast<std::size_t>(kind)];
}

base::Result<DeviceDescription> read_device_description(const std::string& path) {
    DeviceDescription description;
    description.path = path;
    base::Result<std::string> text = base::read_file(path, eds::largest_text);
    if (!text) {
        description.unreadable = report_unreadable(path, text.error(), description.findings);
    } else if (is_image(*text)) {
        take_image(description, *text);
    } else if (xdd::is_xml(*text) || (is_named_xml(path) && !eds::is_sheet(eds::Document(*text)))) {
        take_xml(description, std::move(*text));
    } else if (is_parameter_file(eds::Document(*text))) {
        if (const auto taken = take_parameter_file(description, std::move(*text)); !taken) {
            return tl::unexpected(taken.error());
        }
    } else {
        take_data_sheet(description, std::move(*text));
    }
    return description;
}

}  // namespace cgw::driver
