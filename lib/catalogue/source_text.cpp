#include "catalogue/source_text.hpp"

#include <fmt/format.h>

namespace cgw::catalogue {

std::string string_literal(std::string_view text) {
    std::string literal = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            literal += '\\';
        }
        literal += c;
    }
    return literal + "\"";
}

std::string text_list_source(const std::string& name, std::span<const std::string_view> texts) {
    if (texts.empty()) {
        return {};
    }
    std::string source = fmt::format("constexpr std::string_view {}[] = {{", name);
    for (const std::string_view text : texts) {
        source += string_literal(text) + ", ";
    }
    return source + "};\n";
}

std::string bit_list_source(const std::string& name, std::span<const parameter::NamedBit> bits) {
    if (bits.empty()) {
        return {};
    }
    std::string source = fmt::format("constexpr NamedBit {}[] = {{\n", name);
    for (const parameter::NamedBit& bit : bits) {
        source +=
            fmt::format("    {{{}, {}, {}}},\n", bit.bit, string_literal(bit.name), string_literal(bit.text));
    }
    return source + "};\n";
}

}  // namespace cgw::catalogue
