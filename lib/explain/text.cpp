#include "explain/text.hpp"
#include "base/ascii.hpp"

#include <algorithm>

namespace cgw::explain {

namespace {

// "1804h" or "12"
bool is_number(std::string_view word) {
    if (word.ends_with('h')) {
        word.remove_suffix(1);
        return base::consists_of(word, "0123456789ABCDEF");
    }
    return base::consists_of(word, base::digits);
}

// Takes the next word, or the next single character that belongs to none, off the front.
std::string_view next_token(std::string_view& text) {
    std::size_t length = 0;
    while (length < text.size() && base::is_letter_or_digit(text[length])) {
        ++length;
    }
    const std::string_view token = text.substr(0, std::max<std::size_t>(length, 1));
    text.remove_prefix(token.size());
    return token;
}

// "TPDO5" and "TPDO16" give "TPDO5..16"
std::optional<std::string> merged_word(std::string_view first, std::string_view last) {
    std::size_t prefix = 0;
    while (prefix < first.size() && prefix < last.size() && base::is_letter(first[prefix]) &&
           first[prefix] == last[prefix]) {
        ++prefix;
    }
    const std::string_view last_number = last.substr(prefix);
    if (!is_number(first.substr(prefix)) || !is_number(last_number)) {
        return std::nullopt;
    }
    return std::string(first) + ".." + std::string(last_number);
}

}  // namespace

std::optional<std::string> merged_text(std::string_view first, std::string_view last) {
    std::string merged;
    while (!first.empty() && !last.empty()) {
        const std::string_view a = next_token(first);
        const std::string_view b = next_token(last);
        const std::optional<std::string> word = a == b ? std::string(a) : merged_word(a, b);
        if (!word) {
            return std::nullopt;
        }
        merged += *word;
    }
    return first.empty() && last.empty() ? std::optional(merged) : std::nullopt;
}

std::string replaced(std::string_view text, std::string_view from, std::string_view to) {
    std::string result;
    for (std::size_t at = text.find(from); at != std::string_view::npos; at = text.find(from)) {
        result += text.substr(0, at);
        result += to;
        text.remove_prefix(at + from.size());
    }
    return result += text;
}

}  // namespace cgw::explain
