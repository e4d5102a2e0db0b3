// Writes JSON text. Key order is the order of the calls; strings are escaped, bytes that are not UTF-8
// become U+FFFD, so that the output is always valid.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cgw::base {

class JsonWriter {
  public:
    JsonWriter& begin_object();
    JsonWriter& end_object();
    JsonWriter& begin_array();
    JsonWriter& end_array();
    JsonWriter& key(std::string_view name);
    JsonWriter& string(std::string_view value);
    JsonWriter& integer(std::int64_t value);
    JsonWriter& real(double value);
    JsonWriter& boolean(bool value);
    JsonWriter& null();

    // The finished document; call once, after the outermost end.
    std::string take();

  private:
    void separate();

    std::string text_;
    std::vector<bool> has_items_;
    bool after_key_ = false;
};

std::string json_quote(std::string_view value);

}  // namespace cgw::base
