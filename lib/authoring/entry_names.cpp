#include "authoring/entry_names.hpp"

#include <algorithm>

#include "base/numbers.hpp"
#include "dictionary/ascii.hpp"

namespace cgw::authoring {
namespace {

using parameter::Device;
using parameter::Row;

const Row* row_numbered(const parameter::Catalogue& catalogue, std::string_view digits) {
    constexpr std::int64_t highest = 65535;
    const auto number = base::parse_integer(digits);
    return number && *number > 0 && *number <= highest
               ? catalogue.find(Device::governor, static_cast<std::uint16_t>(*number))
               : nullptr;
}

// Data sheets are ASCII.
const Row* row_of_ascii(const parameter::Catalogue& catalogue, std::string_view name) {
    const std::vector<const Row*>& rows = catalogue.rows(Device::governor);
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row* row) {
        return !row->name.empty() && dictionary::to_ascii(row->name) == name;
    });
    return found != rows.end() ? *found : nullptr;
}

}  // namespace

const Row* row_of_entry(const parameter::Catalogue& catalogue, std::string_view name,
                        std::string_view number_prefix) {
    if (name.starts_with(number_prefix)) {
        return row_numbered(catalogue, name.substr(number_prefix.size()));
    }
    if (const Row* const row = row_of_ascii(catalogue, name)) {
        return row;
    }
    const std::size_t blank = name.find_last_of(' ');
    return blank != std::string_view::npos ? row_of_ascii(catalogue, name.substr(0, blank)) : nullptr;
}

}  // namespace cgw::authoring
