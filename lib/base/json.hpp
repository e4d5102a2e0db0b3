// Writes JSON text. Key order is the order of the calls; strings are escaped, bytes that are not UTF-8
// become U+FFFD, so that the output is always valid.
#pragma once

#include <cstddef>
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
    JsonWriter& json(std::string_view value);  // JSON text of a value, taken as it is

    // The finished document; call once, after the outermost end.
    std::string take();

  private:
    void separate();

    std::string text_;
    std::vector<bool> has_items_;
    bool after_key_ = false;
};

std::string json_quote(std::string_view value);

// The same document for people: what does not fit on a line of `width` columns is broken and indented by two
// blanks, with a line end at the end. `document` is valid JSON without blanks, as the writer makes it.
std::string pretty_json(std::string_view document, std::size_t width = 110);

}  // namespace cgw::base
