// Where what an EDS or DCF says of an object, or of the device, stands in it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "eds/document.hpp"
#include "eds/section_names.hpp"

namespace cgw::eds {

class ValuePlaces {
  public:
    // At most largest_text bytes.
    explicit ValuePlaces(std::string text) : document_(std::move(text)), sections_(document_) {}

    // What the object holds: the value of the one node (ParameterValue), else the default, else the section
    // that describes it. Of a sub-object without a section (CompactSubObj) its entry in [xxxxValue], else the
    // section of the object. Nothing ({}): the file has none of them.
    diagnostic::Range of_object(std::uint16_t index, std::uint8_t sub_index) const;

    // The value of a key, else the section, else nothing. Key "": the section.
    diagnostic::Range of_key(SectionKind kind, std::string_view key) const;

  private:
    const Section& section(std::uint32_t number) const { return document_.sections()[number]; }
    diagnostic::Range value_in(std::uint32_t number) const;
    diagnostic::Range header_of(std::uint32_t number) const {
        return document_.range(document_.name_span(section(number)));
    }

    Document document_;
    SectionTable sections_;
};

}  // namespace cgw::eds
