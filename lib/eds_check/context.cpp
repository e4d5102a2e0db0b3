#include "eds_check/context.hpp"

#include <algorithm>
#include <tuple>

#include "base/ascii.hpp"

namespace cgw::eds_check {

using dictionary::Value;
using dictionary::Variable;
using eds::SectionKind;
using eds::SectionName;

namespace {

// What the parts of one object have in common: module, index, whether they extend the object only.
using Place = std::tuple<std::uint8_t, std::uint16_t, bool>;

Place place_of(const SectionName& name) {
    return {name.module, name.index, name.kind == SectionKind::module_sub_extension};
}

bool is_same(const SectionName& a, const SectionName& b) {
    return place_of(a) == place_of(b) && a.kind == b.kind && a.sub_index == b.sub_index;
}

bool is_before(const Listed& a, const Listed& b) {
    return std::pair(a.list, a.index) < std::pair(b.list, b.index);
}

// A number that stands there as CiA 306 has it, without $NODEID.
std::optional<std::uint64_t> plain_number(const eds::Document& document, std::uint32_t line) {
    const eds::Number number = eds::parse_number(document.value(line));
    const bool usable =
        number.reading == eds::Number::Reading::number && !number.negative && !number.node_id_relative;
    return usable ? std::optional(number.magnitude) : std::nullopt;
}

const dictionary::Module* module_of(const dictionary::Dictionary& dictionary, std::uint8_t number) {
    const auto found =
        std::find_if(dictionary.modules.begin(), dictionary.modules.end(),
                     [number](const dictionary::Module& each) { return each.number == number; });
    return found != dictionary.modules.end() ? &*found : nullptr;
}

// By ascending index.
template <typename Item>
const Item* find_index(const std::vector<Item>& items, std::uint16_t index) {
    const auto found =
        std::lower_bound(items.begin(), items.end(), index,
                         [](const Item& each, unsigned wanted) { return each.index < wanted; });
    return found != items.end() && found->index == index ? &*found : nullptr;
}

const dictionary::Object* object_of(const dictionary::Dictionary& dictionary, const SectionName& name) {
    if (name.module == 0) {
        return dictionary.find(name.index);
    }
    const dictionary::Module* const module = module_of(dictionary, name.module);
    return module != nullptr ? find_index(module->fixed_objects, name.index) : nullptr;
}

const Variable* extension_variable(const dictionary::Dictionary& dictionary, const SectionName& name) {
    const dictionary::Module* const module = module_of(dictionary, name.module);
    const dictionary::ModuleExtension* const extension =
        module != nullptr ? find_index(module->extensions, name.index) : nullptr;
    return extension != nullptr ? &extension->variable : nullptr;
}

}  // namespace

const Part* Group::find(std::uint8_t sub_index) const {
    const std::span<const Part> subs = sub_objects();
    const auto found =
        std::lower_bound(subs.begin(), subs.end(), sub_index,
                         [](const Part& part, unsigned wanted) { return part.sub_index < wanted; });
    return found != subs.end() && found->sub_index == sub_index ? &*found : nullptr;
}

Model::Model(const eds::Document& document, const eds::Sheet& sheet) {
    read_keys(document, sheet);
    read_lists(document, sheet);
    read_parts(document, sheet);
    group_parts(sheet);
    find_unlisted();
}

void Model::find_unlisted() {
    constexpr std::uint16_t first_object = 0x1000;  // below stand data types
    std::vector<bool> is_listed(eds::highest_u16 + 1);
    for (const Listed& each : listed_) {
        is_listed[each.index] = true;
    }
    for (const Group& group : groups()) {
        if (group.has_section && !is_listed[group.index] && group.index >= first_object) {
            unlisted_.push_back(&group);
        }
    }
}

void Model::read_keys(const eds::Document& document, const eds::Sheet& sheet) {
    key_rows_.resize(document.lines().size());
    const std::span<const eds::Section> sections = document.sections();
    for (std::uint32_t number = 0; number < sections.size(); ++number) {
        const SectionKind kind = sheet.sections.name(number).kind;
        for (std::uint32_t line = sections[number].header + 1; line < sections[number].end; ++line) {
            if (document.lines()[line].kind == eds::LineKind::entry) {
                key_rows_[line] = find_key(kind, document.key(line));
            }
        }
    }
}

void Model::read_lists(const eds::Document& document, const eds::Sheet& sheet) {
    for (const SectionKind list : object_lists) {
        const auto section = sheet.sections.find(list);
        if (!section) {
            continue;
        }
        const eds::Section& of = document.sections()[*section];
        for (std::uint32_t line = of.header + 1; line < of.end; ++line) {
            const bool is_entry = key_rows_[line] != nullptr && key_rows_[line]->tail == Tail::number;
            const auto index = is_entry ? plain_number(document, line) : std::nullopt;
            if (index && *index <= eds::highest_u16) {
                listed_.push_back({list, static_cast<std::uint16_t>(*index), line});
            }
        }
    }
    by_index_ = listed_;
    std::stable_sort(by_index_.begin(), by_index_.end(), is_before);
    by_index_.erase(
        std::unique(by_index_.begin(), by_index_.end(),
                    [](const Listed& a, const Listed& b) { return a.list == b.list && a.index == b.index; }),
        by_index_.end());
}

std::uint32_t Model::first_listing(SectionKind list, std::uint16_t index) const {
    return std::lower_bound(by_index_.begin(), by_index_.end(), Listed{list, index, 0}, is_before)->line;
}

void Model::read_parts(const eds::Document& document, const eds::Sheet& sheet) {
    diagnostic::Findings told_already;  // by the reader
    const std::string path;
    eds::Reading reading(document, sheet.sections, path, told_already, 0);
    const SectionName* last = nullptr;
    for (const std::uint32_t number : sheet.sections.ordered()) {
        const SectionName& name = sheet.sections.name(number);
        const bool is_sub = name.kind == SectionKind::sub_object;
        const bool is_part =
            is_sub || name.kind == SectionKind::object || name.kind == SectionKind::module_sub_extension;
        if (!is_part || (last != nullptr && is_same(*last, name))) {
            continue;
        }
        last = &name;
        parts_.push_back({number, name.index, name.sub_index, is_sub,
                          object_key_lines(reading, reading.section(number)), nullptr});
    }
}

void Model::group_parts(const eds::Sheet& sheet) {
    for (std::size_t begin = 0; begin < parts_.size(); begin += groups_.back().parts.size()) {
        groups_.push_back(group_at(begin, sheet));
    }
}

Group Model::group_at(std::size_t begin, const eds::Sheet& sheet) {
    const SectionName& first = sheet.sections.name(parts_[begin].section);
    Group group;
    group.module = first.module;
    group.index = first.index;
    group.is_extension = first.kind == SectionKind::module_sub_extension;
    group.has_section = first.kind != SectionKind::sub_object;
    std::size_t end = begin + 1;
    if (group.is_extension) {
        parts_[begin].variable = extension_variable(sheet.dictionary, first);
    } else {
        group.object = object_of(sheet.dictionary, first);
        while (end < parts_.size() && place_of(sheet.sections.name(parts_[end].section)) == place_of(first)) {
            ++end;
        }
    }
    for (std::size_t at = begin; at < end && group.object != nullptr; ++at) {
        const bool has_value = parts_[at].is_sub_object || !object::has_sub_objects(group.object->code);
        parts_[at].variable = has_value ? group.object->find(parts_[at].sub_index) : nullptr;
    }
    group.parts = std::span(parts_).subspan(begin, end - begin);
    return group;
}

std::span<const Group> Model::groups_of(std::uint8_t module) const {
    const auto begin = std::partition_point(groups_.begin(), groups_.end(),
                                            [module](const Group& group) { return group.module < module; });
    const auto end = std::partition_point(begin, groups_.end(),
                                          [module](const Group& group) { return group.module == module; });
    return {begin, end};
}

const Group* Model::find(const SectionName& name) const {
    const Place wanted = place_of(name);
    const auto found =
        std::lower_bound(groups_.begin(), groups_.end(), wanted, [](const Group& group, const Place& place) {
            return Place(group.module, group.index, group.is_extension) < place;
        });
    return found != groups_.end() && Place(found->module, found->index, found->is_extension) == wanted
               ? &*found
               : nullptr;
}

std::optional<std::uint8_t> Context::node_id() const {
    constexpr std::uint8_t highest = 127;
    if (options.node_id) {
        return options.node_id;
    }
    const bool known =
        sheet.commissioning && sheet.commissioning->node_id >= 1 && sheet.commissioning->node_id <= highest;
    return known ? std::optional(sheet.commissioning->node_id) : std::nullopt;
}

std::optional<std::uint64_t> Context::number(std::uint32_t line) const {
    return stated(line) ? plain_number(document, line) : std::nullopt;
}

std::uint32_t Context::line_of(SectionKind kind, std::string_view key) const {
    const auto section = sheet.sections.find(kind);
    return section ? document.find(reading.section(*section), key).value_or(0) : 0;
}

Span Context::value_place(const Group& group, std::uint8_t sub_index) const {
    const bool has_own = group.object == nullptr || object::has_sub_objects(group.object->code);
    const Part* const part = has_own ? group.find(sub_index) : &group.own();
    if (part == nullptr) {
        return header_of(group.own().section);
    }
    for (const ObjectKey key : {ObjectKey::parameter_value, ObjectKey::default_value}) {
        if (stated(part->lines[key])) {
            return document.value_span(part->lines[key]);
        }
    }
    return header_of(part->section);
}

const Value* value_of(const Variable& variable) {
    if (variable.parameter_value) {
        return &*variable.parameter_value;
    }
    return variable.no_default ? nullptr : &variable.default_value;
}

std::optional<std::uint64_t> number_of(const Variable* variable) {
    const Value* const value = variable != nullptr ? value_of(*variable) : nullptr;
    const bool is_number = value != nullptr && !value->node_id_relative &&
                           dictionary::is_numeric(dictionary::row_of(variable->type).kind);
    return is_number ? std::optional(value->number) : std::nullopt;
}

}  // namespace cgw::eds_check
