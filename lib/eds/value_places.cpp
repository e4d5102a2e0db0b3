#include "eds/value_places.hpp"

#include <optional>

#include "base/numbers.hpp"

namespace cgw::eds {

diagnostic::Range ValuePlaces::of_object(std::uint16_t index, std::uint8_t sub_index) const {
    if (const auto own = sections_.find_sub_object(index, sub_index)) {
        return value_in(*own);
    }
    const SectionName values{.kind = SectionKind::values, .index = index};
    if (const auto compact = sections_.find(values)) {
        const Section& entries = section(*compact);
        for (std::uint32_t line = entries.header + 1; line < entries.end; ++line) {
            if (document_.lines()[line].kind == LineKind::entry &&
                base::parse_integer(document_.key(line)) == sub_index) {
                return document_.range(document_.value_span(line));
            }
        }
    }
    const auto object = sections_.find_object(index);
    return object ? value_in(*object) : diagnostic::Range{};
}

diagnostic::Range ValuePlaces::of_key(SectionKind kind, std::string_view key) const {
    const auto number = sections_.find(kind);
    if (!number) {
        return {};
    }
    const std::optional<std::uint32_t> line = document_.find(section(*number), key);
    return line ? document_.range(document_.value_span(*line)) : header_of(*number);
}

diagnostic::Range ValuePlaces::value_in(std::uint32_t number) const {
    for (const std::string_view key : {"ParameterValue", "DefaultValue"}) {
        const std::optional<std::uint32_t> line = document_.find(section(number), key);
        if (line && !document_.value(*line).empty()) {
            return document_.range(document_.value_span(*line));
        }
    }
    return header_of(number);
}

}  // namespace cgw::eds
