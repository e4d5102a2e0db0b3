#include "eds/section_names.hpp"

#include <algorithm>
#include <array>

#include "base/ascii.hpp"

namespace cgw::eds {
namespace {

struct NameRow {
    std::string_view name;
    SectionKind kind;
    bool misspelt = false;
};

constexpr std::array whole_names{
    NameRow{"FileInfo", SectionKind::file_info},
    NameRow{"DeviceInfo", SectionKind::device_info},
    NameRow{"DeviceComissioning", SectionKind::commissioning},  // the standard's own spelling
    NameRow{"DeviceCommissioning", SectionKind::commissioning, true},
    NameRow{"DummyUsage", SectionKind::dummy_usage},
    NameRow{"Comments", SectionKind::comments},
    NameRow{"MandatoryObjects", SectionKind::mandatory_objects},
    NameRow{"OptionalObjects", SectionKind::optional_objects},
    NameRow{"ManufacturerObjects", SectionKind::manufacturer_objects},
    NameRow{"SupportedModules", SectionKind::supported_modules},
    NameRow{"ConnectedModules", SectionKind::connected_modules},
    NameRow{"DynamicChannels", SectionKind::dynamic_channels},
    NameRow{"Tools", SectionKind::tools},
};

// Behind the index of an object.
constexpr std::array object_suffixes{
    NameRow{"Name", SectionKind::names},
    NameRow{"Value", SectionKind::values},
    NameRow{"Denotation", SectionKind::denotations},
    NameRow{"ObjectLinks", SectionKind::object_links},
};

// Behind M and the number of a module.
constexpr std::array module_names{
    NameRow{"ModuleInfo", SectionKind::module_info},
    NameRow{"Comments", SectionKind::module_comments},
    NameRow{"FixedObjects", SectionKind::module_fixed_objects},
    NameRow{"SubExtends", SectionKind::module_sub_extends},
};

template <std::size_t size>
const NameRow* find_row(const std::array<NameRow, size>& rows, std::string_view name) {
    const auto* const found = std::find_if(rows.begin(), rows.end(), [name](const NameRow& row) {
        return row.name.size() == name.size() && base::equal_ignoring_case(row.name, name);
    });
    return found != rows.end() ? &*found : nullptr;
}

constexpr std::size_t index_digits = 4;

// All of `text`, which has at most eight digits.
// By character; no_digit for what is none. Every section name is read with it.
constexpr std::uint8_t no_digit = 0xFF;
constexpr auto digit_values = [] {
    std::array<std::uint8_t, 0x100> values{};
    values.fill(no_digit);
    for (std::size_t i = 0; i < 10; ++i) {
        values[static_cast<std::size_t>('0') + i] = static_cast<std::uint8_t>(i);
    }
    for (std::size_t i = 0; i < 6; ++i) {
        values[static_cast<std::size_t>('a') + i] = static_cast<std::uint8_t>(10 + i);
        values[static_cast<std::size_t>('A') + i] = static_cast<std::uint8_t>(10 + i);
    }
    return values;
}();

std::optional<std::uint32_t> hexadecimal(std::string_view text) {
    std::uint32_t number = 0;
    for (const char c : text) {
        const std::uint8_t digit = digit_values[static_cast<std::uint8_t>(c)];
        if (digit == no_digit) {
            return std::nullopt;
        }
        number = number << 4U | digit;
    }
    return number;
}

bool takes_prefix(std::string_view& text, std::string_view prefix) {
    if (!text.starts_with(prefix) && !base::equal_ignoring_case(text.substr(0, prefix.size()), prefix)) {
        return false;
    }
    text.remove_prefix(prefix.size());
    return true;
}

SectionName object_name(std::string_view name) {
    SectionName result;
    const auto index = hexadecimal(name.substr(0, index_digits));
    if (name.size() < index_digits || !index) {
        return result;
    }
    result.index = static_cast<std::uint16_t>(*index);
    name.remove_prefix(index_digits);
    if (name.empty()) {
        result.kind = SectionKind::object;
    } else if (takes_prefix(name, "sub")) {
        const auto sub_index = hexadecimal(name.substr(0, 2));
        if (sub_index && !name.empty() && name.size() <= 2) {
            result.kind = SectionKind::sub_object;
            result.sub_index = static_cast<std::uint8_t>(*sub_index);
        }
    } else if (const NameRow* const row = find_row(object_suffixes, name)) {
        result.kind = row->kind;
    }
    return result;
}

SectionName module_name(std::string_view name) {
    std::uint32_t module = 0;
    while (!name.empty() && base::is_digit(name.front()) && module <= 0xFF) {
        module = module * 10 + static_cast<std::uint32_t>(name.front() - '0');
        name.remove_prefix(1);
    }
    SectionName result;
    if (module == 0 || module > 0xFF) {
        return result;
    }
    if (const NameRow* const row = find_row(module_names, name)) {
        result.kind = row->kind;
    } else if (takes_prefix(name, "SubExt")) {
        result = object_name(name);
        result.kind =
            result.kind == SectionKind::object ? SectionKind::module_sub_extension : SectionKind::unknown;
    } else if (takes_prefix(name, "Fixed")) {
        result = object_name(name);
    }
    result.module = static_cast<std::uint8_t>(module);
    return result;
}

// Fewer sections than this fit into the largest text.
constexpr unsigned section_bits = 24;
static_assert(largest_text / 2 <= 1U << section_bits);

constexpr unsigned index_at = 40;  // bit of a key

std::uint64_t key_of(const SectionName& name) {
    return std::uint64_t{name.module} << 56U | std::uint64_t{name.index} << index_at |
           static_cast<std::uint64_t>(name.kind) << 32U | std::uint64_t{name.sub_index} << section_bits;
}

}  // namespace

SectionName parse_section_name(std::string_view name) {
    const SectionName object = object_name(name);
    if (object.kind != SectionKind::unknown) {
        return object;
    }
    if (const NameRow* const row = find_row(whole_names, name)) {
        return {.kind = row->kind, .misspelt = row->misspelt};
    }
    return takes_prefix(name, "M") ? module_name(name) : SectionName{};
}

std::string_view standard_name(SectionKind kind) {
    const auto* const row = std::find_if(whole_names.begin(), whole_names.end(), [kind](const NameRow& each) {
        return each.kind == kind && !each.misspelt;
    });
    return row != whole_names.end() ? row->name : std::string_view();
}

SectionTable::SectionTable(const Document& document) {
    names_.reserve(document.sections().size());
    keys_.reserve(document.sections().size());
    for (const Section& section : document.sections()) {
        const SectionName name = parse_section_name(document.name(section));
        keys_.push_back(key_of(name) | names_.size());
        names_.push_back(name);
    }
    // Files mostly have their objects in order, with lists of them between: those without index come first.
    const auto objects = std::stable_partition(keys_.begin(), keys_.end(),
                                               [](std::uint64_t key) { return key >> index_at == 0; });
    for (const auto& [begin, end] : {std::pair(keys_.begin(), objects), std::pair(objects, keys_.end())}) {
        if (!std::is_sorted(begin, end)) {
            std::sort(begin, end);
        }
    }
    ordered_.reserve(keys_.size());
    for (const std::uint64_t key : keys_) {
        ordered_.push_back(static_cast<std::uint32_t>(key & ((1U << section_bits) - 1)));
    }
}

std::optional<std::uint32_t> SectionTable::find(const SectionName& name) const {
    const std::uint64_t wanted = key_of(name);
    const auto found = std::lower_bound(keys_.begin(), keys_.end(), wanted);
    if (found == keys_.end() || *found >> section_bits != wanted >> section_bits) {
        return std::nullopt;
    }
    return ordered_[static_cast<std::size_t>(found - keys_.begin())];
}

std::optional<std::uint32_t> SectionTable::find_object(std::uint16_t index) const {
    return find(SectionName{.kind = SectionKind::object, .index = index});
}

std::optional<std::uint32_t> SectionTable::find_sub_object(std::uint16_t index,
                                                           std::uint8_t sub_index) const {
    return find(SectionName{.kind = SectionKind::sub_object, .index = index, .sub_index = sub_index});
}

}  // namespace cgw::eds
