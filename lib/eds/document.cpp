#include "eds/document.hpp"

#include <algorithm>
#include <utility>

#include "base/ascii.hpp"

namespace cgw::eds {
namespace {

constexpr std::string_view line_end = "\r\n";

void print_line(std::string& text, const Line& line) {
    if (line.kind == Line::Kind::entry) {
        text += line.key;
        text += '=';
    } else if (line.kind == Line::Kind::comment) {
        text += ';';
    }
    text += line.value;
    text += line_end;
}

}  // namespace

Section& Section::entry(std::string key, std::string value) {
    lines.push_back({Line::Kind::entry, std::move(key), std::move(value)});
    return *this;
}

Section& Section::comment(std::string text) {
    lines.push_back({Line::Kind::comment, "", std::move(text)});
    return *this;
}

const std::string* Section::find(std::string_view key) const {
    const auto found = std::find_if(lines.begin(), lines.end(), [key](const Line& line) {
        return line.kind == Line::Kind::entry && base::equal_ignoring_case(line.key, key);
    });
    return found != lines.end() ? &found->value : nullptr;
}

Section& Document::section(std::string name) {
    return sections.emplace_back(Section{std::move(name), {}});
}

const Section* Document::find(std::string_view name) const {
    const auto found = std::find_if(sections.begin(), sections.end(), [name](const Section& section) {
        return base::equal_ignoring_case(section.name, name);
    });
    return found != sections.end() ? &*found : nullptr;
}

std::string print(const Document& document) {
    std::string text;
    for (const Line& line : document.preamble) {
        print_line(text, line);
    }
    for (const Section& section : document.sections) {
        if (!text.empty()) {
            text += line_end;
        }
        text += '[';
        text += section.name;
        text += ']';
        text += line_end;
        for (const Line& line : section.lines) {
            print_line(text, line);
        }
    }
    return text;
}

}  // namespace cgw::eds
