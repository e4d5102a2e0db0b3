#include "image_writer/dictionary_of.hpp"

namespace cgw::image_writer {

dictionary::Dictionary dictionary_of(const image::Image& image) {
    dictionary::Dictionary dictionary;
    const object::ObjectTable table = image.objects();
    for (std::size_t i = 0; i < table.size(); ++i) {
        const object::ObjectEntry entry = table.entry(i);
        if (dictionary.objects.empty() || dictionary.objects.back().index != entry.index) {
            dictionary.objects.emplace_back().index = entry.index;
        }
        dictionary::Object& object = dictionary.objects.back();
        if (entry.sub_index != 0) {
            object.code = object::ObjectCode::record;
        }
        dictionary::Variable& variable = object.variables.emplace_back();
        variable.sub_index = entry.sub_index;
        variable.type = entry.type;
        variable.access = entry.access;
        variable.pdo_mapping = (entry.flags & object::flag_pdo_mappable) != 0;
        variable.default_value.number = object::load_value(image.initial_values(), entry);
    }
    return dictionary;
}

}  // namespace cgw::image_writer
