// The object table and its value block.
#include "image_writer/sections.hpp"
#include "object/object_table.hpp"

namespace cgw::image_writer {
namespace {

struct Placed {
    object::ObjectEntry entry;
    std::uint32_t value = 0;
};

Placed place(const dictionary::Object& object, const dictionary::Variable& variable, std::uint8_t node_id) {
    Placed placed;
    placed.entry.index = object.index;
    placed.entry.sub_index = variable.sub_index;
    placed.entry.type = variable.type;
    placed.entry.access = variable.access;
    if (variable.pdo_mapping) {
        placed.entry.flags |= object::flag_pdo_mappable;
    }
    if (variable.access == object::Access::rww) {  // D29: an RPDO writes it, SDO may not
        placed.entry.flags |= object::flag_sdo_read_only;
    }
    placed.entry.length = object::size_of(variable.type);
    placed.value = static_cast<std::uint32_t>(variable.default_value.resolve(node_id));
    return placed;
}

// Large values first, as the layout wants it; returns the size of the block.
std::size_t assign_offsets(std::vector<Placed>& table) {
    std::size_t offset = 0;
    for (const std::size_t size : {4U, 2U, 1U}) {
        for (Placed& placed : table) {
            if (placed.entry.length == size) {
                placed.entry.offset = static_cast<std::uint16_t>(offset);
                offset += size;
            }
        }
    }
    return offset;
}

}  // namespace

ObjectSections object_sections(const Source& source) {
    std::vector<Placed> table;
    for (const dictionary::Object& object : source.dictionary.objects) {
        for (const dictionary::Variable& variable : object.variables) {
            table.push_back(place(object, variable, source.configuration.node_id));
        }
    }
    ObjectSections sections{{image::SectionId::objects, object::object_record_size, {}},
                            {image::SectionId::object_values, 1, {}}};
    sections.values.bytes.resize(assign_offsets(table));
    for (const Placed& placed : table) {
        const auto record = object::encode(placed.entry);
        sections.objects.bytes.insert(sections.objects.bytes.end(), record.begin(), record.end());
        object::store_value(sections.values.bytes, placed.entry, placed.value);
    }
    return sections;
}

}  // namespace cgw::image_writer
