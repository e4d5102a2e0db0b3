// Texts of arrays and ranges: one text that counts along.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace cgw::catalogue {

// "{5}" becomes 5 + offset and "{1804h}" 1804h + offset, so that the text of an array's element names the
// element. Any other brace stays as it is.
std::string expand_text(std::string_view text, std::uint32_t offset);

}  // namespace cgw::catalogue
