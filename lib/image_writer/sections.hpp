// The sections of an image before they are put together. Private to the room.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/bytes.hpp"
#include "image/layout.hpp"
#include "image_writer/image_writer.hpp"

namespace cgw::image_writer {

struct Section {
    image::SectionId id = image::SectionId::identity;
    std::uint16_t record_size = 1;
    base::Bytes bytes;
};

// One zeroed record of a section; offsets are the layout's.
class Record {
  public:
    explicit Record(std::size_t size) : bytes_(size) {}

    void u8(std::size_t offset, std::uint8_t value) { bytes_[offset] = value; }
    void flag(std::size_t offset, bool value) { bytes_[offset] = value ? 1 : 0; }
    void u16(std::size_t offset, std::uint16_t value);
    void u32(std::size_t offset, std::uint32_t value);
    void f64(std::size_t offset, double value);

    const base::Bytes& bytes() const { return bytes_; }

  private:
    base::Bytes bytes_;
};

void append(Section& section, const Record& record);

Section identity_section(const Source& source);
Section buses_section(const Source& source);
Section governor_section(const Source& source);
Section heartbeat_section(const Source& source);
Section pdos_section(const Source& source);
Section switches_section(const Source& source);
Section sensors_section(const Source& source);
Section signals_section(const Source& source);

struct ObjectSections {
    Section objects;
    Section values;
};
ObjectSections object_sections(const Source& source);

struct LabelSections {
    Section labels;
    Section strings;
};
LabelSections label_sections(const Source& source);

// The canonical model: what the configuration id is the SHA-256 of.
Section model_section(const Source& source);

// Parameters that a TPDO word or a sensor carries, ascending number, each once.
std::vector<const parameter::Row*> carried_parameters(const config::Configuration& configuration);

// Header, directory, the sections in the order given (ascending id), CRC-32.
base::Bytes assemble(const std::vector<Section>& sections, const Source& source);

}  // namespace cgw::image_writer
