// Header and directory, with what is wrong about each field.
#include <algorithm>

#include <fmt/format.h>

#include "inspect/walk.hpp"

namespace cgw::inspect {
namespace {

namespace header_at = image::header;
namespace entry_at = image::directory;

void blame(Group& group, std::size_t offset, std::string wrong) {
    for (Item& item : group.items) {
        if (item.offset == offset) {
            item.wrong = std::move(wrong);
            return;
        }
    }
}

bool has(const Outline& outline, std::size_t offset, std::size_t size) {
    return offset + size <= outline.bytes.size();
}

void judge_header(const Outline& outline, Group& group) {
    const std::span<const std::uint8_t> bytes = outline.bytes;
    const bool magic_fits = has(outline, 0, sizeof image::magic) &&
                            std::equal(std::begin(image::magic), std::end(image::magic), bytes.begin());
    if (!magic_fits) {
        blame(group, header_at::magic, "not a configuration image: those begin with \"CGWI\"");
        return;
    }
    if (!outline.readable) {
        return;  // cut off, or of another major; the field says so already
    }
    const std::size_t stated_header = load(bytes, header_at::header_size, 2);
    const bool longer = !outline.known_minor && stated_header == outline.header_size;
    if (stated_header != header_at::size && !longer) {
        blame(group, header_at::header_size, fmt::format("must be {}", header_at::size));
    }
    if (load(bytes, header_at::section_count, 2) != outline.entries) {
        blame(group, header_at::section_count, "so many entries do not fit into the image");
    }
    if (const std::size_t stated = load(bytes, header_at::total_size, 4); stated != bytes.size()) {
        blame(group, header_at::total_size, fmt::format("the file has {} bytes", bytes.size()));
    }
}

// What the directory may say next.
struct Expected {
    std::size_t end;  // of the section before
    std::uint32_t last_id = 0;
};

std::string wrong_record_size(const Outline& outline, const Record* record, std::size_t record_size) {
    if (record_size == 0) {
        return "must not be 0";
    }
    const bool exact = outline.known_minor || (record != nullptr && record->fields.empty());
    const bool fits =
        record == nullptr || record_size == record->size || (!exact && record_size > record->size);
    return fits ? "" : fmt::format("must be {}", record->size);
}

std::string wrong_size(const Outline& outline, const Record* record, std::size_t record_size,
                       std::size_t offset, std::size_t size) {
    const std::size_t limit = std::min(outline.crc_offset, outline.bytes.size());
    if (offset > limit || size > limit - offset) {
        return "reaches beyond the image";
    }
    if (record_size != 0 && size % record_size != 0) {
        return "not a multiple of record_size";
    }
    const std::size_t count = record != nullptr ? record->count : 0;
    return count != 0 && record_size != 0 && size / record_size != count
               ? fmt::format("must hold {} record{}", count, count == 1 ? "" : "s")
               : "";
}

void judge_entry(const Outline& outline, std::size_t at, Expected& expected, Group& group) {
    const std::uint32_t id = load(outline.bytes, at + entry_at::id, 2);
    const std::size_t record_size = load(outline.bytes, at + entry_at::record_size, 2);
    const std::size_t offset = load(outline.bytes, at + entry_at::offset, 4);
    const std::size_t size = load(outline.bytes, at + entry_at::size, 4);
    const Record* record = find_record(static_cast<std::uint16_t>(id));
    group.title = record != nullptr ? fmt::format("directory: {}", record->name)
                                    : fmt::format("directory: section {}", id);
    for (Item& item : group.items) {
        if (item.offset == at + entry_at::id) {
            item.meaning = record != nullptr ? std::string(record->name) : "not known to this minor";
        }
    }
    if (id <= expected.last_id) {
        blame(group, at + entry_at::id, "ids must ascend");
    } else if (record == nullptr && outline.known_minor) {
        blame(group, at + entry_at::id, "this minor has no such section");
    }
    blame(group, at + entry_at::record_size, wrong_record_size(outline, record, record_size));
    if (offset != align_up(expected.end)) {
        blame(group, at + entry_at::offset, fmt::format("must be {}", align_up(expected.end)));
    }
    blame(group, at + entry_at::size, wrong_size(outline, record, record_size, offset, size));
    expected.last_id = id;
    expected.end = offset + size;
}

}  // namespace

void header_groups(const Outline& outline, Groups& groups) {
    groups.push_back(record_group(outline, header(), {}, 0, header_at::size));
    judge_header(outline, groups.back());
    if (!outline.readable) {
        return;
    }
    if (outline.header_size > header_at::size) {
        const std::size_t more = outline.header_size - header_at::size;
        groups.back().items.push_back(plain_bytes(header_at::size, more, "more", "of a later minor"));
    }
    Expected expected{outline.header_size + outline.entries * entry_at::entry_size};
    for (std::size_t i = 0; i < outline.entries; ++i) {
        const std::size_t at = outline.header_size + i * entry_at::entry_size;
        groups.push_back(record_group(outline, directory(), i, at, entry_at::entry_size));
        judge_entry(outline, at, expected, groups.back());
    }
}

}  // namespace cgw::inspect
