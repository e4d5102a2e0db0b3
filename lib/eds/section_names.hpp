// What the names of sections say, and which section is which object's.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "eds/document.hpp"

namespace cgw::eds {

enum class SectionKind : std::uint8_t {
    unknown,
    file_info,
    device_info,
    commissioning,
    dummy_usage,
    comments,
    mandatory_objects,
    optional_objects,
    manufacturer_objects,
    supported_modules,
    connected_modules,
    dynamic_channels,
    tools,

    // Of an object; with a module number, of a fixed object of a module.
    object,        // [1018]
    sub_object,    // [1018sub1]
    names,         // [1018Name]
    values,        // [1018Value]
    denotations,   // [1018Denotation]
    object_links,  // [1018ObjectLinks]

    // Of a module.
    module_info,
    module_comments,
    module_fixed_objects,
    module_sub_extends,
    module_sub_extension,  // [M1SubExt6000]
};

struct SectionName {
    SectionKind kind = SectionKind::unknown;
    bool misspelt = false;    // known, and not what CiA 306 calls it
    std::uint8_t module = 0;  // 1.., 0: of the device
    std::uint16_t index = 0;
    std::uint8_t sub_index = 0;
};

SectionName parse_section_name(std::string_view name);

// The name of a section as CiA 306 spells it; "" for those of objects and modules.
std::string_view standard_name(SectionKind kind);

// All sections of a document by what they are.
class SectionTable {
  public:
    explicit SectionTable(const Document& document);

    const SectionName& name(std::uint32_t section) const { return names_[section]; }

    // The number of the first such section.
    std::optional<std::uint32_t> find(const SectionName& name) const;
    std::optional<std::uint32_t> find(SectionKind kind) const { return find(SectionName{.kind = kind}); }
    std::optional<std::uint32_t> find_object(std::uint16_t index) const;
    std::optional<std::uint32_t> find_sub_object(std::uint16_t index, std::uint8_t sub_index) const;

    // Section numbers: those of the device before those of each module, by index, kind and sub-index; those
    // of the same name in file order.
    const std::vector<std::uint32_t>& ordered() const { return ordered_; }

  private:
    std::vector<SectionName> names_;  // by section number
    std::vector<std::uint64_t> keys_;
    std::vector<std::uint32_t> ordered_;
};

}  // namespace cgw::eds
