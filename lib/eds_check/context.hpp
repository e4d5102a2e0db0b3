// What the checks share: the file in the order of its objects, keys by what they are, values with their
// places.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/canopen_text.hpp"
#include "dictionary/data_types.hpp"
#include "eds/object_keys.hpp"
#include "eds/reading.hpp"
#include "eds_check/checks.hpp"
#include "eds_check/keys.hpp"

namespace cgw::eds_check {

using base::object_text;
using eds::ObjectKey;
using eds::Span;

// A section of an object or sub-object of the device or of one of its modules, or of what a module adds to
// objects; of those with one name the first.
struct Part {
    std::uint32_t section = 0;
    std::uint16_t index = 0;
    std::uint8_t sub_index = 0;
    bool is_sub_object = false;
    eds::KeyLines lines;
    const dictionary::Variable* variable = nullptr;  // nullptr: none, or one that could not be read
};

struct Group {
    std::uint8_t module = 0;  // 0: of the device
    std::uint16_t index = 0;
    bool is_extension = false;                   // [M1SubExt6000]: one part, and no object
    std::span<const Part> parts{};               // the object's own section first, when it has one
    const dictionary::Object* object = nullptr;  // nullptr: none, or one that could not be read
    bool has_section = false;

    const Part& own() const { return parts.front(); }  // when has_section
    const dictionary::Variable* own_variable() const { return has_section ? own().variable : nullptr; }
    std::span<const Part> sub_objects() const { return parts.subspan(has_section ? 1 : 0); }
    const Part* find(std::uint8_t sub_index) const;
};

// An entry of one of the three lists of objects.
struct Listed {
    eds::SectionKind list;
    std::uint16_t index;
    std::uint32_t line;
};

// The file, looked through once for all checks.
class Model {
  public:
    Model(const eds::Document& document, const eds::Sheet& sheet);

    std::span<const Group> groups() const { return groups_of(0); }
    std::span<const Group> groups_of(std::uint8_t module) const;   // 0: of the device; by ascending index
    std::span<const Group> all_groups() const { return groups_; }  // then of the modules, one by one
    const Group* find(std::uint16_t index) const {
        return find({.kind = eds::SectionKind::object, .index = index});
    }
    const Group* find(const eds::SectionName& name) const;  // that the section belongs to

    // Mandatory, optional, then manufacturer objects; those of one list in file order.
    std::span<const Listed> listed() const { return listed_; }
    // The first entry of the index in that list, which has one.
    std::uint32_t first_listing(eds::SectionKind list, std::uint16_t index) const;

    // Objects of the device that stand in none of the lists.
    std::span<const Group* const> unlisted() const { return unlisted_; }

    // What the key on a line is; nullptr: unknown, or no entry of a section whose keys are known.
    const KeyRow* key_row(std::uint32_t line) const { return key_rows_[line]; }

  private:
    void read_keys(const eds::Document& document, const eds::Sheet& sheet);
    void read_lists(const eds::Document& document, const eds::Sheet& sheet);
    void read_parts(const eds::Document& document, const eds::Sheet& sheet);
    void group_parts(const eds::Sheet& sheet);
    void find_unlisted();
    Group group_at(std::size_t begin, const eds::Sheet& sheet);

    std::vector<const KeyRow*> key_rows_;  // by line
    std::vector<Listed> listed_;
    std::vector<Listed> by_index_;  // of each list the first of each index
    std::vector<Part> parts_;
    std::vector<Group> groups_;
    std::vector<const Group*> unlisted_;
};

struct Context {
    eds::Reading& reading;
    const eds::Document& document;
    const eds::Sheet& sheet;
    const Model& model;
    const Options& options;

    std::optional<std::uint8_t> node_id() const;  // of the options, else of the configuration file

    // A number that stands there as CiA 306 has it, without $NODEID; the reader reports what is none.
    std::optional<std::uint64_t> number(std::uint32_t line) const;

    bool stated(std::uint32_t line) const { return line != 0 && !document.value(line).empty(); }

    // The line of a key in the first section of that kind; 0: not there.
    std::uint32_t line_of(eds::SectionKind kind, std::string_view key) const;

    Span header_of(std::uint32_t section) const { return document.name_span(reading.section(section)); }

    // "[1018sub1]"
    std::string label(const Part& part) const { return reading.quoted(reading.section(part.section)); }

    // Where the value of a variable stands: ParameterValue, else DefaultValue, else its section, else the
    // object's.
    Span value_place(const Group& group, std::uint8_t sub_index) const;

    eds::SectionKind kind_of(std::uint32_t section) const { return sheet.sections.name(section).kind; }
};

// What counts of a variable: the value of the one node, else the default; nullptr when none is stated.
const dictionary::Value* value_of(const dictionary::Variable& variable);

// The same of a number; nothing also for what is no number.
std::optional<std::uint64_t> number_of(const dictionary::Variable* variable);

// Calls `take(line)` for each entry of each section.
template <typename Take>
void for_each_entry(const Context& context, Take take) {
    const std::span<const eds::Section> sections = context.document.sections();
    for (std::uint32_t number = 0; number < sections.size(); ++number) {
        for (std::uint32_t line = sections[number].header + 1; line < sections[number].end; ++line) {
            if (context.document.lines()[line].kind == eds::LineKind::entry) {
                take(number, line);
            }
        }
    }
}

// Calls `take(group, part)` for each section of an object or sub-object, of the device and of its modules.
template <typename Take>
void for_each_part(const Context& context, Take take) {
    for (const Group& group : context.model.all_groups()) {
        for (const Part& part : group.parts) {
            take(group, part);
        }
    }
}

}  // namespace cgw::eds_check
