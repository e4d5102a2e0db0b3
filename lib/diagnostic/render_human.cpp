#include <fmt/format.h>

#include <algorithm>

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

std::string summary(const FileReport& file) {
    std::size_t counts[3] = {};
    for (const Diagnostic& finding : file.findings) {
        ++counts[static_cast<std::size_t>(finding.level())];
    }
    const Location whole{file.path, {}};
    const std::string_view verdict = file.is_catalogue
                                         ? (counts[0] > 0 ? "no valid catalogue" : "valid catalogue")
                                     : counts[0] > 0 ? "not valid"
                                                     : "valid";
    std::string text = fmt::format("{}: {}", to_text(whole), verdict);
    std::string_view separator = ", ";
    for (const Level level : {Level::error, Level::warning, Level::note}) {
        if (const std::size_t count = counts[static_cast<std::size_t>(level)]; count > 0) {
            text += fmt::format("{}{}", separator, plural(count, to_text(level)));
        }
    }
    return text + (file.findings.empty() ? ", no findings\n" : "\n");
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
    return text;
}

}  // namespace cgw::diagnostic
