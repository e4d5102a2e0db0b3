#include "image_writer/image_writer.hpp"

#include <algorithm>
#include <bit>
#include <stdexcept>

#include "image/image.hpp"
#include "image_writer/sections.hpp"
#include "wire/crc32.hpp"
#include "wire/little_endian.hpp"

namespace cgw::image_writer {
namespace {

std::size_t align_up(std::size_t offset) {
    return (offset + 3U) & ~std::size_t{3U};
}

base::Bytes header(const Source& source, std::size_t section_count, std::size_t total_size) {
    namespace at = image::header;
    Record record(at::size);
    for (std::size_t i = 0; i < sizeof image::magic; ++i) {
        record.u8(at::magic + i, image::magic[i]);
    }
    record.u16(at::format_major, image::format_major);
    record.u16(at::format_minor, image::format_minor);
    record.u16(at::header_size, at::size);
    record.u16(at::section_count, static_cast<std::uint16_t>(section_count));
    record.u32(at::total_size, static_cast<std::uint32_t>(total_size));
    for (std::size_t i = 0; i < source.configuration_id.size(); ++i) {
        record.u8(at::configuration_id + i, source.configuration_id[i]);
    }
    for (std::size_t i = 0; i < source.tool_version.size(); ++i) {
        record.u16(at::tool_version + 2 * i, source.tool_version[i]);
    }
    return record.bytes();
}

Record directory_entry(const Section& section, std::size_t offset) {
    namespace at = image::directory;
    Record entry(at::entry_size);
    entry.u16(at::id, static_cast<std::uint16_t>(section.id));
    entry.u16(at::record_size, section.record_size);
    entry.u32(at::offset, static_cast<std::uint32_t>(offset));
    entry.u32(at::size, static_cast<std::uint32_t>(section.bytes.size()));
    return entry;
}

void put(base::Bytes& image, const base::Bytes& bytes, std::size_t offset) {
    std::copy(bytes.begin(), bytes.end(), image.begin() + static_cast<std::ptrdiff_t>(offset));
}

}  // namespace

void Record::u16(std::size_t offset, std::uint16_t value) {
    wire::store_u16(&bytes_[offset], value);
}

void Record::u32(std::size_t offset, std::uint32_t value) {
    wire::store_u32(&bytes_[offset], value);
}

void Record::f64(std::size_t offset, double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    u32(offset, static_cast<std::uint32_t>(bits));
    u32(offset + 4, static_cast<std::uint32_t>(bits >> 32));
}

void append(Section& section, const Record& record) {
    section.bytes.insert(section.bytes.end(), record.bytes().begin(), record.bytes().end());
}

base::Bytes assemble(const std::vector<Section>& sections, const Source& source) {
    std::size_t end = image::header::size + sections.size() * image::directory::entry_size;
    std::vector<std::size_t> offsets;
    for (const Section& section : sections) {
        offsets.push_back(align_up(end));
        end = offsets.back() + section.bytes.size();
    }
    const std::size_t crc_offset = align_up(end);
    base::Bytes image(crc_offset + image::crc_size);
    put(image, header(source, sections.size(), image.size()), 0);
    for (std::size_t i = 0; i < sections.size(); ++i) {
        put(image, directory_entry(sections[i], offsets[i]).bytes(),
            image::header::size + i * image::directory::entry_size);
        put(image, sections[i].bytes, offsets[i]);
    }
    wire::store_u32(&image[crc_offset], wire::crc32({image.data(), crc_offset}));
    return image;
}

base::Bytes write_image(const Source& source) {
    ObjectSections objects = object_sections(source);
    std::vector<Section> sections = {identity_section(source),  buses_section(source),
                                     governor_section(source),  heartbeat_section(source),
                                     pdos_section(source),      std::move(objects.objects),
                                     std::move(objects.values), switches_section(source),
                                     sensors_section(source),   signals_section(source)};
    if (source.labels) {
        LabelSections labels = label_sections(source);
        sections.push_back(std::move(labels.labels));
        sections.push_back(std::move(labels.strings));
        sections.push_back(model_section(source));
    }
    base::Bytes bytes = assemble(sections, source);
    if (source.labels && bytes.size() > image::maximum_size) {
        sections.pop_back();  // the model serves tools only
        bytes = assemble(sections, source);
    }
    image::Image verified;
    const image::Status status = image::Image::open(bytes, verified);
    if (status != image::Status::ok) {
        throw std::logic_error("the image just written is refused by its reader: " +
                               std::string(image::to_text(status)));
    }
    return bytes;
}

}  // namespace cgw::image_writer
