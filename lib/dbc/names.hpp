// Names that every DBC reader takes: letters, digits and underscores, no digit first, at most 32 characters,
// and none of the format's own words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cgw::dbc {

inline constexpr std::size_t longest_name = 32;

// "Oil pressure (1)" with the ending "_Error" becomes "Oil_pressure_1_Error". Of a name that is too long the
// ending stays whole. Never empty.
std::string identifier(std::string_view utf8, std::string_view ending = {});

// The names of one message: what is taken already gets "_2", "_3", … Upper and lower case count as the same.
class Names {
  public:
    std::string take(const std::string& identifier);

  private:
    std::vector<std::string> taken_;
};

}  // namespace cgw::dbc
