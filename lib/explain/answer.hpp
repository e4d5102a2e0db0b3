// What an explanation consists of, and its two renderers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cgw::explain {

// "cause" and its lines. Several lines are several facts, each a clause.
struct Field {
    std::string label;
    std::vector<std::string> lines;
    bool verbatim = false;  // lines of a parameter file: neither wrapped nor bulleted
};

// One thing that a question is about: a parameter of one device, an error, an object, a rule, a value.
struct Entry {
    std::string kind;   // of the JSON: "parameter", "error", "object", "check", "abort code", "value"
    std::string title;  // "gateway 3074 ErrCanOpen"
    std::vector<Field> fields;

    // Adds a field unless it would be empty.
    void add(std::string_view label, std::string_view line);
    void add(std::string_view label, std::vector<std::string> lines);
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
