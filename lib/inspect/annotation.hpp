// An image told field by field, sound or damaged: every byte of the file stands in exactly one item.
//
// A damaged image is followed as far as sense can be made of it. What breaks is marked where it breaks: a
// field that no image has so, a section that the verifier refuses, bytes that belong nowhere.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.hpp"
#include "inspect/fields.hpp"

namespace cgw::inspect {

struct Item {
    std::size_t offset = 0;
    std::size_t size = 0;
    Type type = Type::bytes;
    std::string name;
    std::string value;    // "" for plain bytes
    std::string meaning;  // what the value means, else what the field is
    std::string wrong;    // why no image has this value; "" while nothing is wrong
};

// The items of one record, or of one section of plain bytes.
struct Group {
    std::string_view section;           // as the table calls it; "" for bytes that belong to none
    std::optional<std::size_t> record;  // from 0, where there are several
    std::string title;                  // "pdos 5 of 20: TPDO5"
    std::string wrong;                  // of all of it, where no single field is to blame
    std::vector<Item> items;
};

struct Annotation {
    image::Status status = image::Status::ok;  // what the verifier says
    // What it would say if the CRC-32 were right, when that is what is wrong.
    image::Status status_beyond_crc = image::Status::ok;
    bool model_fits = true;  // a gateway does not look whether the model has the configuration id; tools do
    std::vector<Group> groups;
};

Annotation annotate(std::span<const std::uint8_t> bytes);

// 80 columns; lines with what is wrong begin with '!'.
std::string annotation_text(const Annotation& annotation, std::span<const std::uint8_t> bytes,
                            std::string_view path);

// One JSON document with format_version 1; later versions only gain keys.
std::string annotation_json(const Annotation& annotation, std::span<const std::uint8_t> bytes,
                            const std::string& path);

}  // namespace cgw::inspect
