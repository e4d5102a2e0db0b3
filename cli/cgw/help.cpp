#include "cli/cgw/help.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/cgw/exit_codes.hpp"

namespace cgw::cli {
namespace {

constexpr std::size_t columns = 80;
constexpr char hard_blank = '\x01';

std::size_t width(std::string_view text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

// The text in lines of at most 80 columns, all but the first indented. A hard_blank never breaks.
std::string wrapped(std::string_view text, std::size_t first_column, std::size_t indent) {
    std::string out;
    std::size_t column = first_column;
    while (!text.empty()) {
        const std::string_view word = text.substr(0, text.find(' '));
        text.remove_prefix(std::min(text.size(), word.size() + 1));
        const bool at_start = column == indent || out.empty();
        if (!at_start && column + 1 + width(word) > columns) {
            out += "\n" + std::string(indent, ' ');
            column = indent;
        } else if (!at_start) {
            out += ' ';
            ++column;
        }
        out += word;
        column += width(word);
    }
    std::replace(out.begin(), out.end(), hard_blank, ' ');
    return out + "\n";
}

// Two columns, the right one wrapped; a long left side has a line of its own.
std::string entry(std::string_view left, std::string_view right, std::size_t indent) {
    std::string line = fmt::format("  {}", left);
    const std::size_t used = width(line);
    line += used + 2 > indent ? "\n" + std::string(indent, ' ') : std::string(indent - used, ' ');
    return line + wrapped(right, indent, indent);
}

std::string option_list(const Verb& verb, bool positional) {
    constexpr std::size_t indent = 24;
    std::string text;
    for (const Option& option : verb.options) {
        if (option.positional() == positional) {
            text += entry(option_heading(option), option_text(option), indent);
        }
    }
    return text;
}

std::string verb_help(const Verb& verb) {
    std::string text =
        "Usage: " + wrapped(synopsis(verb, hard_blank), 7, 11) + "\n" + wrapped(verb.summary, 0, 0);
    if (!verb.details.empty()) {
        text += fmt::format("\n{}{}", verb.details, verb.details.ends_with('\n') ? "" : "\n");
    }
    if (const std::string arguments = option_list(verb, true); !arguments.empty()) {
        text += "\nArguments:\n" + arguments;
    }
    return text + "\nOptions:\n" + option_list(verb, false) + entry("-h, --help", "print this help", 24);
}

std::string verb_list(std::string_view group) {
    std::string text;
    for (const Verb* verb : all_verbs()) {
        if (group.empty() || verb->name.starts_with(fmt::format("{} ", group))) {
            text += entry(verb->name, verb->summary, 19);
        }
    }
    return text;
}

std::string exit_codes_line() {
    std::string text = "Exit codes:";
    for (const ExitCodeText& row : exit_code_texts()) {
        text += fmt::format("{} {} {}", row.code == 0 ? "" : ",", row.code, row.meaning);
    }
    return wrapped(text, 0, 0);
}

}  // namespace

std::string option_heading(const Option& option) {
    if (option.positional()) {
        return fmt::format("{}{}", option.names, option.repeats ? "…" : "");
    }
    std::string text;
    std::string_view names = option.names;
    while (!names.empty()) {
        const std::string_view name = names.substr(0, names.find(','));
        names.remove_prefix(std::min(names.size(), name.size() + 1));
        text += fmt::format("{}{}", text.empty() ? "" : ", ", name);
    }
    return option.flag() ? text : fmt::format("{} {}", text, option.value);
}

std::string option_text(const Option& option) {
    std::string text(option.summary);
    if (option.words != nullptr && option.only_words) {
        const std::vector<Word> words = option.words();
        text += fmt::format(": {}", fmt::join(names_of(words), ", "));
    }
    if (!option.default_value.empty()) {
        text += fmt::format(" (default {})", option.default_value);
    }
    return text;
}

std::string synopsis(const Verb& verb, char blank) {
    return synopsis(fmt::format("cgw {}", verb.name), verb, blank);
}

std::string synopsis(std::string_view call, const Verb& verb, char blank) {
    std::string text(call);
    for (const Option& option : verb.options) {
        const std::string_view first_name = option.names.substr(0, option.names.find(','));
        const std::string word = option.positional() ? option_heading(option)
                                 : option.flag()     ? std::string(option.key())
                                                     : fmt::format("{}{}{}", first_name, blank, option.value);
        text += option.required ? " " + word : fmt::format(" [{}]", word);
    }
    return text;
}

std::span<const ExitCodeText> exit_code_texts() {
    static constexpr ExitCodeText rows[] = {
        {exit_fine, "fine"},
        {exit_findings, "findings of level error, stale or differing files, a refused image"},
        {exit_usage, "wrong usage"},
        {exit_environment, "cannot read or write"},
        {exit_internal, "internal error"},
    };
    return rows;
}

std::string help_text(std::string_view name) {
    for (const Verb* verb : all_verbs()) {
        if (!name.empty() && verb->name == name) {
            return verb_help(*verb);
        }
    }
    const std::string group = name.empty() ? std::string() : fmt::format(" {}", name);
    return fmt::format(
        "Usage: cgw{0} VERB [ARGUMENT…]\n\n"
        "Configuration compiler for HEINZMANN CANopen gateways\n\n"
        "Verbs:\n{1}\n"
        "cgw{0} VERB --help says more about each, cgw --version prints the version.\n{2}",
        group, verb_list(name), exit_codes_line());
}

}  // namespace cgw::cli
