#include <fmt/format.h>

#include <algorithm>

#include "base/sha256.hpp"
#include "image_writer/dictionary_of.hpp"
#include "image_writer/image_writer.hpp"
#include "inspect/fields.hpp"
#include "proof/configuration_id.hpp"
#include "proof/proof.hpp"
#include "proof/proving.hpp"
#include "wire/little_endian.hpp"

namespace cgw::proof {
namespace {

using dictionary::Difference;
using image::SectionId;

constexpr SectionId told_as_objects[] = {SectionId::objects, SectionId::object_values};
constexpr SectionId optional_sections[] = {SectionId::labels, SectionId::strings, SectionId::model};

bool is_one_of(SectionId id, std::span<const SectionId> ids) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
}

void add(Proof& proof, std::string_view aspect, std::string name, std::string a, std::string b) {
    Difference difference{aspect, {}, {}, {}, std::move(name)};
    difference.aspect_text = "image";
    difference.a = std::move(a);
    difference.b = std::move(b);
    proof.differences.all.push_back(std::move(difference));
}

std::string bytes_text(const std::uint8_t* bytes, std::size_t size) {
    if (size <= sizeof(std::uint32_t)) {
        std::uint32_t number = 0;
        for (std::size_t i = size; i > 0; --i) {
            number = number << 8U | bytes[i - 1];
        }
        return fmt::format("{}", number);
    }
    std::string text;
    for (std::size_t i = 0; i < size; ++i) {
        text += fmt::format("{:02X}", bytes[i]);
    }
    return text;
}

// Field by field, so that the table of fields (inspect/fields.hpp) tells what differs.
void compare_records(Proof& proof, const inspect::Record& record, const image::Records& a,
                     const image::Records& b) {
    if (a.count() != b.count()) {
        add(proof, "image-records", std::string(record.name), fmt::format("{} records", a.count()),
            fmt::format("{} records", b.count()));
        return;
    }
    for (std::size_t i = 0; i < a.count(); ++i) {
        for (const inspect::Field& field : record.fields) {
            const std::uint8_t* const of_a = a.at(i) + field.offset;
            const std::uint8_t* const of_b = b.at(i) + field.offset;
            if (!std::equal(of_a, of_a + field.size(), of_b)) {
                add(proof, "image-field", fmt::format("{}, record {}, {}", record.name, i, field.name),
                    bytes_text(of_a, field.size()), bytes_text(of_b, field.size()));
            }
        }
    }
}

bool same_bytes(const image::Records& a, const image::Records& b) {
    return std::equal(a.data, a.data + a.size, b.data, b.data + b.size);
}

void compare_optional(Proof& proof, const inspect::Record& record, const image::Records& a,
                      const image::Records& b) {
    if (a.data == nullptr || b.data == nullptr) {
        proof.differences.not_compared.push_back(record.name);
    } else if (!same_bytes(a, b)) {
        add(proof, "image-section", std::string(record.name), "as the parameter file has them", "others");
    }
}

}  // namespace

Proof prove_image(const emit::Plant& plant, const image::Image& image) {
    Proof proof;
    const std::uint8_t node_id = plant.configuration.node_id;
    const dictionary::Dictionary held = image_writer::dictionary_of(image);
    proof.differences = dictionary::differences({.dictionary = plant.dictionary, .node_id = node_id},
                                                {.dictionary = held, .node_id = node_id, .bare = true});
    proof.differences.not_compared.clear();  // the labels are
    compare_id(proof, base::to_hex(plant.configuration_id), configuration_id(image));
    const base::Bytes bytes = image_writer::write_image({.settings = plant.settings,
                                                         .configuration = plant.configuration,
                                                         .dictionary = plant.dictionary,
                                                         .configuration_id = plant.configuration_id,
                                                         .tool_version = plant.tool_version});
    image::Image made;
    image::Image::open(bytes, made);
    for (const inspect::Record& record : inspect::all_records()) {
        if (!record.is_section() || is_one_of(record.section, told_as_objects)) {
            continue;
        }
        const image::Records& a = made.records(record.section);
        const image::Records& b = image.records(record.section);
        if (is_one_of(record.section, optional_sections)) {
            compare_optional(proof, record, a, b);
        } else {
            compare_records(proof, record, a, b);
        }
    }
    proof.compared =
        fmt::format("{} objects, buses, PDOs, switches, sensors, signals", plant.dictionary.objects.size());
    return proof;
}

}  // namespace cgw::proof
