// C++ literals for the compiled-in tables.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "parameter/row.hpp"

namespace cgw::catalogue {

// Text without control characters as a string literal.
std::string string_literal(std::string_view text);

// `constexpr std::string_view NAME[] = {…};` and the like; nothing for an empty list.
std::string text_list_source(const std::string& name, std::span<const std::string_view> texts);
std::string bit_list_source(const std::string& name, std::span<const parameter::NamedBit> bits);

}  // namespace cgw::catalogue
