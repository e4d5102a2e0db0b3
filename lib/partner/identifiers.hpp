// Inside the partner room: names of signals as names of languages that are stricter than C.
#pragma once

#include <set>
#include <span>
#include <string>
#include <string_view>

namespace cgw::partner {

// The names of one frame, upper and lower case being the same: letters, digits and single underscores, a
// letter first, no underscore at either end (IEC 61131-3), 1..32 characters, none of `reserved`, none twice.
class Identifiers {
  public:
    // `reserved` in upper case; it outlives this.
    explicit Identifiers(std::span<const std::string_view> reserved) : reserved_(reserved) {}

    // What the signal is called: `wanted` where that is allowed. Of any text; bounded work.
    std::string take(std::string_view wanted);

  private:
    bool is_free(const std::string& name) const;

    std::span<const std::string_view> reserved_;
    std::set<std::string> taken_;
};

// Words of IEC 61131-3, of its standard functions and of what is often added to them.
std::span<const std::string_view> structured_text_words();

}  // namespace cgw::partner
