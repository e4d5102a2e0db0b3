#include "eds/printer.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/ascii.hpp"
#include "base/utf8.hpp"
#include "dictionary/ascii.hpp"

namespace cgw::eds {
namespace {

constexpr std::size_t longest_line = 255;

bool breaks_lines(char c) {
    return c == '\r' || c == '\n' || c == '\0';
}

}  // namespace

std::string entry_text(std::string_view key, std::string_view text) {
    std::string value = dictionary::to_ascii(base::to_utf8(text));
    std::replace(value.begin(), value.end(), ';', ',');
    return dictionary::shortened(base::trimmed(value, " "), longest_line - key.size() - 1);
}

std::string entry_value(std::string_view text) {
    std::string value(text);
    std::replace_if(value.begin(), value.end(), breaks_lines, ' ');
    return std::string(base::trimmed(value));
}

void Printer::section(std::string_view name) {
    text_ += text_.empty() ? "[" : "\r\n[";
    text_.append(name).append("]\r\n");
}

void Printer::entry(std::string_view key, std::string_view value) {
    text_.append(key).append("=").append(value).append("\r\n");
}

void Printer::number_entry(std::string_view key, std::size_t number) {
    entry(key, fmt::format("{}", number));
}

}  // namespace cgw::eds
