// What an explanation consists of, and its two renderers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cgw::explain {

enum class Style {
    facts,     // several lines are several facts, each a clause; a list where there are more than one
    lines,     // one below the other
    verbatim,  // lines of a parameter file: not even wrapped
};

// "cause" and its lines.
struct Field {
    std::string label;
    std::vector<std::string> lines;
    Style style = Style::facts;
};

// One thing that a question is about: a parameter of one device, an error, an object, a rule, a value.
struct Entry {
    std::string kind;   // of the JSON: "parameter", "error", "object", "check", "abort code", "value"
    std::string title;  // "gateway 3074 ErrCanOpen"
    std::vector<Field> fields;

    // Adds a field unless it would be empty.
    void add(std::string_view label, std::string_view line);
    void add(std::string_view label, std::vector<std::string> lines, Style style = Style::facts);
};

struct Answer {
    std::string question;
    std::vector<Entry> entries;
    std::string complaint;  // instead of entries: why there are none
    std::string help;       // what could be meant

    bool understood() const { return !entries.empty(); }
};

// For people: at most 80 columns, entries separated by blank lines.
std::string render_text(const std::vector<Answer>& answers);

// {"format_version":1,"answers":[{"question":"…","entries":[{"kind":"…","title":"…","fields":{"cause":["…"]}}]}]}
std::string render_json(const std::vector<Answer>& answers);

}  // namespace cgw::explain
