#include <algorithm>

#include <fmt/format.h>

#include "inspect/annotation.hpp"
#include "inspect/field_value.hpp"
#include "inspect/walk.hpp"
#include "wire/crc32.hpp"
#include "wire/little_endian.hpp"

namespace cgw::inspect {
namespace {

constexpr std::size_t longest_padding = 3;

// Bytes from `from` to `to` that no part claims.
void add_gap(const Outline& outline, std::size_t from, std::size_t to, Groups& groups) {
    if (from >= to) {
        return;
    }
    const bool is_padding = to - from <= longest_padding;
    Item item = plain_bytes(from, to - from, is_padding ? "padding" : "unclaimed", "");
    const auto bytes = outline.bytes.subspan(from, to - from);
    const bool zero = std::all_of(bytes.begin(), bytes.end(), [](std::uint8_t byte) { return byte == 0; });
    if (!is_padding) {
        item.wrong = "these bytes belong to no section";
    } else if (!zero) {
        item.wrong = "must be 0";
    }
    if (is_padding && !groups.empty()) {
        groups.back().items.push_back(std::move(item));
    } else {
        groups.push_back({"", {}, "bytes of no section", "", {std::move(item)}});
    }
}

void add_trailer(const Outline& outline, Groups& groups) {
    const std::size_t at = outline.crc_offset;
    if (at + image::crc_size > outline.bytes.size()) {
        groups.push_back({trailer().name, {}, "trailer", "the image is cut off: there is no CRC-32", {}});
        return;
    }
    Group group = record_group(outline, trailer(), {}, at, image::crc_size);
    const std::uint32_t computed = wire::crc32(outline.bytes.first(at));
    if (computed != load(outline.bytes, at, image::crc_size)) {
        group.items.front().wrong = fmt::format("the bytes before have 0x{:08X}", computed);
    }
    groups.push_back(std::move(group));
}

// Everything behind the header.
void add_body(const Outline& outline, Groups& groups) {
    std::size_t end = outline.header_size + outline.entries * image::directory::entry_size;
    for (const Extent& extent : outline.sections) {
        add_gap(outline, end, extent.offset, groups);
        section_groups(outline, extent, groups);
        end = extent.offset + extent.size;
    }
    add_gap(outline, end, std::min(outline.crc_offset, outline.bytes.size()), groups);
    add_trailer(outline, groups);
    const std::size_t image_end = outline.crc_offset + image::crc_size;
    if (image_end < outline.bytes.size()) {
        Item item = plain_bytes(image_end, outline.bytes.size() - image_end, "appended", "");
        item.wrong = "behind the end that the header states";
        groups.push_back({"", {}, "bytes behind the image", "", {std::move(item)}});
    }
}

bool anything_wrong(const Groups& groups, std::string_view section) {
    return std::any_of(groups.begin(), groups.end(), [&](const Group& group) {
        const bool field = std::any_of(group.items.begin(), group.items.end(),
                                       [](const Item& item) { return !item.wrong.empty(); });
        return group.section == section && (field || !group.wrong.empty());
    });
}

// Where no field of the refused section is to blame alone, the section as a whole is.
void blame_section(const image::Refusal& refusal, Groups& groups) {
    const Record* record = find_record(static_cast<std::uint16_t>(refusal.section));
    if (record == nullptr || anything_wrong(groups, record->name)) {
        return;
    }
    for (Group& group : groups) {
        if (group.section == record->name) {
            group.wrong = std::string(image::to_text(refusal.status));
            return;
        }
    }
    groups.back().wrong = fmt::format("{}: {}", image::to_text(refusal.status), record->name);
}

// The verifier's word on the same bytes with a right CRC-32.
image::Refusal examine_beyond_crc(std::span<const std::uint8_t> bytes) {
    std::vector<std::uint8_t> copy(bytes.begin(), bytes.end());
    const std::size_t body = copy.size() - image::crc_size;
    wire::store_u32(&copy[body], wire::crc32({copy.data(), body}));
    return image::examine(copy);
}

}  // namespace

Item plain_bytes(std::size_t offset, std::size_t size, std::string name, std::string meaning) {
    return {offset, size, Type::bytes, std::move(name), "", std::move(meaning), ""};
}

Group record_group(const Outline& outline, const Record& record, std::optional<std::size_t> position,
                   std::size_t at, std::size_t size) {
    Group group{record.name, position, std::string(record.name), "", {}};
    const std::size_t end = std::min(at + size, outline.bytes.size());
    std::size_t next = at;
    for (const Field& field : record.fields) {
        const bool as_bytes = field.type == Type::bytes || field.type == Type::text;
        const std::size_t step = as_bytes ? field.count : size_of(field.type);
        for (std::size_t element = 0; element < (as_bytes ? 1 : field.count); ++element) {
            if (next + step > end) {
                if (next < end) {
                    group.items.push_back(plain_bytes(next, end - next, element_name(field, element), ""));
                    group.items.back().wrong = "cut off";
                }
                group.wrong = "cut off";
                return group;
            }
            group.items.push_back(item_of(outline, field, element, position.value_or(0), next));
            next += step;
        }
    }
    if (next < end) {
        group.items.push_back(plain_bytes(next, end - next, "more", "of a later minor"));
        group.items.back().wrong = outline.known_minor ? "this minor has no such bytes" : "";
    }
    return group;
}

Annotation annotate(std::span<const std::uint8_t> bytes) {
    Annotation annotation;
    const Outline outline = outline_of(bytes);
    header_groups(outline, annotation.groups);
    if (outline.readable) {
        add_body(outline, annotation.groups);
        judge_sections(outline, annotation.groups);
    } else if (bytes.size() > image::header::size) {
        Item rest = plain_bytes(image::header::size, bytes.size() - image::header::size, "not read", "");
        annotation.groups.push_back({"", {}, "what follows is not read", "", {std::move(rest)}});
    }
    annotation.model_fits = !anything_wrong(annotation.groups, "model");
    image::Refusal refusal = image::examine(bytes);
    annotation.status = refusal.status;
    if (refusal.status == image::Status::bad_crc) {
        refusal = examine_beyond_crc(bytes);
        annotation.status_beyond_crc = refusal.status;
    }
    if (refusal.status != image::Status::ok) {
        blame_section(refusal, annotation.groups);
    }
    return annotation;
}

}  // namespace cgw::inspect
