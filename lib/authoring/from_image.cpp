#include "authoring/from_image.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "authoring/image_draft.hpp"
#include "base/sha256.hpp"
#include "catalogue/catalogue.hpp"
#include "catalogue/values.hpp"
#include "facts/gateway.hpp"
#include "parameter/value_text.hpp"

namespace cgw::authoring {
namespace {

using parameter::CanonicalRow;
using parameter::Device;
using parameter::Row;

// A declaration adds measurements, switches and sensors of the governor, and fills blanks of what ships. The
// name of an array's element, "Name(0)", it cannot say, and what ships without a name needs one.
bool can_be_declared(const CanonicalRow& row, const parameter::Catalogue& shipped) {
    if (row.device != Device::governor) {
        return false;
    }
    if (const Row* known = shipped.find(row.device, row.number); known != nullptr) {
        return catalogue::is_name(row.name) || (row.name == known->name && !row.name.empty());
    }
    return row.list == parameter::List::measurement ||
           (row.role != parameter::Role::none && catalogue::is_name(row.name));
}

// What ships has its name anyway; a measurement gets one that it can have.
bool loses_name(CanonicalRow& row, const parameter::Catalogue& shipped) {
    if (catalogue::is_name(row.name) || shipped.find(row.device, row.number) != nullptr) {
        return false;
    }
    row.name = fmt::format("Measurement{}", row.number);
    return true;
}

std::string numbers_text(std::vector<std::string> numbers) {
    constexpr std::size_t shown = 8;
    const std::size_t more = numbers.size() > shown ? numbers.size() - shown : 0;
    numbers.resize(numbers.size() - more);
    return fmt::format("{}{}", fmt::join(numbers, ", "), more != 0 ? fmt::format(" and {} more", more) : "");
}

void note_lost(std::string_view what, std::vector<std::string> numbers, ImageDraft& to) {
    if (!numbers.empty()) {
        to.lost.push_back(fmt::format("{}: {}", what, numbers_text(std::move(numbers))));
    }
}

void draft_model(const parameter::CanonicalModel& model, ImageDraft& to) {
    to.draft.title = model.title;
    to.draft.identity = model.identity;
    if (model.main_cycle_us != facts::usual_governor_main_cycle_us) {
        to.draft.main_cycle_us = model.main_cycle_us;
    }
    draft_rows(model, to);
    std::vector<std::string> values;
    for (const parameter::CanonicalValue& value : model.values) {
        if (!to.set(value.device, value.number, value.value)) {
            values.push_back(fmt::format("{} {}", parameter::to_text(value.device), value.number));
        }
    }
    note_lost("values of parameters that only a catalogue file knows", std::move(values), to);
}

}  // namespace

void draft_rows(const parameter::CanonicalModel& model, ImageDraft& to) {
    const parameter::Catalogue shipped(catalogue::shipped_rows());
    std::vector<std::string> rows;
    std::vector<std::string> names;
    for (CanonicalRow row : model.rows) {
        if (!can_be_declared(row, shipped)) {
            rows.push_back(fmt::format("{} {}", parameter::to_text(row.device), row.number));
            continue;
        }
        const std::string name = row.name;
        if (loses_name(row, shipped)) {
            names.push_back(fmt::format("{} {}", row.number, name));
        }
        to.declare(std::move(row));
    }
    note_lost("rows of a catalogue file, which no declaration can say", std::move(rows), to);
    note_lost("names out of a catalogue file, which no declaration can say", std::move(names), to);
}

ImageDraft::ImageDraft() : catalogue_(catalogue::shipped_rows()) {}

void ImageDraft::declare(CanonicalRow row) {
    const CanonicalRow& kept = rows_.emplace_back(std::move(row));
    const Row* known = catalogue_.find(kept.device, kept.number);
    Row merged = known != nullptr ? *known : kept.row();
    if (known != nullptr) {
        merged.name = kept.name;
        merged.unit = kept.unit;
        merged.width = kept.width;
        merged.is_signed = kept.is_signed;
        merged.scaling = kept.scaling;
    }
    draft.declarations.push_back(catalogue_.put(merged));
}

bool ImageDraft::set(Device device, std::uint16_t number, double value) {
    const Row* row = catalogue_.find(device, number);
    const bool settable = row != nullptr && row->settable();
    return value == 0 ? settable : assign(device, number, value);
}

bool ImageDraft::assign(Device device, std::uint16_t number, double value) {
    const Row* row = catalogue_.find(device, number);
    if (row == nullptr || !row->settable()) {
        return false;
    }
    (device == Device::governor ? governor_ : gateway_)[number] = {row, parameter::value_text(*row, value)};
    return true;
}

namespace {

struct Reference {
    std::uint16_t number;  // of the parameter; 0: the end is no parameter
    double value;
};

std::array<Reference, 2> references_of(const Row& row, const image::Label& label) {
    if (!row.scaling || !label.has_scaling) {
        return {};
    }
    return {Reference{row.scaling->external_minimum_parameter, label.external_minimum},
            Reference{row.scaling->external_maximum_parameter, label.external_maximum}};
}

}  // namespace

void ImageDraft::set_references(const Row& row, const image::Label& label) {
    for (const Reference& reference : references_of(row, label)) {
        if (reference.number != 0) {
            assign(Device::governor, reference.number, reference.value);
        }
    }
}

void ImageDraft::state_zero_references(const Row& row, const image::Label& label) {
    for (const Reference& reference : references_of(row, label)) {
        if (reference.number != 0 && reference.value == 0 && !governor_.contains(reference.number)) {
            assign(Device::governor, reference.number, 0);
        }
    }
}

std::string ImageDraft::text() {
    for (const auto& [number, value] : governor_) {
        draft.governor.push_back(value);
    }
    for (const auto& [number, value] : gateway_) {
        draft.gateway.push_back(value);
    }
    return parameter_file_text(draft, catalogue_);
}

bool model_fits(const image::Image& image) {
    const image::Records& model = image.records(image::SectionId::model);
    const base::Sha256 digest = base::sha256({model.data, model.size});
    const std::span<const std::uint8_t> stated = image.configuration_id();
    return model.data == nullptr || std::equal(stated.begin(), stated.end(), digest.begin());
}

FileFromImage file_from_image(const image::Image& image, const std::vector<std::string>& remarks,
                              Basis basis) {
    FileFromImage file;
    ImageDraft draft;
    draft.draft.remarks = remarks;
    draft.reads_labels = basis != Basis::bare;
    const auto model = parameter::read_canonical_text(image.model());
    file.has_model = basis == Basis::model && model.has_value() && model_fits(image);
    if (file.has_model) {
        draft_model(*model, draft);
        for (std::size_t i = 0; i < image.label_count(); ++i) {
            const image::Label label = image.label(i);
            const Row* row = draft.catalogue().find(Device::governor, label.number);
            if (row != nullptr) {
                draft.state_zero_references(*row, label);
            }
        }
    } else {
        draft_sections(image, draft);
    }
    file.text = draft.text();
    file.lost = std::move(draft.lost);
    return file;
}

}  // namespace cgw::authoring
