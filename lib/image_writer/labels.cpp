// Names, units and engineering ranges for displays, and the canonical model for tools.
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "image_writer/sections.hpp"
#include "image_writer/text.hpp"

namespace cgw::image_writer {
namespace {

struct Entry {
    std::string_view name;
    std::string_view unit;
    std::optional<parameter::ExternalLimits> external;
};

// Each text once, in the order of first use.
class Strings {
  public:
    std::uint32_t offset_of(const std::string& text) {
        const auto [found, added] = offsets_.emplace(text, static_cast<std::uint32_t>(bytes_.size()));
        if (added) {
            bytes_.insert(bytes_.end(), text.begin(), text.end());
        }
        return found->second;
    }

    base::Bytes take() { return std::move(bytes_); }

  private:
    std::map<std::string, std::uint32_t> offsets_;
    base::Bytes bytes_;
};

Record label_record(std::uint16_t number, const Entry& entry, Strings& strings) {
    namespace at = image::label;
    const std::string name = display_text(entry.name);
    const std::string unit = display_text(entry.unit);
    Record record(at::size);
    record.u16(at::number, number);
    record.u8(at::name_length, static_cast<std::uint8_t>(name.size()));
    record.u8(at::unit_length, static_cast<std::uint8_t>(unit.size()));
    record.u32(at::name_offset, strings.offset_of(name));
    record.u32(at::unit_offset, strings.offset_of(unit));
    record.flag(at::has_scaling, entry.external.has_value());
    if (entry.external) {
        record.f64(at::external_minimum, entry.external->minimum);
        record.f64(at::external_maximum, entry.external->maximum);
    }
    return record;
}

std::map<std::uint16_t, Entry> label_entries(const Source& source) {
    std::map<std::uint16_t, Entry> entries;
    entries[0].name = source.settings.title;
    for (const parameter::Row* row : carried_parameters(source.configuration)) {
        const auto external = parameter::external_limits(*row, source.settings.governor);
        if (!row->name.empty() || !row->unit.empty() || external) {
            entries[row->number] = {row->name, row->unit, external};
        }
    }
    for (const config::SwitchFunction& function : source.configuration.switches) {
        if (!function.row->name.empty()) {
            entries[function.row->number] = {function.row->name, {}, std::nullopt};
        }
    }
    return entries;
}

}  // namespace

LabelSections label_sections(const Source& source) {
    LabelSections sections{{image::SectionId::labels, image::label::size, {}},
                           {image::SectionId::strings, 1, {}}};
    Strings strings;
    for (const auto& [number, entry] : label_entries(source)) {
        append(sections.labels, label_record(number, entry, strings));
    }
    sections.strings.bytes = strings.take();
    return sections;
}

Section model_section(const Source& source) {
    return {image::SectionId::model, 1, base::to_bytes(parameter::canonical_text(source.settings))};
}

}  // namespace cgw::image_writer
