// Texts as a label carries them. Private to the room.
#pragma once

#include <string>
#include <string_view>

namespace cgw::image_writer {

inline constexpr std::size_t maximum_label_bytes = 255;

// `text` as UTF-8 without control characters (they become blanks) and without malformed bytes (they become
// '?'), cut at a whole character so that it takes at most maximum_label_bytes.
std::string display_text(std::string_view text);

}  // namespace cgw::image_writer
