// The sections: records with a title each, values by object, texts by label.
#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "base/canopen_text.hpp"
#include "facts/gateway.hpp"
#include "inspect/field_value.hpp"
#include "inspect/walk.hpp"
#include "object/object_table.hpp"

namespace cgw::inspect {
namespace {

using image::SectionId;

std::string numbered(const Outline& outline, std::uint32_t number) {
    const std::string name = label_name(outline, static_cast<std::uint16_t>(number));
    return name.empty() ? fmt::format("{}", number) : fmt::format("{} {}", number, name);
}

std::string object_name(std::span<const std::uint8_t> record) {
    return base::object_text(load(record, image::object_record::index, 2),
                             load(record, image::object_record::sub_index, 1));
}

// What a record is about: "TPDO5", "1018h:1", "811 FunctIdleSpeed".
std::string subject(const Outline& outline, const Extent& extent, std::size_t position) {
    const auto id = static_cast<SectionId>(extent.id);
    const auto record = outline.record(id, position);
    switch (id) {
        case SectionId::buses:
            return fmt::format("CAN{}", position + 1);
        case SectionId::pdos: {
            const bool transmits = position < facts::tpdo_count;
            const std::size_t number = (transmits ? position : position - facts::tpdo_count) + 1;
            return base::pdo_name(transmits, static_cast<unsigned>(number));
        }
        case SectionId::objects:
            return object_name(record);
        case SectionId::switches:
        case SectionId::sensors:
        case SectionId::signals:
            return numbered(outline, load(record, 0, 2));
        case SectionId::labels:
            return load(record, 0, 2) == 0 ? "title" : fmt::format("{}", load(record, 0, 2));
        default:
            return "";
    }
}

void add_records(const Outline& outline, const Extent& extent, Groups& groups) {
    const Record& record = *extent.record;
    const std::size_t count = extent.count();
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = extent.offset + i * extent.record_size;
        groups.push_back(record_group(outline, record, i, at, extent.record_size));
        Group& group = groups.back();
        if (count != 1 || record.count != 1) {
            const std::string what = subject(outline, extent, i);
            group.title =
                fmt::format("{} {} of {}{}{}", record.name, i + 1, count, what.empty() ? "" : ": ", what);
        }
        if (extent.record_size < record.size) {
            group.wrong = fmt::format("a record of {} has {} bytes", record.name, record.size);
        }
    }
    const std::size_t whole = count * extent.record_size;
    if (whole < extent.size) {
        Item item = plain_bytes(extent.offset + whole, extent.size - whole, "rest", "");
        item.wrong = "less than a record";
        groups.push_back({record.name, {}, std::string(record.name), "", {std::move(item)}});
    }
}

struct Placed {
    std::size_t offset = 0;
    std::size_t length = 0;
    Type type = Type::u8;
    std::string name;
};

std::vector<Placed> placed_values(const Outline& outline) {
    namespace at = image::object_record;
    std::vector<Placed> values;
    const Extent* objects = outline.find(SectionId::objects);
    for (std::size_t i = 0; objects != nullptr && i < objects->count(); ++i) {
        const auto record = outline.record(SectionId::objects, i);
        if (record.size() < at::size) {
            break;
        }
        const std::size_t length = object::size_of(static_cast<object::DataType>(record[at::type]));
        if (length != 0) {
            const Type type = length == 1 ? Type::u8 : length == 2 ? Type::u16 : Type::u32;
            values.push_back({load(record, at::offset, 2), length, type, object_name(record)});
        }
    }
    std::stable_sort(values.begin(), values.end(),
                     [](const Placed& a, const Placed& b) { return a.offset < b.offset; });
    return values;
}

void add_values(const Outline& outline, const Extent& extent, Group& group) {
    std::size_t next = 0;
    const auto fill = [&](std::size_t to) {
        if (next < to) {
            group.items.push_back(plain_bytes(extent.offset + next, to - next, "more", "of no object"));
            group.items.back().wrong = outline.known_minor ? "no object has its value here" : "";
        }
    };
    for (const Placed& value : placed_values(outline)) {
        if (value.offset < next || value.offset + value.length > extent.size) {
            continue;  // judge_sections() blames the object
        }
        fill(value.offset);
        const std::size_t at = extent.offset + value.offset;
        const std::uint32_t number = load(outline.bytes, at, value.length);
        group.items.push_back({at, value.length, value.type, value.name, fmt::format("{}", number),
                               fmt::format("0x{:0{}X}", number, 2 * value.length), ""});
        next = value.offset + value.length;
    }
    fill(extent.size);
}

// Labels may share bytes: the texts are cut wherever one of them begins or ends.
void add_strings(const Outline& outline, const Extent& extent, Group& group) {
    namespace at = image::label;
    std::set<std::size_t> cuts{extent.size};
    const Extent* labels = outline.find(SectionId::labels);
    for (std::size_t i = 0; labels != nullptr && i < labels->count(); ++i) {
        const auto record = outline.record(SectionId::labels, i);
        for (const auto& [offset, length] :
             {std::pair{at::name_offset, at::name_length}, std::pair{at::unit_offset, at::unit_length}}) {
            const std::size_t begin = load(record, offset, 4);
            cuts.insert(std::min(begin, extent.size));
            cuts.insert(std::min(begin + load(record, length, 1), extent.size));
        }
    }
    std::size_t from = 0;
    for (const std::size_t cut : cuts) {
        if (cut > from) {
            Item item = plain_bytes(extent.offset + from, cut - from, fmt::format("at {}", from), "");
            item.type = Type::text;
            item.value = quoted(outline.bytes.subspan(item.offset, item.size));
            group.items.push_back(std::move(item));
            from = cut;
        }
    }
}

// One item for each line.
void add_lines(const Outline& outline, const Extent& extent, Group& group) {
    const auto text = outline.bytes.subspan(extent.offset, extent.size);
    std::size_t from = 0;
    while (from < text.size()) {
        const auto end = std::find(text.begin() + static_cast<std::ptrdiff_t>(from), text.end(), '\n');
        const auto size = static_cast<std::size_t>(end - text.begin()) - from;
        const std::size_t whole = std::min(size + 1, text.size() - from);
        Item item =
            plain_bytes(extent.offset + from, whole, fmt::format("line {}", group.items.size() + 1), "");
        item.type = Type::text;
        item.value = quoted(text.subspan(from, size));
        group.items.push_back(std::move(item));
        from += whole;
    }
}

}  // namespace

void section_groups(const Outline& outline, const Extent& extent, Groups& groups) {
    if (extent.record != nullptr && !extent.record->fields.empty()) {
        add_records(outline, extent, groups);
        return;
    }
    if (extent.size == 0) {
        return;
    }
    if (extent.record == nullptr) {
        Item item = plain_bytes(extent.offset, extent.size, "content", "");
        groups.push_back(
            {"", {}, fmt::format("section {} of a later minor", extent.id), "", {std::move(item)}});
        return;
    }
    Group group{extent.record->name, {}, std::string(extent.record->name), "", {}};
    if (extent.record->section == SectionId::object_values) {
        add_values(outline, extent, group);
    } else if (extent.record->section == SectionId::model) {
        add_lines(outline, extent, group);
    } else {
        add_strings(outline, extent, group);
    }
    groups.push_back(std::move(group));
}

}  // namespace cgw::inspect
