// The configuration image as a source file: C++, a C header, or an assembler file that includes the binary.
// The symbols are the same in all three, so that one program may use the header and another form beside it.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/ascii.hpp"
#include "base/utf8.hpp"
#include "emit/artefacts.hpp"
#include "image/layout.hpp"

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

std::string upper_case(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), base::upper);
    return text;
}

// What a source file says about its image, as comment lines that C99 and C++ both take.
std::string head_comment(const Plant& plant, const base::Bytes& image) {
    return fmt::format(
        "// Configuration image for the gateway runtime, written by cgw {}; do not edit.\n"
        "// title:            {}\n"
        "// configuration id: {}\n"
        "// format:           {}.{}, {} bytes\n",
        plant.tool_version_text, comment_text(plant.settings.title), plant.configuration_id_text,
        image::format_major, image::format_minor, image.size());
}

std::string cpp_source(const Plant& plant, const Options& options, const base::Bytes& image) {
    return fmt::format(
        "{head}"
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
        fmt::arg("head", head_comment(plant, image)), fmt::arg("size", image.size()),
        fmt::arg("symbol", options.symbol), fmt::arg("alignment", options.alignment),
        fmt::arg("section", options.section), fmt::arg("body", array_body(image)));
}

std::string c_header(const Plant& plant, const Options& options, const base::Bytes& image) {
    return fmt::format(
        "{head}"
        "//\n"
        "// Define {macro}_DEFINE in exactly one source file before including this header: the image\n"
        "// is placed there. All others see its declaration.\n"
        "#ifndef {macro}_H\n"
        "#define {macro}_H\n"
        "\n"
        "#define {macro}_SIZE {size}\n"
        "#define {macro}_ID \"{id}\"\n"
        "\n"
        "#ifdef __cplusplus\n"
        "extern \"C\" {{\n"
        "#endif\n"
        "\n"
        "extern const unsigned char {symbol}[{size}];\n"
        "extern const unsigned int {symbol}_size;\n"
        "\n"
        "#ifdef {macro}_DEFINE\n"
        "__attribute__((aligned({alignment}), section(\"{section}\"), used))\n"
        "const unsigned char {symbol}[{size}] = {{\n"
        "{body}"
        "}};\n"
        "\n"
        "const unsigned int {symbol}_size = {size};\n"
        "#endif\n"
        "\n"
        "#ifdef __cplusplus\n"
        "}}\n"
        "#endif\n"
        "\n"
        "#endif\n",
        fmt::arg("head", head_comment(plant, image)), fmt::arg("macro", upper_case(options.symbol)),
        fmt::arg("id", plant.configuration_id_text), fmt::arg("size", image.size()),
        fmt::arg("symbol", options.symbol), fmt::arg("alignment", options.alignment),
        fmt::arg("section", options.section), fmt::arg("body", array_body(image)));
}

// Says nothing about the plant: it fits every image of that name, and need not be made again with it.
std::string assembler_source(const Plant& plant, const Options& options) {
    return fmt::format(
        "/* {symbol} for the GNU assembler, any target with ELF; written by cgw {version}, do not edit.\n"
        "   The bytes come from the file below, which cgw emit image writes; -I says where to look. */\n"
        "    .section \"{section}\", \"a\", %progbits\n"
        "    .balign {alignment}\n"
        "    .global {symbol}\n"
        "    .type {symbol}, %object\n"
        "{symbol}:\n"
        "    .incbin \"{file}\"\n"
        ".L{symbol}_end:\n"
        "    .size {symbol}, .L{symbol}_end - {symbol}\n"
        "\n"
        "    .section \".rodata.{symbol}_size\", \"a\", %progbits\n"
        "    .balign 4\n"
        "    .global {symbol}_size\n"
        "    .type {symbol}_size, %object\n"
        "{symbol}_size:\n"
        "    .long .L{symbol}_end - {symbol}\n"
        "    .size {symbol}_size, 4\n"
        "\n"
        "/* Linux wants to be told that the stack holds no code; firmware linkers warn when only one object\n"
        "   says so. True where the compiler takes this as a .S file: it makes __linux__ 1 there. */\n"
        "    .ifc __linux__, 1\n"
        "    .section .note.GNU-stack, \"\", %progbits\n"
        "    .endif\n",
        fmt::arg("version", plant.tool_version_text), fmt::arg("symbol", options.symbol),
        fmt::arg("section", options.section), fmt::arg("alignment", options.alignment),
        fmt::arg("file", options.image_file));
}

}  // namespace

base::Bytes emit_image_source(const Plant& plant, const Options& options) {
    if (options.format == "asm") {
        return base::to_bytes(assembler_source(plant, options));
    }
    Options binary = options;
    binary.format.clear();
    const base::Bytes image = emit_image(plant, binary);
    return base::to_bytes(options.format == "h" ? c_header(plant, options, image)
                                                : cpp_source(plant, options, image));
}

}  // namespace cgw::emit
