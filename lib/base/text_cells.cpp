#include "base/text_cells.hpp"

#include <algorithm>

#include "base/numbers.hpp"

namespace cgw::base {
namespace {

// What may be markup in Markdown.
constexpr std::string_view special = "\\`*_[<#&|~";

// Spreadsheets run a cell that begins like this as a formula, wherever the text came from.
bool looks_like_formula(std::string_view text) {
    constexpr std::string_view starters = "=+-@\t\r";
    return !text.empty() && starters.find(text.front()) != std::string_view::npos && !parse_real(text);
}

}  // namespace

std::string one_line(std::string_view text) {
    constexpr unsigned char del = 0x7F;
    std::string line(text);
    std::replace_if(
        line.begin(), line.end(), [](unsigned char c) { return c < ' ' || c == del; }, ' ');
    return line;
}

std::string markdown_text(std::string_view cell) {
    std::string text;
    for (std::size_t at = 0; at < cell.size(); ++at) {
        const bool is_escape =
            cell[at] == '\\' && at + 1 < cell.size() && special.find(cell[at + 1]) != std::string_view::npos;
        at += is_escape ? 1 : 0;
        text += cell[at];
    }
    return text;
}

std::string markdown_cell(std::string_view text) {
    std::string cell;
    for (const char c : one_line(text)) {
        if (special.find(c) != std::string_view::npos) {
            cell += '\\';
        }
        cell += c;
    }
    return cell;
}

std::string html_text(std::string_view text) {
    std::string html;
    for (const char c : one_line(text)) {
        switch (c) {
            case '&':
                html += "&amp;";
                break;
            case '<':
                html += "&lt;";
                break;
            case '>':
                html += "&gt;";
                break;
            case '"':
                html += "&quot;";
                break;
            default:
                html += c;
        }
    }
    return html;
}

std::string csv_field(std::string_view text) {
    std::string field = looks_like_formula(text) ? "'" : "";
    field += text;
    if (field.find_first_of(",\"\r\n") == std::string::npos) {
        return field;
    }
    std::string quoted = "\"";
    for (const char c : field) {
        quoted += c;
        if (c == '"') {
            quoted += c;
        }
    }
    return quoted + '"';
}

}  // namespace cgw::base
