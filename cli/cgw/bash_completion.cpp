#include <fmt/format.h>

#include <algorithm>

#include "cli/cgw/completion_words.hpp"
#include "cli/cgw/shell_completion.hpp"

namespace cgw::cli {
namespace {

// The whole script; the braces are filled in order.
constexpr char bash_script[] = R"(# bash completion for cgw, made from its table of verbs

# Which argument without dashes the cursor is at, from 1; $1: options that take a value, joined by |
_cgw_position() {{
    local position=1 i word skip=0 first=2
    [[ $verb == *' '* ]] && first=3
    for ((i = first; i < COMP_CWORD; i++)); do
        word=${{COMP_WORDS[i]}}
        if ((skip)); then skip=0
        elif [[ $word == -?* ]]; then [[ "|$1|" == *"|$word|"* ]] && skip=1
        else ((position++)); fi
    done
    echo "$position"
}}

_cgw_reply() {{
    mapfile -t COMPREPLY < <(compgen "$@" -- "$cur")
}}

_cgw() {{
    local cur=${{COMP_WORDS[COMP_CWORD]}} prev=${{COMP_WORDS[COMP_CWORD-1]}} verb=${{COMP_WORDS[1]}}
    local options with_value
    COMPREPLY=()
    [[ $prev == '=' ]] && prev=${{COMP_WORDS[COMP_CWORD-2]}}  # --format=…
    [[ $cur == '=' ]] && cur=
    ((COMP_CWORD == 1)) && {{ _cgw_reply -W '{}--help --version'; return; }}
    case $verb in
{}    *) ;;
    esac
    case $verb in
{}        *) ;;
    esac
}}

complete -o filenames -F _cgw cgw
)";

// Of a program without verbs: its name, the function, values of options, options.
constexpr char bash_command_script[] = R"(# bash completion for {0}, made from its table of options

{1}() {{
    local cur=${{COMP_WORDS[COMP_CWORD]}} prev=${{COMP_WORDS[COMP_CWORD-1]}}
    COMPREPLY=()
    [[ $prev == '=' ]] && prev=${{COMP_WORDS[COMP_CWORD-2]}}
    [[ $cur == '=' ]] && cur=
    case $prev in
{2}    *) ;;
    esac
    mapfile -t COMPREPLY < <(compgen -W '{3}' -- "$cur")
}}

complete -o filenames -F {1} {0}
)";

std::string first_words() {
    std::string text;
    for (const Group& group : groups()) {
        text += fmt::format("{} ", group.name);
    }
    return text;
}

// How bash completes the value of an option: a list of words, or compgen's own kinds.
std::string bash_values(const Option& option) {
    if (option.words != nullptr) {
        return fmt::format("-W {}", quoted(words_of(option)));
    }
    return option.completes == Completes::files         ? "-f"
           : option.completes == Completes::directories ? "-d"
                                                        : "-W ''";
}

std::string bash_verb(const Verb& verb) {
    std::string options;
    std::string with_value;
    std::string values;
    std::string positionals;
    int position = 0;
    for (const Option& option : verb.options) {
        if (option.positional()) {
            ++position;
            positionals += fmt::format("            {}) _cgw_reply {} ;;\n",
                                       option.repeats ? "*" : std::to_string(position), bash_values(option));
            continue;
        }
        const std::vector<std::string_view> names = names_of(option);
        options += fmt::format("{} ", fmt::join(names, " "));
        if (!option.flag()) {
            with_value += fmt::format("{}{}", with_value.empty() ? "" : "|", fmt::join(names, "|"));
            values += fmt::format("            {}) _cgw_reply {}; return ;;\n", fmt::join(names, "|"),
                                  bash_values(option));
        }
    }
    return fmt::format(
        "        {})\n"
        "            options='{}--help'\n"
        "            with_value='{}'\n"
        "            case $prev in\n{}"
        "            *) ;;\n"
        "            esac\n"
        "            [[ $cur == -* ]] && {{ _cgw_reply -W \"$options\"; return; }}\n"
        "            case $(_cgw_position \"$with_value\") in\n{}"
        "            *) ;;\n"
        "            esac ;;\n",
        quoted(verb.name), options, with_value, values, positionals);
}

}  // namespace

std::string bash_completion() {
    std::string seconds;
    std::string verbs;
    for (const Group& group : groups()) {
        if (is_group(group)) {
            std::string words;
            for (const Verb* verb : group.verbs) {
                words += fmt::format("{} ", second_word(*verb));
            }
            seconds += fmt::format(
                "    {0})\n        ((COMP_CWORD == 2)) && {{ _cgw_reply -W '{1}'; return; }}\n"
                "        verb=\"$verb ${{COMP_WORDS[2]}}\" ;;\n",
                group.name, words);
        }
        for (const Verb* verb : group.verbs) {
            verbs += bash_verb(*verb);
        }
    }
    return fmt::format(bash_script, first_words(), seconds, verbs);
}

namespace {

// A name of a shell function.
std::string function_name(std::string_view program) {
    std::string name = fmt::format("_{}", program);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

}  // namespace

std::string bash_completion(const Verb& command) {
    std::string options;
    std::string values;
    for (const Option& option : command.options) {
        const std::vector<std::string_view> names = names_of(option);
        options += fmt::format("{}{}", options.empty() ? "" : " ", fmt::join(names, " "));
        if (!option.flag()) {
            values += fmt::format("    {}) mapfile -t COMPREPLY < <(compgen {} -- \"$cur\"); return ;;\n",
                                  fmt::join(names, "|"), bash_values(option));
        }
    }
    return fmt::format(bash_command_script, command.name, function_name(command.name), values, options);
}

}  // namespace cgw::cli
