// XML as text: two blanks for each level, LF line ends.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cgw::xdd {

// UTF-8 that XML can carry: a text that is not UTF-8 is taken as Latin-1; control characters other than tab
// and line ends become '?'.
std::string xml_text(std::string_view text);

struct Attribute {
    std::string_view name;
    std::string value;
};
using Attributes = std::vector<Attribute>;

class XmlPrinter {
  public:
    void line(std::string_view text);  // as it is
    void open(std::string_view element, const Attributes& attributes = {});
    void close();
    void empty(std::string_view element, const Attributes& attributes = {});  // <element .../>
    void leaf(std::string_view element, std::string_view text, const Attributes& attributes = {});

    std::string take() { return std::move(text_); }

  private:
    void tag(std::string_view element, const Attributes& attributes);

    std::string text_;
    std::vector<std::string> open_;
};

}  // namespace cgw::xdd
