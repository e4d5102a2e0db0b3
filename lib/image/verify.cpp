// From the outside in: header, CRC-32, directory, sections one by one, then against each other.
#include "image/verify.hpp"

#include "wire/crc32.hpp"
#include "wire/little_endian.hpp"
#include "wire/search.hpp"

namespace cgw::image {
namespace {

constexpr CrossCheck cross_checks[] = {
    {buses_fit, Status::bad_section, SectionId::buses},
    {heartbeats_fit, Status::bad_section, SectionId::heartbeat},
    {objects_fit, Status::bad_object_table, SectionId::objects},
    {pdos_fit, Status::bad_section, SectionId::pdos},
    {mappings_fit, Status::bad_mapping, SectionId::pdos},
    {identifiers_fit, Status::bad_section, SectionId::pdos},
    {signals_fit, Status::bad_section, SectionId::signals},
    {inputs_fit, Status::bad_section, SectionId::switches},
    {labels_fit, Status::bad_label, SectionId::labels},
};

constexpr std::size_t align_up(std::size_t offset) {
    return (offset + 3U) & ~std::size_t{3U};
}

}  // namespace

class Verifier {
  public:
    explicit Verifier(std::span<const std::uint8_t> bytes) : bytes_(bytes) { image_.bytes_ = bytes; }

    Status run() {
        for (const auto step : {&Verifier::check_header, &Verifier::check_crc, &Verifier::check_directory,
                                &Verifier::check_presence, &Verifier::check_sections}) {
            const Status status = (this->*step)();
            if (status != Status::ok) {
                return status;
            }
        }
        return Status::ok;
    }

    const Image& image() const { return image_; }
    SectionId section() const { return section_; }  // that the last step looked at; none before sections

  private:
    Status check_header();
    Status check_crc();
    Status check_directory();
    Status check_entry(const std::uint8_t* entry, std::size_t& end);
    Status check_presence();
    Status check_sections();

    std::size_t crc_offset() const { return bytes_.size() - crc_size; }

    std::span<const std::uint8_t> bytes_;
    Image image_;
    std::uint16_t header_size_ = 0;
    std::uint16_t section_count_ = 0;
    SectionId section_{};
};

Status Verifier::check_header() {
    if (bytes_.size() < minimum_size) {
        return Status::too_small;
    }
    if (bytes_.size() > maximum_size) {
        return Status::too_large;
    }
    const std::uint8_t* data = bytes_.data();
    if (wire::load_u32(data + header::magic) != wire::load_u32(magic)) {
        return Status::bad_magic;
    }
    if (image_.format_major() != format_major) {
        return Status::unsupported_major;
    }
    header_size_ = wire::load_u16(data + header::header_size);
    section_count_ = wire::load_u16(data + header::section_count);
    const bool known = is_known_minor(image_);
    if (header_size_ < header::size || header_size_ % 4 != 0 || (known && header_size_ != header::size)) {
        return Status::bad_header_size;
    }
    if (wire::load_u32(data + header::total_size) != bytes_.size()) {
        return Status::size_mismatch;
    }
    if (header_size_ + section_count_ * directory::entry_size > crc_offset()) {
        return Status::bad_directory;
    }
    if (known && !wire::all_zero(bytes_.subspan(header::reserved, header::size - header::reserved))) {
        return Status::bad_header_size;
    }
    return Status::ok;
}

Status Verifier::check_crc() {
    return wire::crc32(bytes_.first(crc_offset())) == image_.crc() ? Status::ok : Status::bad_crc;
}

Status Verifier::check_directory() {
    std::size_t end = header_size_ + section_count_ * directory::entry_size;
    std::uint16_t last_id = 0;
    for (std::size_t i = 0; i < section_count_; ++i) {
        const std::uint8_t* entry = bytes_.data() + header_size_ + i * directory::entry_size;
        const std::uint16_t id = wire::load_u16(entry + directory::id);
        if (id <= last_id) {
            return Status::bad_directory;
        }
        last_id = id;
        const Status status = check_entry(entry, end);
        if (status != Status::ok) {
            return status;
        }
    }
    const bool ends_at_crc = align_up(end) == crc_offset();
    return ends_at_crc && wire::all_zero(bytes_.subspan(end, crc_offset() - end)) ? Status::ok
                                                                                  : Status::bad_directory;
}

// `end` is where the section before this one ended, and becomes where this one ends; never past the CRC.
Status Verifier::check_entry(const std::uint8_t* entry, std::size_t& end) {
    const std::uint16_t id = wire::load_u16(entry + directory::id);
    const std::uint16_t record_size = wire::load_u16(entry + directory::record_size);
    const std::uint32_t offset = wire::load_u32(entry + directory::offset);
    const std::uint32_t size = wire::load_u32(entry + directory::size);
    const bool inside = offset == align_up(end) && offset <= crc_offset() && size <= crc_offset() - offset;
    if (!inside || record_size == 0 || size % record_size != 0 ||
        !wire::all_zero(bytes_.subspan(end, offset - end))) {
        return Status::bad_directory;
    }
    end = offset + size;
    const bool known = is_known_minor(image_);
    if (id >= section_ids) {
        return known ? Status::bad_directory : Status::ok;
    }
    const SectionRule& rule = section_rules()[id - 1U];
    const bool exact = known || rule.bytes;
    const std::size_t count = size / record_size;
    if (record_size < rule.record_size || (exact && record_size != rule.record_size) ||
        (rule.record_count != 0 && count != rule.record_count)) {
        return Status::bad_directory;
    }
    image_.sections_[id] = {bytes_.data() + offset, size, record_size};
    return Status::ok;
}

Status Verifier::check_presence() {
    for (const SectionRule& rule : section_rules()) {
        section_ = rule.id;
        if (rule.required && image_.records(rule.id).data == nullptr) {
            return Status::section_missing;
        }
    }
    const bool labels = image_.records(SectionId::labels).data != nullptr;
    const bool strings = image_.records(SectionId::strings).data != nullptr;
    const bool model = image_.records(SectionId::model).data != nullptr;
    section_ = labels && !strings ? SectionId::strings : SectionId::labels;  // that is missing
    return labels == strings && (labels || !model) ? Status::ok : Status::section_missing;
}

Status Verifier::check_sections() {
    for (const SectionRule& rule : section_rules()) {
        section_ = rule.id;
        const Status status = check_fields(image_, rule);
        if (status != Status::ok) {
            return status;
        }
    }
    for (const CrossCheck& check : cross_checks) {
        section_ = check.section;
        if (!check.holds(image_)) {
            return check.status;
        }
    }
    return Status::ok;
}

Refusal examine(std::span<const std::uint8_t> bytes) {
    Verifier verifier(bytes);
    const Status status = verifier.run();
    return {status, status == Status::ok ? SectionId{} : verifier.section()};
}

Status Image::open(std::span<const std::uint8_t> bytes, Image& image) {
    Verifier verifier(bytes);
    const Status status = verifier.run();
    if (status == Status::ok) {
        image = verifier.image();
    }
    return status;
}

}  // namespace cgw::image
