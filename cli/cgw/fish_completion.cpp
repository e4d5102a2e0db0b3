#include <fmt/format.h>

#include "cli/cgw/completion_words.hpp"
#include "cli/cgw/shell_completion.hpp"

namespace cgw::cli {
namespace {

// The whole script; the braces are filled in order.
constexpr char fish_script[] = R"(# fish completion for cgw, made from its table of verbs

# True at argument $argv[1] (from 1; 0: any) of the verb $argv[2] ("": no verb is typed yet); behind
# them the options of that verb that take a value
function __cgw_at
    set -l words (commandline -opc)
    set -e words[1]
    set -l verb
    if set -q words[1]
        set verb $words[1]
        set -e words[1]
        if contains -- $verb {}; and set -q words[1]
            set verb "$verb $words[1]"
            set -e words[1]
        end
    end
    test "$verb" = $argv[2]; or return 1
    test $argv[1] -eq 0; and return 0
    set -l position 1
    set -l skip 0
    for word in $words
        if test $skip -eq 1
            set skip 0
        else if string match -q -- '-?*' $word
            contains -- $word $argv[3..]; and set skip 1
        else
            set position (math $position + 1)
        end
    end
    test $position -eq $argv[1]
end

complete -c cgw -f
{}{})";

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

// What stands behind "complete -c cgw -n …".
std::string fish_tail(const Option& option) {
    std::string text;
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

std::string fish_option(const Verb& verb, const Option& option, int position) {
    const int at = option.positional() && !option.repeats ? position : 0;
    return fmt::format("complete -c cgw -n {}{}",
                       quoted(fmt::format("__cgw_at {} \"{}\"{}", at, verb.name, names_with_value(verb))),
                       fish_tail(option));
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
    return fmt::format(fish_script, groups_with_verbs, rows, options);
}

std::string fish_completion(const Verb& command) {
    std::string text = fmt::format(
        "# fish completion for {0}, made from its table of options\n\ncomplete -c {0} -f\n", command.name);
    for (const Option& option : command.options) {
        text += fmt::format("complete -c {}{}", command.name, fish_tail(option));
    }
    return text;
}

}  // namespace cgw::cli
