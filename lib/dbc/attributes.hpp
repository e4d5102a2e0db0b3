// Inside the dbc room: what a file says in attributes of its messages, until all of it is read. Definitions,
// defaults and values may stand in any order, and what a message does not say is the default.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "dbc/database.hpp"

namespace cgw::dbc {

// Texts belong to the file that is read.
struct Attributes {
    std::map<std::uint32_t, std::uint32_t> cycle_times;  // ms, by identifier
    std::uint32_t default_cycle_time = 0;

    // A word, or its number among the words that the file defines.
    std::map<std::uint32_t, std::string_view> send_types;
    std::string_view default_send_type;
    std::vector<std::string_view> send_type_words;  // empty: as this program prints them

    // Likewise, of VFrameFormat.
    std::map<std::uint32_t, std::string_view> frame_formats;
    std::string_view default_frame_format;
    std::vector<std::string_view> frame_format_words;

    void apply(std::vector<Message>& messages) const;
};

}  // namespace cgw::dbc
