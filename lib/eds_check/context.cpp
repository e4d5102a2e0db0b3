#include "eds_check/context.hpp"

#include <algorithm>

#include "base/ascii.hpp"

namespace cgw::eds_check {

using dictionary::Value;
using dictionary::Variable;
using eds::SectionKind;
using eds::SectionName;

const Part* Group::find(std::uint8_t sub_index) const {
    const std::span<const Part> subs = sub_objects();
    const auto found =
        std::lower_bound(subs.begin(), subs.end(), sub_index,
                         [](const Part& part, unsigned wanted) { return part.sub_index < wanted; });
    return found != subs.end() && found->sub_index == sub_index ? &*found : nullptr;
}

Model::Model(const eds::Document& document, const eds::Sheet& sheet) {
    read_keys(document, sheet);
    read_parts(document, sheet);
    group_parts(sheet);
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

void Model::read_parts(const eds::Document& document, const eds::Sheet& sheet) {
    diagnostic::Findings told_already;  // by the reader
    const std::string path;
    eds::Reading reading(document, sheet.sections, path, told_already, 0);
    for (const std::uint32_t number : sheet.sections.ordered()) {
        const SectionName& name = sheet.sections.name(number);
        if (name.module != 0) {
            break;
        }
        const bool is_sub = name.kind == SectionKind::sub_object;
        if (name.kind != SectionKind::object && !is_sub) {
            continue;
        }
        if (!parts_.empty() && parts_.back().index == name.index && parts_.back().is_sub_object == is_sub &&
            parts_.back().sub_index == name.sub_index) {
            continue;
        }
        parts_.push_back({number, name.index, name.sub_index, is_sub,
                          object_key_lines(reading, reading.section(number)), nullptr});
    }
}

void Model::group_parts(const eds::Sheet& sheet) {
    for (std::size_t begin = 0, end = 0; begin < parts_.size(); begin = end) {
        Group group;
        group.index = parts_[begin].index;
        group.object = sheet.dictionary.find(group.index);
        group.has_section = !parts_[begin].is_sub_object;
        for (end = begin; end < parts_.size() && parts_[end].index == group.index; ++end) {
            const bool has_value = group.object != nullptr && (parts_[end].is_sub_object ||
                                                               !object::has_sub_objects(group.object->code));
            parts_[end].variable = has_value ? group.object->find(parts_[end].sub_index) : nullptr;
        }
        group.parts = std::span(parts_).subspan(begin, end - begin);
        groups_.push_back(group);
    }
}

const Group* Model::find(std::uint16_t index) const {
    const auto found =
        std::lower_bound(groups_.begin(), groups_.end(), index,
                         [](const Group& group, unsigned wanted) { return group.index < wanted; });
    return found != groups_.end() && found->index == index ? &*found : nullptr;
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
    if (!stated(line)) {
        return std::nullopt;
    }
    const eds::Number number = eds::parse_number(document.value(line));
    const bool usable =
        number.reading == eds::Number::Reading::number && !number.negative && !number.node_id_relative;
    return usable ? std::optional(number.magnitude) : std::nullopt;
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
