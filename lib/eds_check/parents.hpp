// Objects with sub-objects, as several checks go through them.
#pragma once

#include "eds_check/context.hpp"

namespace cgw::eds_check {

inline bool is_compact(const Context& context, const Part& part) {
    return context.number(part.lines[ObjectKey::compact_sub_objects]).value_or(0) > 0;
}

inline bool is_parent(const Group& group, const Part& part) {
    return !part.is_sub_object && group.object != nullptr && object::has_sub_objects(group.object->code);
}

// Calls `take(group)` for each object with sub-objects, all of them in sections of their own.
template <typename Take>
void for_each_parent(const Context& context, Take take) {
    for (const Group& group : context.model.all_groups()) {
        if (group.has_section && is_parent(group, group.own()) && !is_compact(context, group.own())) {
            take(group);
        }
    }
}

}  // namespace cgw::eds_check
