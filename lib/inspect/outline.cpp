#include "inspect/outline.hpp"

#include <algorithm>

#include "base/utf8.hpp"

namespace cgw::inspect {
namespace {

namespace entry_at = image::directory;
namespace header_at = image::header;

bool is_readable(std::span<const std::uint8_t> bytes) {
    return bytes.size() >= header_at::size &&
           std::equal(std::begin(image::magic), std::end(image::magic), bytes.begin()) &&
           load(bytes, header_at::format_major, 2) == image::format_major;
}

std::size_t believable_header_size(std::span<const std::uint8_t> bytes) {
    const std::size_t stated = load(bytes, header_at::header_size, 2);
    return stated >= header_at::size && stated % 4 == 0 && stated <= bytes.size() ? stated : header_at::size;
}

// Where the image says that it ends, or where the file does.
std::size_t believable_crc_offset(std::span<const std::uint8_t> bytes) {
    const std::size_t stated = load(bytes, header_at::total_size, 4);
    if (stated > bytes.size()) {
        return bytes.size();
    }
    return (stated >= image::minimum_size ? stated : bytes.size()) - image::crc_size;
}

void add_section(Outline& outline, std::size_t position, std::size_t& end) {
    const std::size_t at = outline.header_size + position * entry_at::entry_size;
    Extent extent;
    extent.id = static_cast<std::uint16_t>(load(outline.bytes, at + entry_at::id, 2));
    extent.record_size = static_cast<std::uint16_t>(load(outline.bytes, at + entry_at::record_size, 2));
    extent.offset = load(outline.bytes, at + entry_at::offset, 4);
    extent.size = load(outline.bytes, at + entry_at::size, 4);
    extent.record = find_record(extent.id);
    const std::size_t limit = std::min(outline.crc_offset, outline.bytes.size());
    if (extent.offset < end || extent.offset > limit || extent.record_size == 0) {
        return;
    }
    extent.size = std::min(extent.size, limit - extent.offset);
    end = extent.offset + extent.size;
    outline.sections.push_back(extent);
}

}  // namespace

std::uint32_t load(std::span<const std::uint8_t> bytes, std::size_t offset, std::size_t width) {
    std::uint32_t value = 0;
    if (offset > bytes.size() || width > bytes.size() - offset) {
        return 0;
    }
    for (std::size_t i = 0; i < width; ++i) {
        value |= static_cast<std::uint32_t>(bytes[offset + i]) << (8 * i);
    }
    return value;
}

Outline outline_of(std::span<const std::uint8_t> bytes) {
    Outline outline;
    outline.bytes = bytes;
    outline.readable = is_readable(bytes);
    if (!outline.readable) {
        return outline;
    }
    outline.known_minor = load(bytes, header_at::format_minor, 2) <= image::format_minor;
    outline.header_size = believable_header_size(bytes);
    outline.crc_offset = believable_crc_offset(bytes);
    const std::size_t stated = load(bytes, header_at::section_count, 2);
    const std::size_t limit = std::min(outline.crc_offset, bytes.size());
    const std::size_t room = limit > outline.header_size ? limit - outline.header_size : 0;
    outline.entries = std::min(stated, room / entry_at::entry_size);
    std::size_t end = outline.header_size + outline.entries * entry_at::entry_size;
    for (std::size_t i = 0; i < outline.entries; ++i) {
        add_section(outline, i, end);
    }
    return outline;
}

const Extent* Outline::find(image::SectionId id) const {
    const auto found = std::find_if(sections.begin(), sections.end(), [&](const Extent& extent) {
        return extent.id == static_cast<std::uint16_t>(id);
    });
    return found != sections.end() ? &*found : nullptr;
}

std::span<const std::uint8_t> Outline::record(image::SectionId id, std::size_t position) const {
    const Extent* extent = find(id);
    if (extent == nullptr || position >= extent->count()) {
        return {};
    }
    return bytes.subspan(extent->offset + position * extent->record_size, extent->record_size);
}

std::string label_name(const Outline& outline, std::uint16_t number) {
    namespace at = image::label;
    const Extent* labels = outline.find(image::SectionId::labels);
    const Extent* strings = outline.find(image::SectionId::strings);
    if (labels == nullptr || strings == nullptr || labels->record_size < at::size) {
        return {};
    }
    for (std::size_t i = 0; i < labels->count(); ++i) {
        const std::span<const std::uint8_t> label = outline.record(image::SectionId::labels, i);
        const std::size_t offset = load(label, at::name_offset, 4);
        const std::size_t length = label[at::name_length];
        const bool inside = offset <= strings->size && length <= strings->size - offset;
        if (load(label, at::number, 2) == number && inside) {
            const auto text = outline.bytes.subspan(strings->offset + offset, length);
            return base::printable(std::string(text.begin(), text.end()));
        }
    }
    return {};
}

}  // namespace cgw::inspect
