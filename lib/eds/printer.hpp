// The text of an EDS or DCF as it grows: CRLF line ends, a blank line between sections.
#pragma once

#include <string>
#include <string_view>

namespace cgw::eds {

// A text as an entry can carry it: one ASCII line without ';' (importers cut values there) and without blanks
// around it, cut where the line would exceed 255 characters.
std::string entry_text(std::string_view key, std::string_view text);

// The value of an object: not cut, and byte by byte as it is; but one line, and no blanks around it.
std::string entry_value(std::string_view text);

class Printer {
  public:
    void section(std::string_view name);
    void entry(std::string_view key, std::string_view value);
    void text_entry(std::string_view key, std::string_view text) { entry(key, entry_text(key, text)); }
    void value_entry(std::string_view key, std::string_view text) { entry(key, entry_value(text)); }

    void number_entry(std::string_view key, std::size_t number);  // decimal
    void flag_entry(std::string_view key, bool value) { entry(key, value ? "1" : "0"); }

    std::string take() { return std::move(text_); }

  private:
    std::string text_;
};

}  // namespace cgw::eds
