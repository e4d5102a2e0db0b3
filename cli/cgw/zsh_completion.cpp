#include <fmt/format.h>

#include "cli/cgw/completion_words.hpp"
#include "cli/cgw/shell_completion.hpp"

namespace cgw::cli {
namespace {

// The whole script; the braces are filled in order.
constexpr char zsh_script[] = R"(#compdef cgw
# zsh completion for cgw, made from its table of verbs

_cgw() {{
    local -a verbs seconds
    local verb=$words[2]
    verbs=(
{}    )
    if ((CURRENT == 2)); then
        _describe verb verbs
        return
    fi
    case $verb in
{}    esac
    if (($#seconds)); then
        if ((CURRENT == 3)); then
            _describe verb seconds
            return
        fi
        verb="$verb $words[3]"
        shift words
        ((CURRENT--))
    fi
    shift words
    ((CURRENT--))
    case $verb in
{}    esac
}}

_cgw "$@"
)";

std::string zsh_values(const Option& option) {
    if (option.words != nullptr) {
        return fmt::format("({})", words_of(option));
    }
    return option.completes == Completes::files         ? "_files"
           : option.completes == Completes::directories ? "_files -/"
                                                        : " ";
}

// What _arguments gives a meaning of its own inside a description.
std::string zsh_text(std::string_view text) {
    std::string out;
    for (const char c : text) {
        out += c == '[' || c == ']' || c == ':' || c == '\\' ? fmt::format("\\{}", c) : std::string(1, c);
    }
    return out;
}

std::string zsh_option(const Option& option) {
    if (option.positional()) {
        return quoted(fmt::format("{}:{}:{}", option.repeats ? "*" : "", option.names, zsh_values(option)));
    }
    const std::vector<std::string_view> names = names_of(option);
    const std::string tail =
        quoted(fmt::format("[{}]{}", zsh_text(option.summary),
                           option.flag() ? "" : fmt::format(":{}:{}", option.value, zsh_values(option))));
    if (option.repeats) {
        return fmt::format("'*'{}{}", names.front(), tail);
    }
    return names.size() == 1
               ? fmt::format("{}{}", names.front(), tail)
               : fmt::format("'({})'{{{}}}{}", fmt::join(names, " "), fmt::join(names, ","), tail);
}

std::string zsh_verb(const Verb& verb) {
    std::string text = fmt::format("        ({}) _arguments", quoted(verb.name));
    for (const Option& option : verb.options) {
        text += fmt::format(" \\\n            {}", zsh_option(option));
    }
    return text + " \\\n            '(-h --help)'{-h,--help}'[print help]' ;;\n";
}

}  // namespace

std::string zsh_completion() {
    std::string firsts;
    std::string seconds;
    std::string verbs;
    for (const Group& group : groups()) {
        firsts += fmt::format("        {}\n", quoted(fmt::format("{}:{}", group.name, summary_of(group))));
        if (is_group(group)) {
            seconds += fmt::format("        ({}) seconds=(", group.name);
            for (const Verb* verb : group.verbs) {
                seconds +=
                    fmt::format("{} ", quoted(fmt::format("{}:{}", second_word(*verb), verb->summary)));
            }
            seconds += ") ;;\n";
        }
        for (const Verb* verb : group.verbs) {
            verbs += zsh_verb(*verb);
        }
    }
    return fmt::format(zsh_script, firsts, seconds, verbs);
}

std::string zsh_completion(const Verb& command) {
    std::string text = fmt::format(
        "#compdef {0}\n# zsh completion for {0}, made from its table of options\n\n_arguments", command.name);
    for (const Option& option : command.options) {
        text += fmt::format(" \\\n    {}", zsh_option(option));
    }
    return text + "\n";
}

}  // namespace cgw::cli
