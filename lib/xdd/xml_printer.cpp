#include "xdd/xml_printer.hpp"

#include <fmt/format.h>

#include "base/utf8.hpp"

namespace cgw::xdd {
namespace {

// U+FFFE and U+FFFF.
bool is_no_character(std::string_view sequence) {
    return sequence == "\xEF\xBF\xBE" || sequence == "\xEF\xBF\xBF";
}

void append_escaped(std::string& to, std::string_view text) {
    for (const char c : text) {
        switch (c) {
            case '&':
                to += "&amp;";
                break;
            case '<':
                to += "&lt;";
                break;
            case '>':
                to += "&gt;";
                break;
            case '"':
                to += "&quot;";
                break;
            case '\t':
            case '\n':
            case '\r':
                to += fmt::format("&#{};", static_cast<unsigned>(c));
                break;
            default:
                to += c;
        }
    }
}

}  // namespace

std::string xml_text(std::string_view text) {
    const std::string utf8 = base::to_utf8(text);
    std::string result;
    for (std::string_view rest = utf8; !rest.empty();) {
        const std::string_view sequence = rest.substr(0, base::utf8_sequence_length(rest));
        const char first = sequence.front();
        const bool is_control =
            static_cast<unsigned char>(first) < 0x20 && first != '\t' && first != '\n' && first != '\r';
        if (is_control || is_no_character(sequence)) {
            result += '?';
        } else {
            result += sequence;
        }
        rest.remove_prefix(sequence.size());
    }
    return result;
}

void XmlPrinter::line(std::string_view text) {
    text_.append(2 * open_.size(), ' ').append(text).append("\n");
}

void XmlPrinter::tag(std::string_view element, const Attributes& attributes) {
    text_.append(2 * open_.size(), ' ').append("<").append(element);
    for (const Attribute& attribute : attributes) {
        text_.append(" ").append(attribute.name).append("=\"");
        append_escaped(text_, xml_text(attribute.value));
        text_ += '"';
    }
}

void XmlPrinter::open(std::string_view element, const Attributes& attributes) {
    tag(element, attributes);
    text_ += ">\n";
    open_.emplace_back(element);
}

void XmlPrinter::close() {
    const std::string element = std::move(open_.back());
    open_.pop_back();
    line(fmt::format("</{}>", element));
}

void XmlPrinter::empty(std::string_view element, const Attributes& attributes) {
    tag(element, attributes);
    text_ += "/>\n";
}

void XmlPrinter::leaf(std::string_view element, std::string_view text, const Attributes& attributes) {
    tag(element, attributes);
    text_ += '>';
    append_escaped(text_, xml_text(text));
    text_.append("</").append(element).append(">\n");
}

}  // namespace cgw::xdd
