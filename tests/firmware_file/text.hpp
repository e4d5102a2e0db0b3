// Firmware files as texts in tests, and what reading them says.
#pragma once

#include <fmt/format.h>

#include <string>

#include "base/bytes.hpp"
#include "firmware_file/finding.hpp"

namespace cgw::test {

// "line:column-end name: message", "" when the outcome is fine.
template <typename T>
std::string refusal(const firmware_file::Outcome<T>& outcome) {
    if (outcome) {
        return "";
    }
    const diagnostic::Range& range = outcome.error().where.range;
    return fmt::format("{}:{}-{} {}: {}", range.start.line, range.start.column, range.end.column,
                       outcome.error().rule->name, outcome.error().message);
}

inline std::string replaced(std::string text, const std::string& old, const std::string& with) {
    return text.replace(text.find(old), old.size(), with);
}

// With one bit the other way round.
template <typename Bytes>
Bytes flipped(Bytes bytes, std::size_t bit) {
    using Byte = typename Bytes::value_type;
    bytes[bit / 8] = static_cast<Byte>(static_cast<unsigned char>(bytes[bit / 8]) ^ (1U << (bit % 8)));
    return bytes;
}

}  // namespace cgw::test
