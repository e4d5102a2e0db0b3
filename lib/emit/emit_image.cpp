// The configuration image, as it is and as a source file to compile into a gateway.
#include <fmt/format.h>

#include <iterator>

#include "base/utf8.hpp"
#include "emit/artefacts.hpp"
#include "image/layout.hpp"
#include "image_writer/image_writer.hpp"

namespace cgw::emit {
namespace {

constexpr std::size_t bytes_per_line = 16;

// Bidirectional controls (U+200E/F, U+202A..E, U+2066..9, U+061C) would make a comment read otherwise than it
// is, and compilers warn about them.
bool reorders_text(std::string_view character) {
    if (character == "\xD8\x9C") {
        return true;
    }
    if (character.size() != 3 || (!character.starts_with("\xE2\x80") && !character.starts_with("\xE2\x81"))) {
        return false;
    }
    const auto last = static_cast<unsigned char>(character[2]);
    return character[1] == '\x80' ? last == 0x8E || last == 0x8F || (last >= 0xAA && last <= 0xAE)
                                  : last >= 0xA6 && last <= 0xA9;
}

// In quotes, on one line, whatever the title holds; the closing quote also keeps a final backslash from
// continuing the comment.
std::string comment_text(std::string_view text) {
    std::string result = "\"";
    while (!text.empty()) {
        const std::size_t size = base::utf8_sequence_length(text);
        const std::string_view character = text.substr(0, size == 0 ? 1 : size);
        const auto first = static_cast<unsigned char>(character[0]);
        const bool control = size == 1 && (first < 0x20 || first == 0x7F);
        result += size == 0 || control || reorders_text(character) ? "?" : character;
        text.remove_prefix(character.size());
    }
    return result + '"';
}

std::string array_body(const base::Bytes& bytes) {
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const char* before = i % bytes_per_line == 0 ? "    " : " ";
        const char* after = (i + 1) % bytes_per_line == 0 || i + 1 == bytes.size() ? ",\n" : ",";
        fmt::format_to(std::back_inserter(text), "{}0x{:02x}{}", before, bytes[i], after);
    }
    return text;
}

}  // namespace

base::Bytes emit_image(const Plant& plant, const Options& options) {
    return image_writer::write_image({.settings = plant.settings,
                                      .configuration = plant.configuration,
                                      .dictionary = plant.dictionary,
                                      .configuration_id = plant.configuration_id,
                                      .tool_version = plant.tool_version,
                                      .labels = options.labels});
}

base::Bytes emit_image_source(const Plant& plant, const Options& options) {
    const base::Bytes image = emit_image(plant, options);
    return base::to_bytes(fmt::format(
        "// Configuration image for the gateway runtime, written by cgw {version}; do not edit.\n"
        "// title:            {title}\n"
        "// configuration id: {id}\n"
        "// format:           {major}.{minor}, {size} bytes\n"
        "\n"
        "extern \"C\" {{\n"
        "extern const unsigned char {symbol}[{size}];\n"
        "extern const unsigned int {symbol}_size;\n"
        "}}\n"
        "\n"
        "alignas({alignment}) __attribute__((section(\"{section}\"), used))\n"
        "const unsigned char {symbol}[{size}] = {{\n"
        "{body}"
        "}};\n"
        "\n"
        "const unsigned int {symbol}_size = {size};\n",
        fmt::arg("version", plant.tool_version_text), fmt::arg("title", comment_text(plant.settings.title)),
        fmt::arg("id", plant.configuration_id_text), fmt::arg("major", image::format_major),
        fmt::arg("minor", image::format_minor), fmt::arg("size", image.size()),
        fmt::arg("symbol", options.symbol), fmt::arg("alignment", options.alignment),
        fmt::arg("section", options.section), fmt::arg("body", array_body(image))));
}

}  // namespace cgw::emit
