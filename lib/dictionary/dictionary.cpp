#include "dictionary/dictionary.hpp"

#include <algorithm>

namespace cgw::dictionary {
namespace {

template <typename Item, typename Key>
const Item* find_sorted(const std::vector<Item>& items, Key key, Key Item::*member) {
    const auto found =
        std::lower_bound(items.begin(), items.end(), key,
                         [member](const Item& item, Key wanted) { return item.*member < wanted; });
    return found != items.end() && (*found).*member == key ? &*found : nullptr;
}

}  // namespace

const Variable* Object::find(std::uint8_t sub_index) const {
    return find_sorted(variables, sub_index, &Variable::sub_index);
}

const Object* Dictionary::find(std::uint16_t index) const {
    return find_sorted(objects, index, &Object::index);
}

const Variable* Dictionary::find(std::uint16_t index, std::uint8_t sub_index) const {
    const Object* const object = find(index);
    return object != nullptr ? object->find(sub_index) : nullptr;
}

}  // namespace cgw::dictionary
