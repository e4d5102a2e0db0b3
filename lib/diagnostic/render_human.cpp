#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>

#include "base/utf8.hpp"
#include "diagnostic/renderers.hpp"
#include "diagnostic/source_lines.hpp"

namespace cgw::diagnostic {
namespace {

struct Colors {
    std::string_view level;
    std::string_view bold;
    std::string_view end;
};

std::string_view color_of(Level level) {
    switch (level) {
        case Level::error:
            return "\x1b[1;31m";
        case Level::warning:
            return "\x1b[1;33m";
        case Level::note:
            return "\x1b[1;36m";
    }
    return "";
}

Colors colors_for(Level level, bool color) {
    return color ? Colors{color_of(level), "\x1b[1m", "\x1b[0m"} : Colors{};
}

std::string plural(std::size_t count, std::string_view noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

constexpr std::size_t line_width = 80;

// The words with line ends in between, as they fit behind a lead of that width; the lines that follow begin
// with `indent`. `last` is one word, blanks or not.
std::string wrapped(std::size_t lead_width, std::string_view text, std::string_view indent,
                    std::string_view last = {}) {
    std::string result;
    std::size_t column = lead_width;
    const auto add = [&](std::string_view word) {
        const std::size_t width = base::width_of(word);
        const bool fits = result.empty() || column + 1 + width <= line_width;
        result += result.empty() ? "" : fits ? " " : fmt::format("\n{}", indent);
        column = (fits ? column + (result.empty() ? 0 : 1) : base::width_of(indent)) + width;
        result += word;
    };
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(' '), text.size());
        add(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    if (!last.empty()) {
        add(last);
    }
    return result;
}

// A help of several lines is an example to copy; its lines stay as they are, but for the first.
void append_help(std::string& text, std::string_view help) {
    constexpr std::string_view indent = "        ";
    std::string_view lead = "  help: ";
    while (!help.empty()) {
        const std::size_t end = std::min(help.find('\n'), help.size());
        const std::string line = base::printable(help.substr(0, end));
        text +=
            fmt::format("{}{}\n", lead, lead == indent ? line : wrapped(base::width_of(lead), line, indent));
        help.remove_prefix(std::min(end + 1, help.size()));
        lead = indent;
    }
}

void append_finding(std::string& text, const Diagnostic& finding, SourceLines& lines, bool color) {
    const Colors c = colors_for(finding.level(), color);
    const std::string place = to_text(finding.where);
    const std::string_view level = to_text(finding.level());
    const std::size_t lead_width = base::width_of(place) + level.size() + 4;
    text += fmt::format("{}{}:{} {}{}:{} {}\n", c.bold, place, c.end, c.level, level, c.end,
                        wrapped(lead_width, base::printable(finding.message), "    ",
                                fmt::format("[{} {}]", finding.rule->code, finding.rule->name)));
    text += lines.excerpt(finding.where, '^', c.level, c.end);
    for (const Related& related : finding.related) {
        const std::string lead = fmt::format("  see {}: ", to_text(related.where));
        text += fmt::format("{}{}\n", lead,
                            wrapped(base::width_of(lead), base::printable(related.message), "      "));
        text += lines.excerpt(related.where, '-', c.bold, c.end);
    }
    append_help(text, finding.help);
    text += '\n';
}

// By level: error, warning, note.
using Counts = std::array<std::size_t, 3>;

Counts counts_of(const FileReport& file) {
    Counts counts{};
    for (const Diagnostic& finding : file.findings) {
        ++counts[static_cast<std::size_t>(finding.level())];
    }
    return counts;
}

std::string counts_text(const Counts& counts, std::string_view separator) {
    std::string text;
    for (const Level level : {Level::error, Level::warning, Level::note}) {
        if (const std::size_t count = counts[static_cast<std::size_t>(level)]; count > 0) {
            text += fmt::format("{}{}", separator, plural(count, to_text(level)));
            separator = ", ";
        }
    }
    return text;
}

std::string summary(const FileReport& file) {
    const Counts counts = counts_of(file);
    const Location whole{file.path, {}};
    const std::string_view verdict = file.is_catalogue
                                         ? (counts[0] > 0 ? "no valid catalogue" : "valid catalogue")
                                     : counts[0] > 0 ? "not valid"
                                                     : "valid";
    return fmt::format("{}: {}{}\n", to_text(whole), verdict,
                       file.findings.empty() ? ", no findings" : counts_text(counts, ", "));
}

// One line over all files: "120 files: 118 valid, 2 not valid; 3 errors, 14 warnings".
std::string total(const std::vector<FileReport>& files) {
    Counts all{};
    std::size_t refused = 0;
    for (const FileReport& file : files) {
        const Counts counts = counts_of(file);
        refused += counts[0] > 0 ? 1U : 0U;
        std::transform(all.begin(), all.end(), counts.begin(), all.begin(), std::plus<>());
    }
    return fmt::format("{} files: {} valid{}{}\n", files.size(), files.size() - refused,
                       refused > 0 ? fmt::format(", {} not valid", refused) : "", counts_text(all, "; "));
}

void append_not_verified(std::string& text, const FileReport& file) {
    std::string_view lead = "  not verified:\n";
    for (const std::string& line : file.not_verified) {
        text += fmt::format("{}  - {}\n", lead, base::printable(line));
        lead = "";
    }
}

}  // namespace

std::string render_human(const RenderInput& input) {
    SourceLines lines(input.sources);
    std::string text;
    for (const FileReport& file : input.files) {
        for (const Diagnostic& finding : file.findings) {
            append_finding(text, finding, lines, input.color);
        }
        if (input.verdicts) {
            text += summary(file);
            append_not_verified(text, file);
            text += file.hint.empty() ? "" : fmt::format("  {}\n", base::printable(file.hint));
        } else if (!text.empty()) {
            text.pop_back();  // the blank line
        }
    }
    if (input.verdicts && input.files.size() > 1) {
        text += total(input.files);
    }
    return text;
}

}  // namespace cgw::diagnostic
