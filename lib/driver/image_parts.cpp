#include "driver/image_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/sha256.hpp"
#include "inspect/fields.hpp"
#include "wire/little_endian.hpp"

namespace cgw::driver {
namespace {

using Bytes = std::span<const std::uint8_t>;

struct Section {
    std::uint16_t record_size = 0;
    Bytes bytes;
};
using Sections = std::map<std::uint16_t, Section>;

bool same_bytes(Bytes a, Bytes b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

Bytes header_of(const image::Image& image) {
    return image.bytes().first(wire::load_u16(&image.bytes()[image::header::header_size]));
}

// Behind the fields that this minor knows.
Bytes unknown_header(const image::Image& image) {
    return header_of(image).subspan(image::header::reserved);
}

// All of the directory, which open() has found consistent.
Sections sections_of(const image::Image& image) {
    namespace entry = image::directory;
    Sections sections;
    const Bytes bytes = image.bytes();
    const std::size_t count = wire::load_u16(&bytes[image::header::section_count]);
    for (std::size_t i = 0; i < count; ++i) {
        const Bytes at = bytes.subspan(header_of(image).size() + i * entry::entry_size);
        sections[wire::load_u16(&at[entry::id])] = {
            wire::load_u16(&at[entry::record_size]),
            bytes.subspan(wire::load_u32(&at[entry::offset]), wire::load_u32(&at[entry::size]))};
    }
    return sections;
}

std::string name_of(std::uint16_t id) {
    const inspect::Record* known = inspect::find_record(id);
    return known != nullptr ? std::string(known->name) : fmt::format("section {}", id);
}

std::string text_of(const Section* section) {
    if (section == nullptr) {
        return "left out";
    }
    return section->record_size == 1
               ? fmt::format("{} bytes", section->bytes.size())
               : fmt::format("{} records of {} bytes", section->bytes.size() / section->record_size,
                             section->record_size);
}

void compare_sections(const Sections& a, const Sections& b, std::vector<PartDifference>& parts) {
    Sections all = a;
    all.insert(b.begin(), b.end());
    for (const auto& [id, unused] : all) {
        const auto in_a = a.find(id);
        const auto in_b = b.find(id);
        const Section* of_a = in_a == a.end() ? nullptr : &in_a->second;
        const Section* of_b = in_b == b.end() ? nullptr : &in_b->second;
        if (of_a != nullptr && of_b != nullptr && of_a->record_size == of_b->record_size &&
            same_bytes(of_a->bytes, of_b->bytes)) {
            continue;
        }
        const PartKind kind =
            inspect::find_record(id) != nullptr ? PartKind::section : PartKind::later_section;
        std::string text_b = text_of(of_b);
        if (text_b == text_of(of_a)) {
            text_b = "others";
        }
        parts.push_back({kind, name_of(id), text_of(of_a), std::move(text_b)});
    }
}

std::string format_text(const image::Image& image) {
    return fmt::format("{}.{}", image.format_major(), image.format_minor());
}

std::string version_text(const image::Image& image) {
    return fmt::format("cgw {}", fmt::join(image.tool_version(), "."));
}

std::string header_text(const image::Image& image) {
    return fmt::format("{} bytes, behind the known {:02x}", header_of(image).size(),
                       fmt::join(unknown_header(image), " "));
}

bool longer(const Section& section, std::uint16_t id) {
    const inspect::Record* known = inspect::find_record(id);
    return known != nullptr && section.record_size > known->size;
}

}  // namespace

std::vector<PartDifference> differing_parts(const image::Image& a, const image::Image& b) {
    std::vector<PartDifference> parts;
    if (a.format_minor() != b.format_minor()) {
        parts.push_back({PartKind::format, "format", format_text(a), format_text(b)});
    }
    if (a.tool_version() != b.tool_version()) {
        parts.push_back({PartKind::version, "written by", version_text(a), version_text(b)});
    }
    if (!same_bytes(unknown_header(a), unknown_header(b))) {
        parts.push_back({PartKind::header, "header", header_text(a), header_text(b)});
    }
    if (!same_bytes(a.configuration_id(), b.configuration_id())) {
        parts.push_back({PartKind::configuration_id, "configuration id", base::short_id(a.configuration_id()),
                         base::short_id(b.configuration_id())});
    }
    compare_sections(sections_of(a), sections_of(b), parts);
    return parts;
}

std::vector<std::string> parts_of_a_later_minor(const image::Image& image) {
    std::vector<std::string> parts;
    if (image.format_minor() > image::format_minor) {
        parts.push_back(fmt::format("format {}, as this cgw writes {}.{}", format_text(image),
                                    image::format_major, image::format_minor));
    }
    const std::size_t more = header_of(image).size() - image::header::size;
    if (more != 0) {
        parts.push_back(fmt::format("{} bytes of a longer header", more));
    }
    const Bytes reserved =
        unknown_header(image).first(image::header::size - std::size_t{image::header::reserved});
    if (std::any_of(reserved.begin(), reserved.end(), [](std::uint8_t byte) { return byte != 0; })) {
        parts.emplace_back("what the reserved bytes of the header say");
    }
    for (const auto& [id, section] : sections_of(image)) {
        if (inspect::find_record(id) == nullptr) {
            parts.push_back(
                fmt::format("section {}, {} bytes, which this cgw does not know", id, section.bytes.size()));
        } else if (longer(section, id)) {
            parts.push_back(fmt::format("what is behind the first {} bytes of each record in {}",
                                        inspect::find_record(id)->size, name_of(id)));
        }
    }
    return parts;
}

}  // namespace cgw::driver
