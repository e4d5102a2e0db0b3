// A fragment of a parameter file read on top of a whole one, as the examples of the rules are meant.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace cgw::test {

struct Section {
    std::string header;  // "[gateway.parameters]"; "" before the first one
    std::vector<std::string> lines;
};

inline std::vector<Section> sections_of(std::string_view text) {
    std::vector<Section> sections(1);
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string line(text.substr(at, end - at));
        if (line.starts_with('[')) {
            sections.push_back({line, {}});
        } else {
            sections.back().lines.push_back(line);
        }
        at = end + 1;
    }
    return sections;
}

inline std::string key_of(std::string_view line) {
    const std::string_view text = line.substr(0, line.find('='));
    const std::size_t last = text.find_last_not_of(' ');
    return line.find('=') == line.npos || last == text.npos ? "" : std::string(text.substr(0, last + 1));
}

inline void overlay_line(Section& section, const std::string& line) {
    const bool takes_away = line.starts_with("# ");
    const std::string key = key_of(takes_away ? line.substr(2) : line);
    for (std::size_t i = 0; i < section.lines.size(); ++i) {
        if (!key.empty() && key_of(section.lines[i]) == key) {
            section.lines[i] = line;
            return;
        }
    }
    section.lines.push_back(line);
}

// Lines of the fragment replace those with the same key below the same header, a commented one takes it
// away; other lines and tables are added.
inline std::string overlaid(std::string_view file, std::string_view fragment) {
    std::vector<Section> sections = sections_of(file);
    for (const Section& added : sections_of(fragment)) {
        Section* found = nullptr;
        for (Section& section : sections) {
            found = section.header == added.header && !added.header.starts_with("[[") ? &section : found;
        }
        if (found == nullptr) {
            sections.push_back(added);
            continue;
        }
        for (const std::string& line : added.lines) {
            overlay_line(*found, line);
        }
    }
    std::string text;
    for (const Section& section : sections) {
        text += section.header.empty() ? "" : section.header + "\n";
        for (const std::string& line : section.lines) {
            text += line + "\n";
        }
    }
    return text;
}

}  // namespace cgw::test
