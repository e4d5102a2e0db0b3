#include "dbc/attributes.hpp"

#include <algorithm>

#include "base/ascii.hpp"
#include "base/numbers.hpp"
#include "dbc/words.hpp"

namespace cgw::dbc {
namespace {

SendType type_of_word(std::string_view word) {
    const auto* const found =
        std::find_if(send_types.begin(), send_types.end(),
                     [word](std::string_view each) { return base::equal_ignoring_case(each, word); });
    return found != send_types.end() ? static_cast<SendType>(found - send_types.begin()) : SendType::other;
}

template <typename Words>
SendType type_numbered(std::uint64_t number, const Words& words) {
    return number < words.size() ? type_of_word(words[number]) : SendType::other;
}

// A number counts the words of the definition.
SendType type_of(std::string_view value, const std::vector<std::string_view>& words) {
    if (value.empty()) {
        return SendType::not_stated;
    }
    const auto number = base::parse_integer(value);
    if (!number || *number < 0) {
        return type_of_word(value);
    }
    const auto place = static_cast<std::uint64_t>(*number);
    return words.empty() ? type_numbered(place, send_types) : type_numbered(place, words);
}

// Tools count StandardCAN as 0 where the file defines no words.
bool is_standard(std::string_view value, const std::vector<std::string_view>& words) {
    const auto number = base::parse_integer(value);
    if (number && *number >= 0 && static_cast<std::uint64_t>(*number) < words.size()) {
        value = words[static_cast<std::size_t>(*number)];
    }
    return value.empty() || value == "0" || base::equal_ignoring_case(value, "StandardCAN");
}

}  // namespace

void Attributes::apply(std::vector<Message>& messages) const {
    for (Message& message : messages) {
        const auto cycle = cycle_times.find(message.identifier);
        const std::uint32_t cycle_ms = cycle != cycle_times.end() ? cycle->second : default_cycle_time;
        message.cycle_ms = cycle_ms != 0 ? std::optional(cycle_ms) : std::nullopt;
        const auto type = send_types.find(message.identifier);
        message.send_type =
            type_of(type != send_types.end() ? type->second : default_send_type, send_type_words);
        const auto format = frame_formats.find(message.identifier);
        message.standard_format = is_standard(
            format != frame_formats.end() ? format->second : default_frame_format, frame_format_words);
    }
}

}  // namespace cgw::dbc
