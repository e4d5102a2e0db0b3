// The text of an EDS or DCF as it grows: CRLF line ends, a blank line between sections.
#pragma once

#include <string>
#include <string_view>

namespace cgw::eds {

class Printer {
  public:
    void section(std::string_view name);
    void entry(std::string_view key, std::string_view value);
    // One ASCII line without ';' (importers cut values there), cut where the line would exceed 255
    // characters.
    void text_entry(std::string_view key, std::string_view text);
    // The value of an object: not cut, and byte by byte as it is; but one line, and no blanks around it.
    void value_entry(std::string_view key, std::string_view text);

    void number_entry(std::string_view key, std::size_t number);  // decimal
    void flag_entry(std::string_view key, bool value) { entry(key, value ? "1" : "0"); }

    std::string take() { return std::move(text_); }

  private:
    std::string text_;
};

}  // namespace cgw::eds
