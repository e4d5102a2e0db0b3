#include "catalogue/templates.hpp"

#include <charconv>
#include <optional>

#include <fmt/format.h>

namespace cgw::catalogue {

namespace {

// "5" with offset 1 is "6", "1804h" is "1805h"; nullopt for what is no number.
std::optional<std::string> counted(std::string_view text, std::uint32_t offset) {
    const bool hexadecimal = text.ends_with('h');
    if (hexadecimal) {
        text.remove_suffix(1);
    }
    std::uint32_t number = 0;
    const auto [end, error] =
        std::from_chars(text.data(), text.data() + text.size(), number, hexadecimal ? 16 : 10);
    if (error != std::errc{} || end != text.data() + text.size()) {
        return std::nullopt;
    }
    return hexadecimal ? fmt::format("{:X}h", number + offset) : fmt::format("{}", number + offset);
}

}  // namespace

std::string expand_text(std::string_view text, std::uint32_t offset) {
    std::string result;
    while (!text.empty()) {
        const std::size_t open = text.find('{');
        result += text.substr(0, open);
        if (open == std::string_view::npos) {
            break;
        }
        text.remove_prefix(open);
        const std::size_t close = text.find('}');
        const std::optional<std::string> number =
            close != std::string_view::npos ? counted(text.substr(1, close - 1), offset) : std::nullopt;
        result += number.value_or("{");
        text.remove_prefix(number ? close + 1 : 1);
    }
    return result;
}

}  // namespace cgw::catalogue
