// A draft with the rows it refers to. Private to the room.
#pragma once

#include <deque>
#include <map>

#include "authoring/from_image.hpp"
#include "parameter/canonical_model.hpp"

namespace cgw::authoring {

class ImageDraft {
  public:
    ImageDraft();

    Draft draft;
    std::vector<std::string> lost;
    bool reads_labels = true;

    const parameter::Catalogue& catalogue() const { return catalogue_; }

    // Adds a declaration; what it says is kept here.
    void declare(parameter::CanonicalRow row);

    // Sets a parameter, unless the value is 0, which is what is not set; false where no catalogue knows the
    // parameter.
    bool set(parameter::Device device, std::uint16_t number, double value);

    // The same, and 0 is written as well.
    bool assign(parameter::Device device, std::uint16_t number, double value);

    // The parameters that hold the ends of a row's range in the governor, as the label tells them.
    void set_references(const parameter::Row& row, const image::Label& label);

    // The same beside a model, which has all of them but those set to 0, and does not tell these from what is
    // not set: only with both ends set a range is known. A label that says something else than the model is
    // not believed.
    void state_zero_references(const parameter::Row& row, const image::Label& label);

    // The text, with the values by number.
    std::string text();

  private:
    parameter::Catalogue catalogue_;
    std::deque<parameter::CanonicalRow> rows_;
    std::map<std::uint16_t, WrittenValue> governor_;
    std::map<std::uint16_t, WrittenValue> gateway_;
};

// from_image.cpp: the declarations of a model. What no declaration can say is in `lost`.
void draft_rows(const parameter::CanonicalModel& model, ImageDraft& to);

// from_sections.cpp: what the sections a gateway needs tell about the parameters.
void draft_sections(const image::Image& image, ImageDraft& to);

}  // namespace cgw::authoring
