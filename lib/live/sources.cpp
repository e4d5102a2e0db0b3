#include "live/sources.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <charconv>

#include "catalogue/objects.hpp"
#include "parameter/value_text.hpp"

namespace cgw::live {
namespace {

using parameter::Device;

constexpr std::string_view digits = "0123456789";
constexpr std::string_view word_ends = " ,;";

// A number alone: not 811..849, not the 5 of TPDO5.
std::uint16_t parameter_number(std::string_view word) {
    std::uint16_t number = 0;
    if (word.find_first_not_of(digits) == std::string_view::npos) {
        std::from_chars(word.data(), word.data() + word.size(), number);
    }
    return number;
}

void name_parameter(const parameter::Row& row, const parameter::Settings& settings, Sources& sources) {
    const double value = settings.of(row.device).value(row.number);
    sources.text += fmt::format(" {}", row.name);
    if (row.settable()) {
        sources.text += fmt::format("={}", parameter::value_text(row, value));
    }
    sources.parameters.push_back({&row, value});
}

}  // namespace

Sources sources_of(std::uint16_t index, std::uint8_t sub_index, const parameter::Settings& settings,
                   const parameter::Catalogue& catalogue) {
    const catalogue::ObjectDescription* description = catalogue::find_object(index, sub_index);
    std::string_view rest = description == nullptr ? std::string_view{} : description->source;
    Sources sources;
    const Device* device = nullptr;
    static constexpr Device devices[] = {Device::governor, Device::gateway};
    while (!rest.empty()) {
        const std::string_view word = rest.substr(0, rest.find_first_of(word_ends));
        sources.text += word;
        for (const Device& candidate : devices) {
            device = word == parameter::to_text(candidate) ? &candidate : device;
        }
        const std::uint16_t number = parameter_number(word);
        const parameter::Row* row =
            device == nullptr || number == 0 ? nullptr : catalogue.find(*device, number);
        if (row != nullptr) {
            name_parameter(*row, settings, sources);
        }
        rest.remove_prefix(word.size());
        const std::size_t next = std::min(rest.find_first_not_of(word_ends), rest.size());
        sources.text += rest.substr(0, next);
        rest.remove_prefix(next);
    }
    return sources;
}

}  // namespace cgw::live
