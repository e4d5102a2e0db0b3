#include "input/foreign_rows.hpp"

#include <set>

#include "base/edit_distance.hpp"
#include "input/parameter_keys.hpp"
#include "input/table_values.hpp"

namespace cgw::input {

using parameter::Device;

bool ForeignRows::contains(const TableRow& row, std::uint16_t number) {
    constexpr std::size_t longest_name = 64;
    const std::string name = row.name.text.substr(0, row.name.text.find_first_of(" ("));
    const bool has_name = !name.empty() && name.size() <= longest_name && !looks_like_number(name);
    // A parameter's name where the value or unit belongs: the row's cells are displaced.
    const bool is_displaced = is_parameter(row.unit.text) ||
                              (!looks_like_number(row.value.text) && is_parameter(row.value.text)) ||
                              (!row.has_columns && !looks_like_number(row.value.text));
    return has_name && !is_displaced && catalogue_.find(device_, number) == nullptr &&
           !is_parameter(row.name.text) && is_far(name);
}

// Of either device, since nobody says that the table was printed from this one.
bool ForeignRows::is_parameter(const std::string& text) const {
    return resolve_silently(catalogue_, Device::governor, text) != nullptr ||
           resolve_silently(catalogue_, Device::gateway, text) != nullptr;
}

// A file of nonsense stays cheap: after so many names the rest counts as near, and is refused.
bool ForeignRows::is_far(const std::string& name) {
    constexpr std::size_t most_names = 2000;
    const auto known = is_far_.find(name);
    if (known != is_far_.end() || is_far_.size() >= most_names) {
        return known != is_far_.end() && known->second;
    }
    if (names_.empty()) {
        list_names();
    }
    return is_far_[name] = base::nearest_name(name, names_).empty();
}

void ForeignRows::list_names() {
    std::set<std::string_view> names;
    for (const Device device : {Device::governor, Device::gateway}) {
        for (const parameter::Row* row : catalogue_.rows(device)) {
            if (row->settable() && !row->name.empty()) {
                names.insert(parameter::array_name(*row));
            }
        }
    }
    names_.assign(names.begin(), names.end());
}

}  // namespace cgw::input
