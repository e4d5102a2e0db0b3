#include "explain/answer.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/json.hpp"
#include "explain/text.hpp"

namespace cgw::explain {

namespace {

constexpr std::size_t indentation = 2;
constexpr std::size_t gap = 2;

void append_field(std::string& text, const Field& field, std::size_t label_width) {
    const std::size_t column = indentation + label_width + gap;
    std::string head = fmt::format("{:{}}{:{}}", "", indentation, field.label, label_width + gap);
    for (const std::string& line : field.lines) {
        const std::string_view bullet = field.lines.size() > 1 && field.style == Style::facts ? "- " : "";
        const std::vector<std::string> parts = field.style == Style::verbatim
                                                   ? std::vector{line}
                                                   : wrap(line, page_width - column - bullet.size());
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const std::string_view mark = i == 0 ? bullet : bullet.empty() ? "" : "  ";
            text += fmt::format("{}{}{}\n", head, mark, parts[i]);
            head = std::string(column, ' ');
        }
    }
}

void append_entry(std::string& text, const Entry& entry) {
    std::size_t width = 0;
    for (const Field& field : entry.fields) {
        width = std::max(width, field.label.size());
    }
    for (const std::string& line : wrap(entry.title, page_width)) {
        text += line + "\n";
    }
    for (const Field& field : entry.fields) {
        append_field(text, field, width);
    }
}

}  // namespace

void Entry::add(std::string_view label, std::string_view line) {
    if (!line.empty()) {
        fields.push_back({std::string(label), {std::string(line)}});
    }
}

void Entry::add(std::string_view label, std::vector<std::string> lines, Style style) {
    if (!lines.empty()) {
        fields.push_back({std::string(label), std::move(lines), style});
    }
}

std::string render_text(const std::vector<Answer>& answers) {
    std::string text;
    for (const Answer& answer : answers) {
        for (const Entry& entry : answer.entries) {
            text += text.empty() ? "" : "\n";
            append_entry(text, entry);
        }
    }
    return text;
}

std::string render_json(const std::vector<Answer>& answers) {
    base::JsonWriter json;
    json.begin_object().key("format_version").integer(1).key("answers").begin_array();
    for (const Answer& answer : answers) {
        json.begin_object().key("question").string(answer.question).key("entries").begin_array();
        for (const Entry& entry : answer.entries) {
            json.begin_object().key("kind").string(entry.kind).key("title").string(entry.title);
            json.key("fields").begin_object();
            for (const Field& field : entry.fields) {
                json.key(field.label).begin_array();
                for (const std::string& line : field.lines) {
                    json.string(line);
                }
                json.end_array();
            }
            json.end_object().end_object();
        }
        json.end_array().end_object();
    }
    json.end_array().end_object();
    return json.take();
}

}  // namespace cgw::explain
