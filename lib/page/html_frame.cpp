// Drawings. Everything in them stands in a table or text as well.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text_cells.hpp"
#include "base/utf8.hpp"
#include "page/html_parts.hpp"

namespace cgw::page {
namespace {

using base::html_text;

constexpr unsigned bits_of_byte = 8;
constexpr unsigned bytes_of_row = 4;  // two rows stay legible on a phone
constexpr unsigned byte_width = 120;
constexpr unsigned row_height = 66;
constexpr unsigned head = 16;  // where the bytes' numbers stand
constexpr double letter_width = 7.4;

// So much of it as fits, with an ellipsis where something is left out.
std::string fitting(std::string_view text, double width) {
    const auto most = static_cast<std::size_t>(std::max(0.0, width / letter_width));
    if (base::width_of(text) <= most) {
        return std::string(text);
    }
    std::string cut;
    for (const char c : text) {
        const bool begins = (static_cast<unsigned char>(c) & 0xC0U) != 0x80;
        if (begins && base::width_of(cut) + 1 >= most) {
            break;
        }
        cut += c;
    }
    return most < 2 ? "" : cut + "\u2026";
}

// One rectangle per row of bytes that the part touches; the label stands in the widest.
std::string part_svg(const Frame::Part& part) {
    constexpr unsigned row_bits = bytes_of_row * bits_of_byte;
    constexpr unsigned bit_width = byte_width / bits_of_byte;
    std::string svg;
    const unsigned end = part.first_bit + part.width;
    for (unsigned row = part.first_bit / row_bits; row * row_bits < end; ++row) {
        const unsigned from = std::max(part.first_bit, row * row_bits) - row * row_bits;
        const unsigned to = std::min(end, (row + 1) * row_bits) - row * row_bits;
        const unsigned x = from * bit_width;
        const unsigned width = (to - from) * bit_width;
        const unsigned y = row * row_height + head;
        svg +=
            fmt::format(R"(<g><title>{}</title><rect class="{}" x="{}.5" y="{}.5" width="{}" height="36"/>)",
                        html_text(part.label), part.used ? "part" : "gap", x, y, width - 1);
        const std::string label = part.used ? fitting(part.label, width - 8) : "";
        if (!label.empty()) {
            svg += fmt::format(R"(<text x="{}" y="{}" text-anchor="middle">{}</text>)", x + width / 2, y + 23,
                               html_text(label));
        }
        svg += "</g>\n";
    }
    return svg;
}

}  // namespace

std::string frame_svg(const Frame& frame) {
    const unsigned rows = (frame.bytes + bytes_of_row - 1) / bytes_of_row;
    const unsigned width = std::min(frame.bytes, bytes_of_row) * byte_width + 1;  // with the last line
    std::string svg = fmt::format(
        "<svg class=\"frame\" viewBox=\"0 0 {} {}\" width=\"{}\" height=\"{}\" role=\"img\" "
        "aria-label=\"{}\">\n",
        width, rows * row_height, width, rows * row_height, html_text(frame.caption));
    for (unsigned byte = 0; byte < frame.bytes; ++byte) {
        svg += fmt::format("<text class=\"small\" x=\"{}\" y=\"{}\">byte {}</text>\n",
                           byte % bytes_of_row * byte_width + 2, byte / bytes_of_row * row_height + head - 4,
                           byte);
    }
    for (const Frame::Part& part : frame.parts) {
        svg += part_svg(part);
    }
    return svg + "</svg>\n";
}

std::string strip_svg(const Strip& strip) {
    constexpr double width = 960;
    constexpr double narrowest = 3;
    const double scale = width / (strip.last - strip.first + 1.0);
    std::string svg = fmt::format(
        "<svg class=\"strip\" viewBox=\"0 0 {0} 40\" width=\"{0}\" height=\"40\" role=\"img\" "
        "aria-label=\"{1}\">\n"
        "<rect class=\"track\" x=\"0.5\" y=\"4.5\" width=\"{2}\" height=\"31\"/>\n",
        width, html_text(strip.caption), width - 1);
    for (const Strip::Field& field : strip.fields) {
        const double x = (field.first - strip.first) * scale;
        const double field_width = std::max(narrowest, (field.last - field.first + 1) * scale);
        svg += fmt::format(
            "<g><title>{}</title><rect class=\"{}\" x=\"{:.1f}\" y=\"5\" width=\"{:.1f}\" "
            "height=\"30\"/></g>\n",
            html_text(field.label), class_of(field.tone), std::min(x, width - field_width), field_width);
    }
    return svg + "</svg>\n";
}

std::string bar_svg(const Bar& bar, Tone tone) {
    const double share = std::isfinite(bar.share) ? std::clamp(bar.share, 0.0, 1.0) : 1.0;
    return fmt::format(
        "<svg class=\"bar\" viewBox=\"0 0 100 10\" preserveAspectRatio=\"none\" role=\"img\" "
        "aria-label=\"{}\">"
        "<rect class=\"track\" x=\"0\" y=\"0\" width=\"100\" height=\"10\"/>"
        "<rect class=\"{}\" x=\"0\" y=\"0\" width=\"{:.1f}\" height=\"10\"/></svg>",
        html_text(bar.meaning), class_of(tone), share * 100);
}

std::string_view class_of(Tone tone) {
    constexpr std::string_view classes[] = {"plain", "good", "warning", "bad"};
    return classes[static_cast<std::size_t>(tone)];
}

}  // namespace cgw::page
