#include "cli/cgw/shell_completion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "cli/cgw/command.hpp"

namespace cgw::cli {
namespace {

// The names of an option one by one: "-o", "--output".
std::vector<std::string_view> names_of(const Option& option) {
    std::vector<std::string_view> names;
    std::string_view rest = option.names;
    while (!rest.empty()) {
        names.push_back(rest.substr(0, rest.find(',')));
        rest.remove_prefix(std::min(rest.size(), names.back().size() + 1));
    }
    return names;
}

std::string words_of(const Option& option) {
    if (option.words == nullptr) {
        return "";
    }
    const std::vector<Word> words = option.words();
    return fmt::format("{}", fmt::join(cli::names_of(words), " "));
}

// In single quotes, for every one of the three shells; fish knows no '\'' inside quotes, so none is allowed.
std::string quoted(std::string_view text) {
    std::string out(text);
    std::replace(out.begin(), out.end(), '\'', '`');
    return fmt::format("'{}'", out);
}

struct Group {
    std::string_view name;
    std::vector<const Verb*> verbs;  // one whose name is the group's, or several in the group
};

std::vector<Group> groups() {
    std::vector<Group> all;
    for (const Verb* verb : all_verbs()) {
        const std::string_view first = verb->name.substr(0, verb->name.find(' '));
        if (all.empty() || all.back().name != first) {
            all.push_back({first, {}});
        }
        all.back().verbs.push_back(verb);
    }
    return all;
}

bool is_group(const Group& group) {
    return group.verbs.front()->name != group.name;
}

std::string_view second_word(const Verb& verb) {
    return verb.name.substr(verb.name.find(' ') + 1);
}

std::string summary_of(const Group& group) {
    if (!is_group(group)) {
        return std::string(group.verbs.front()->summary);
    }
    std::vector<std::string_view> words;
    for (const Verb* verb : group.verbs) {
        words.push_back(second_word(*verb));
    }
    return fmt::format("{}", fmt::join(words, ", "));
}

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

// The options of a verb that take a value, joined by blanks: the word behind one is no argument.
std::string names_with_value(const Verb& verb) {
    std::string text;
    for (const Option& option : verb.options) {
        if (!option.positional() && !option.flag()) {
            text += fmt::format(" {}", fmt::join(names_of(option), " "));
        }
    }
    return text;
}

std::string fish_option(const Verb& verb, const Option& option, int position) {
    const int at = option.positional() && !option.repeats ? position : 0;
    std::string text =
        fmt::format("complete -c cgw -n {}",
                    quoted(fmt::format("__cgw_at {} \"{}\"{}", at, verb.name, names_with_value(verb))));
    if (!option.positional()) {
        for (const std::string_view name : names_of(option)) {
            text += name.starts_with("--") ? fmt::format(" -l {}", name.substr(2))
                                           : fmt::format(" -s {}", name.substr(1));
        }
        text += option.flag() ? "" : " -r";
    }
    if (option.words != nullptr) {
        text += fmt::format(" -f -a {}", quoted(words_of(option)));
    } else if (option.completes == Completes::files) {
        text += " -F";
    } else if (option.completes == Completes::directories) {
        text += " -f -a '(__fish_complete_directories)'";
    }
    return text + fmt::format(" -d {}\n", quoted(option.summary));
}

std::string fish_verb(const Verb& verb) {
    std::string text;
    int position = 0;
    for (const Option& option : verb.options) {
        position += option.positional() ? 1 : 0;
        text += fish_option(verb, option, position);
    }
    return text;
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
    return fmt::format(
        "# bash completion for cgw, made from its table of verbs\n\n"
        "# Which argument without dashes the cursor is at, from 1; $1: options that take a value, joined by "
        "|\n"
        "_cgw_position() {{\n"
        "    local position=1 i word skip=0 first=2\n"
        "    [[ $verb == *' '* ]] && first=3\n"
        "    for ((i = first; i < COMP_CWORD; i++)); do\n"
        "        word=${{COMP_WORDS[i]}}\n"
        "        if ((skip)); then skip=0\n"
        "        elif [[ $word == -?* ]]; then [[ \"|$1|\" == *\"|$word|\"* ]] && skip=1\n"
        "        else ((position++)); fi\n"
        "    done\n"
        "    echo \"$position\"\n"
        "}}\n\n"
        "_cgw_reply() {{\n    mapfile -t COMPREPLY < <(compgen \"$@\" -- \"$cur\")\n}}\n\n"
        "_cgw() {{\n"
        "    local cur=${{COMP_WORDS[COMP_CWORD]}} prev=${{COMP_WORDS[COMP_CWORD-1]}} "
        "verb=${{COMP_WORDS[1]}}\n"
        "    local options with_value\n"
        "    COMPREPLY=()\n"
        "    [[ $prev == '=' ]] && prev=${{COMP_WORDS[COMP_CWORD-2]}}  # --format=…\n"
        "    [[ $cur == '=' ]] && cur=\n"
        "    ((COMP_CWORD == 1)) && {{ _cgw_reply -W '{}--help --version'; return; }}\n"
        "    case $verb in\n{}    *) ;;\n    esac\n"
        "    case $verb in\n{}        *) ;;\n    esac\n"
        "}}\n\n"
        "complete -o filenames -F _cgw cgw\n",
        first_words(), seconds, verbs);
}

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
    return fmt::format(
        "#compdef cgw\n# zsh completion for cgw, made from its table of verbs\n\n"
        "_cgw() {{\n"
        "    local -a verbs seconds\n"
        "    local verb=$words[2]\n"
        "    verbs=(\n{}    )\n"
        "    if ((CURRENT == 2)); then\n        _describe verb verbs\n        return\n    fi\n"
        "    case $verb in\n{}    esac\n"
        "    if (($#seconds)); then\n"
        "        if ((CURRENT == 3)); then\n            _describe verb seconds\n            return\n        "
        "fi\n"
        "        verb=\"$verb $words[3]\"\n"
        "        shift words\n"
        "        ((CURRENT--))\n"
        "    fi\n"
        "    shift words\n"
        "    ((CURRENT--))\n"
        "    case $verb in\n{}    esac\n"
        "}}\n\n_cgw \"$@\"\n",
        firsts, seconds, verbs);
}

std::string fish_completion() {
    std::string groups_with_verbs;
    std::string rows;
    std::string options;
    for (const Group& group : groups()) {
        rows += fmt::format("complete -c cgw -n '__cgw_at 1 \"\"' -a {} -d {}\n", group.name,
                            quoted(summary_of(group)));
        if (is_group(group)) {
            groups_with_verbs += fmt::format("{} ", group.name);
        }
        for (const Verb* verb : group.verbs) {
            if (is_group(group)) {
                rows += fmt::format("complete -c cgw -n '__cgw_at 1 \"{}\"' -a {} -d {}\n", group.name,
                                    second_word(*verb), quoted(verb->summary));
            }
            options += fish_verb(*verb);
        }
    }
    return fmt::format(
        "# fish completion for cgw, made from its table of verbs\n\n"
        "# True at argument $argv[1] (from 1; 0: any) of the verb $argv[2] (\"\": no verb is typed yet); "
        "behind\n"
        "# them the options of that verb that take a value\n"
        "function __cgw_at\n"
        "    set -l words (commandline -opc)\n"
        "    set -e words[1]\n"
        "    set -l verb\n"
        "    if set -q words[1]\n"
        "        set verb $words[1]\n"
        "        set -e words[1]\n"
        "        if contains -- $verb {}; and set -q words[1]\n"
        "            set verb \"$verb $words[1]\"\n"
        "            set -e words[1]\n"
        "        end\n"
        "    end\n"
        "    test \"$verb\" = $argv[2]; or return 1\n"
        "    test $argv[1] -eq 0; and return 0\n"
        "    set -l position 1\n"
        "    set -l skip 0\n"
        "    for word in $words\n"
        "        if test $skip -eq 1\n"
        "            set skip 0\n"
        "        else if string match -q -- '-?*' $word\n"
        "            contains -- $word $argv[3..]; and set skip 1\n"
        "        else\n"
        "            set position (math $position + 1)\n"
        "        end\n"
        "    end\n"
        "    test $position -eq $argv[1]\n"
        "end\n\n"
        "complete -c cgw -f\n{}{}",
        groups_with_verbs, rows, options);
}

}  // namespace cgw::cli
