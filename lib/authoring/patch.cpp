#include "authoring/patch.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace cgw::authoring {
namespace {

constexpr std::size_t context_lines = 3;

// Lines with their ends; the last one may have none.
std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        const std::size_t length = end == std::string_view::npos ? text.size() : end + 1;
        lines.push_back(text.substr(0, length));
        text.remove_prefix(length);
    }
    return lines;
}

bool fits(const Edit& edit, const std::vector<std::string_view>& lines) {
    const auto& [start, end] = edit.where;
    return start.line >= 1 && start.line == end.line && start.line <= lines.size() && start.column >= 1 &&
           end.column >= start.column && end.column - 1 <= lines[start.line - 1].size();
}

std::vector<std::string> edited_lines(const std::vector<std::string_view>& lines, std::vector<Edit> edits) {
    std::vector<std::string> changed(lines.begin(), lines.end());
    // From behind, so that columns before an edit stay right.
    std::sort(edits.begin(), edits.end(),
              [](const Edit& a, const Edit& b) { return b.where.start < a.where.start; });
    for (const Edit& edit : edits) {
        if (fits(edit, lines)) {
            const auto& [start, end] = edit.where;
            changed[start.line - 1].replace(start.column - 1, end.column - start.column, edit.text);
        }
    }
    return changed;
}

std::string marked(char mark, std::string_view line) {
    return fmt::format("{}{}{}", mark, line, line.ends_with('\n') ? "" : "\n\\ No newline at end of file\n");
}

}  // namespace

std::string edited(std::string_view text, std::vector<Edit> edits) {
    return fmt::format("{}", fmt::join(edited_lines(lines_of(text), std::move(edits)), ""));
}

std::string unified_diff(std::string_view path, std::string_view text, const std::vector<Edit>& edits) {
    const std::vector<std::string_view> before = lines_of(text);
    const std::vector<std::string> after = edited_lines(before, edits);
    std::vector<std::size_t> changes;
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (before[i] != after[i]) {
            changes.push_back(i);
        }
    }
    // A name with a blank ends at a tab.
    const std::string_view end = path.find(' ') == std::string_view::npos ? "" : "\t";
    std::string diff = changes.empty() ? "" : fmt::format("--- {}{}\n+++ {}{}\n", path, end, path, end);
    for (std::size_t i = 0; i < changes.size();) {
        const std::size_t first = changes[i] - std::min(changes[i], context_lines);
        std::size_t last = i;
        while (last + 1 < changes.size() && changes[last + 1] - changes[last] <= 2 * context_lines) {
            ++last;
        }
        const std::size_t past = std::min(before.size(), changes[last] + context_lines + 1);
        diff += fmt::format("@@ -{0},{1} +{0},{1} @@\n", first + 1, past - first);
        for (std::size_t line = first; line < past; ++line) {
            if (before[line] == after[line]) {
                diff += marked(' ', before[line]);
            } else {
                diff += marked('-', before[line]) + marked('+', after[line]);
            }
        }
        i = last + 1;
    }
    return diff;
}

}  // namespace cgw::authoring
