#include <fmt/format.h>

#include <array>

#include "base/canopen_text.hpp"
#include "base/json.hpp"
#include "base/text_cells.hpp"
#include "base/utf8.hpp"
#include "dictionary/difference.hpp"

namespace cgw::dictionary {
namespace {

constexpr int format_version = 1;
constexpr std::size_t line_width = 80;
constexpr std::size_t aspect_width = 28;

// A text that says nothing is shown as such.
std::string shown(std::string_view text) {
    return text.empty() ? "nothing" : base::printable(text);
}

std::string count_text(std::size_t count, std::string_view what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string verdict(const Differences& differences) {
    return differences.same() ? "Both describe the same device."
                              : count_text(differences.all.size(), "difference") + ".";
}

std::string not_compared_text(const Differences& differences) {
    return fmt::format("Not compared, for one side does not say it: {}.",
                       fmt::join(differences.not_compared, ", "));
}

std::string render_text(const Differences& differences, const SideName& a, const SideName& b) {
    std::string text = fmt::format("A: {} ({})\nB: {} ({})\n", base::printable(a.path), a.kind,
                                   base::printable(b.path), b.kind);
    std::string subject_before;
    bool device = false;
    for (const Difference& difference : differences.all) {
        const std::string subject = base::printable(subject_text(difference));
        if (subject.empty() && !device) {
            text += "\nDevice\n";
            device = true;
        } else if (subject != subject_before) {
            text += fmt::format("\n{}\n", subject);
        }
        subject_before = subject;
        std::string line = fmt::format("  {:<{}} {} -> {}\n", difference.aspect_text, aspect_width,
                                       shown(difference.a), shown(difference.b));
        if (base::width_of(line) > line_width + 1) {
            line = fmt::format("  {}\n      {}\n   -> {}\n", difference.aspect_text, shown(difference.a),
                               shown(difference.b));
        }
        text += line;
    }
    text += fmt::format("\n{}\n", verdict(differences));
    return differences.not_compared.empty() ? text
                                            : text + fmt::format("{}\n", not_compared_text(differences));
}

std::string render_markdown(const Differences& differences, const SideName& a, const SideName& b) {
    std::string text =
        fmt::format("# {} and {}\n\nA is {} ({}), B is {} ({}).\n\n{}\n", base::markdown_cell(a.path),
                    base::markdown_cell(b.path), base::markdown_cell(a.path), a.kind,
                    base::markdown_cell(b.path), b.kind, verdict(differences));
    if (!differences.same()) {
        text += "\n| Object | What | A | B |\n|---|---|---|---|\n";
    }
    for (const Difference& difference : differences.all) {
        const std::string subject = subject_text(difference);
        text +=
            fmt::format("| {} | {} | {} | {} |\n", base::markdown_cell(subject.empty() ? "device" : subject),
                        difference.aspect_text, base::markdown_cell(shown(difference.a)),
                        base::markdown_cell(shown(difference.b)));
    }
    return differences.not_compared.empty() ? text
                                            : text + fmt::format("\n{}\n", not_compared_text(differences));
}

void side_json(base::JsonWriter& json, std::string_view key, const SideName& side) {
    json.key(key).begin_object();
    json.key("path").string(side.path);
    json.key("kind").string(side.kind);
    json.end_object();
}

std::string render_json(const Differences& differences, const SideName& a, const SideName& b) {
    base::JsonWriter json;
    json.begin_object();
    json.key("format_version").integer(format_version);
    json.key("same").boolean(differences.same());
    side_json(json, "a", a);
    side_json(json, "b", b);
    json.key("differences").begin_array();
    for (const Difference& difference : differences.all) {
        write_json(json, difference, "a", "b");
    }
    json.end_array();
    json.key("not_compared").begin_array();
    for (const std::string_view aspect : differences.not_compared) {
        json.string(aspect);
    }
    json.end_array();
    json.end_object();
    return json.take();
}

constexpr std::array formats{
    DifferenceFormat{"text", "for people", render_text},
    DifferenceFormat{"json", "one JSON document", render_json},
    DifferenceFormat{"md", "a Markdown table", render_markdown},
};

}  // namespace

std::string subject_text(const Difference& difference) {
    if (!difference.index) {
        return difference.name;
    }
    const std::string object = difference.sub_index
                                   ? base::object_text(*difference.index, *difference.sub_index)
                                   : base::object_text(*difference.index);
    return difference.name.empty() ? object : fmt::format("{} {}", object, difference.name);
}

void write_json(base::JsonWriter& json, const Difference& difference, std::string_view key_a,
                std::string_view key_b) {
    json.begin_object();
    json.key("aspect").string(difference.aspect);
    json.key("index");
    difference.index ? json.integer(*difference.index) : json.null();
    json.key("sub_index");
    difference.sub_index ? json.integer(*difference.sub_index) : json.null();
    json.key("name").string(difference.name);
    json.key(key_a).string(difference.a);
    json.key(key_b).string(difference.b);
    json.end_object();
}

std::span<const DifferenceFormat> difference_formats() {
    return formats;
}

}  // namespace cgw::dictionary
