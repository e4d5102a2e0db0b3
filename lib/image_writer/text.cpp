#include "image_writer/text.hpp"

#include <cstdint>

#include "base/utf8.hpp"

namespace cgw::image_writer {
namespace {

// C0, DEL, and C1, which UTF-8 writes as C2h 80h..9Fh.
bool is_control(std::string_view character) {
    const auto first = static_cast<std::uint8_t>(character[0]);
    return first < 0x20 || first == 0x7F || (first == 0xC2 && static_cast<std::uint8_t>(character[1]) < 0xA0);
}

}  // namespace

std::string display_text(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t size = base::utf8_sequence_length(text);
        const std::string_view character = text.substr(0, size == 0 ? 1 : size);
        const std::string_view shown = size == 0 ? "?" : is_control(character) ? " " : character;
        if (result.size() + shown.size() > maximum_label_bytes) {
            break;
        }
        result += shown;
        text.remove_prefix(character.size());
    }
    return result;
}

}  // namespace cgw::image_writer
