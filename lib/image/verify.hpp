// The verifier's parts, private to the room. Every section is first checked field by field from a table
// (section_rules.cpp), then against the others by the functions below. They may rely on whole records of
// at least the layout's size and on every check that stands before them in `cross_checks`.
#pragma once

#include <cstdint>
#include <span>

#include "image/image.hpp"

namespace cgw::image {

// What a section must look like as a whole.
struct SectionRule {
    SectionId id;
    std::uint16_t record_size;   // as the layout has it
    std::uint16_t record_count;  // exactly; 0: any number
    bool required;
    bool ascending;  // the u16 at offset 0 grows from record to record
    bool bytes;      // not records: no later minor can lengthen them
    Status status;   // when a value in it is wrong
};

std::span<const SectionRule> section_rules();  // ascending id, from 1 without gap

// Every field's own range, reserved bytes (unless the image's minor is higher than ours, which may use
// them), and ascending numbers.
Status check_fields(const Image& image, const SectionRule& rule);

struct CrossCheck {
    bool (*holds)(const Image& image);
    Status status;
    SectionId section;  // the one to look at when it does not hold
};

bool buses_fit(const Image& image);        // HEINZMANN nodes crossed, bit rates equal, node numbers
bool heartbeats_fit(const Image& image);   // whole gateway cycles, the partner is CAN2's peer
bool objects_fit(const Image& image);      // sorted, known types, values laid out as the layout says
bool pdos_fit(const Image& image);         // positions, identifiers' source, activity, D8 times
bool mappings_fit(const Image& image);     // every word maps an object of right length and access
bool identifiers_fit(const Image& image);  // D33: unique and not reserved, over active PDOs
bool signals_fit(const Image& image);      // widths and ranges; every carried parameter has one
bool inputs_fit(const Image& image);       // switches and sensors are really mapped by the RPDOs
bool labels_fit(const Image& image);       // offsets inside the strings, clean UTF-8, finite numbers

// True when the image's minor is one whose every byte this reader knows.
inline bool is_known_minor(const Image& image) {
    return image.format_minor() <= format_minor;
}

}  // namespace cgw::image
