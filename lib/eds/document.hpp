// The document layer of EDS and DCF: sections, keys and comments in their order, printed back exactly.
// It knows the syntax of CiA 306, not the meaning of a key.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cgw::eds {

struct Line {
    enum class Kind : std::uint8_t { entry, comment, blank };
    Kind kind = Kind::blank;
    std::string key;    // entry
    std::string value;  // entry: right of '='; comment: after ';'
};

struct Section {
    std::string name;
    std::vector<Line> lines;  // what follows the [name] line

    Section& entry(std::string key, std::string value);
    Section& comment(std::string text);
    const std::string* find(std::string_view key) const;  // case-insensitive; the first of that key
};

struct Document {
    std::vector<Line> preamble;  // before the first section
    std::vector<Section> sections;

    Section& section(std::string name);                // appends; valid until the next section is appended
    const Section* find(std::string_view name) const;  // case-insensitive; the first of that name
};

// CRLF line ends, a blank line between sections.
std::string print(const Document& document);

}  // namespace cgw::eds
