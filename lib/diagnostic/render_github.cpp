// Workflow commands of GitHub Actions: each becomes an annotation at the line of the file.
#include <fmt/format.h>

#include <algorithm>

#include "base/utf8.hpp"
#include "diagnostic/renderers.hpp"
#include "diagnostic/source_lines.hpp"

namespace cgw::diagnostic {
namespace {

// Line ends end a command, a percent sign begins an escape; between the properties colon and comma separate.
std::string escaped(std::string_view text, bool is_property) {
    std::string result;
    std::string line;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        line = base::printable(text.substr(at, end - at));
        for (const char c : line) {
            const bool escape = c == '%' || (is_property && (c == ':' || c == ','));
            result += escape ? fmt::format("%{:02X}", c) : std::string(1, c);
        }
        result += end < text.size() ? "%0A" : "";
        at = end + 1;
    }
    return result;
}

std::string_view command_of(Level level) {
    return level == Level::note ? "notice" : to_text(level);
}

std::string properties(const Diagnostic& finding, Utf16Columns& columns) {
    std::string text;
    if (finding.where.path != "-") {
        text += fmt::format("file={},", escaped(finding.where.path, true));
    }
    if (finding.where.range.start.line != 0) {
        const Range range = columns.convert(finding.where);
        text += fmt::format("line={},", range.start.line);
        // Columns are only understood within one line.
        text += range.start.line == range.end.line
                    ? fmt::format("col={},endLine={},endColumn={},", range.start.column, range.end.line,
                                  range.end.column)
                    : fmt::format("endLine={},", range.end.line);
    }
    return text + fmt::format("title={}",
                              escaped(fmt::format("{} {}", finding.rule->code, finding.rule->name), true));
}

}  // namespace

std::string render_github(const RenderInput& input) {
    SourceLines lines(input.sources);
    Utf16Columns columns(lines);
    std::string text;
    for (const FileReport& file : input.files) {
        for (const Diagnostic& finding : file.findings) {
            std::string message = finding.message;
            for (const Related& related : finding.related) {
                message += fmt::format("\nsee {}: {}", to_text(related.where), related.message);
            }
            message += finding.help.empty() ? "" : "\nhelp: " + finding.help;
            text += fmt::format("::{} {}::{}\n", command_of(finding.level()), properties(finding, columns),
                                escaped(message, false));
        }
    }
    return text;
}

}  // namespace cgw::diagnostic
