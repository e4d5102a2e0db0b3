// The only file with CLI11, which takes the words of one verb apart. What they mean, the table says.
#include "cli/cgw/parser.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <deque>

namespace cgw::cli {
namespace {

bool asks_for_help(std::string_view word) {
    return word == "-h" || word == "--help";
}

// First words of the verbs: "check", "image".
std::vector<std::string_view> first_words() {
    std::vector<std::string_view> words;
    for (const Verb* verb : all_verbs()) {
        const std::string_view first = verb->name.substr(0, verb->name.find(' '));
        if (words.empty() || words.back() != first) {
            words.push_back(first);
        }
    }
    return words;
}

std::vector<std::string_view> second_words(std::string_view first) {
    std::vector<std::string_view> words;
    for (const Verb* verb : all_verbs()) {
        if (verb->name.starts_with(fmt::format("{} ", first))) {
            words.push_back(verb->name.substr(first.size() + 1));
        }
    }
    return words;
}

const Verb* find_verb(std::string_view name) {
    const std::span<const Verb* const> verbs = all_verbs();
    const auto found =
        std::find_if(verbs.begin(), verbs.end(), [name](const Verb* v) { return v->name == name; });
    return found != verbs.end() ? *found : nullptr;
}

// A verb that takes words of its own, as "image" does, is only named by both.
const Verb& verb_in_group(std::string_view first, std::span<const char* const> words) {
    if (words.size() < 2) {
        throw UsageError(fmt::format("cgw {0} needs one of {1} (see cgw {0} --help)", first,
                                     fmt::join(second_words(first), ", ")));
    }
    const std::string name = fmt::format("{} {}", first, words[1]);
    const Verb* verb = find_verb(name);
    if (verb == nullptr) {
        std::vector<std::string_view> known;
        for (const Verb* other : all_verbs()) {
            known.push_back(other->name);
        }
        throw UsageError(fmt::format("there is no verb '{}'{}", name, did_you_mean(name, known)));
    }
    return *verb;
}

std::string unknown_option(const Verb& verb, std::string_view word) {
    std::vector<std::string_view> known;
    for (const Option& option : verb.options) {
        if (!option.positional()) {
            known.push_back(option.key());
        }
    }
    const std::string_view name = word.substr(0, word.find('='));
    const bool long_name = name.size() > 2;  // one letter is near every other
    return fmt::format("cgw {} has no option {}{}", verb.name, name,
                       long_name ? did_you_mean(name, known) : "");
}

[[noreturn]] void refuse_remaining(const Verb& verb, const std::vector<std::string>& words) {
    for (const std::string& word : words) {
        if (word.size() > 1 && word.front() == '-') {
            throw UsageError(unknown_option(verb, word));
        }
    }
    throw UsageError(fmt::format("'{}' is one argument too many", words.front()));
}

void check_required(const Verb& verb, const Arguments& arguments) {
    for (const Option& option : verb.options) {
        if (option.required && !arguments.given(option.key())) {
            throw UsageError(fmt::format(
                "{} is missing", option.positional() ? std::string(option.names)
                                                     : fmt::format("{} {}", option.key(), option.value)));
        }
    }
}

// One verb's words taken apart by CLI11; the values stay text.
Arguments take_apart(const Verb& verb, std::span<const char* const> words) {
    CLI::App app;
    app.set_help_flag();
    app.allow_extras();
    std::deque<std::vector<std::string>> values(verb.options.size());
    std::deque<std::string> positionals(verb.options.size());
    std::deque<bool> flags(verb.options.size());
    for (std::size_t i = 0; i < verb.options.size(); ++i) {
        const Option& option = verb.options[i];
        if (option.flag()) {
            app.add_flag(std::string(option.names), flags[i]);
        } else if (option.positional() && !option.repeats) {
            app.add_option(std::string(option.names), positionals[i]);
        } else if (option.positional()) {
            app.add_option(std::string(option.names), values[i]);
        } else {
            app.add_option(std::string(option.names), values[i])
                ->type_name(std::string(option.value))
                ->expected(1)
                ->take_all()
                ->allow_extra_args(false);
        }
    }
    std::vector<std::string> reversed(words.rbegin(), words.rend());  // as CLI11 wants them
    try {
        app.parse(reversed);
    } catch (const CLI::ParseError& error) {
        throw UsageError(error.what());
    }
    Arguments arguments(verb.options);
    for (std::size_t i = 0; i < verb.options.size(); ++i) {
        if (flags[i]) {
            arguments.add(verb.options[i], "");
        }
        if (!positionals[i].empty()) {
            arguments.add(verb.options[i], std::move(positionals[i]));
        }
        for (std::string& value : values[i]) {
            arguments.add(verb.options[i], std::move(value));
        }
    }
    std::vector<std::string> remaining = app.remaining();
    std::erase(remaining, "--");  // the end of the options; CLI11 leaves it there
    if (!remaining.empty()) {
        refuse_remaining(verb, remaining);
    }
    check_required(verb, arguments);
    return arguments;
}

}  // namespace

Call parse(std::span<const char* const> words) {
    Call call;
    if (words.empty()) {
        throw UsageError("a verb is missing (see cgw --help)");
    }
    const std::string_view first = words[0];
    if (asks_for_help(first)) {
        return call;
    }
    if (first == "--version") {
        call.version = true;
        return call;
    }
    const std::vector<std::string_view> known = first_words();
    if (std::find(known.begin(), known.end(), first) == known.end()) {
        throw UsageError(
            fmt::format("there is no verb '{}'{} (see cgw --help)", first, did_you_mean(first, known)));
    }
    const bool group = find_verb(first) == nullptr;
    if (group && words.size() > 1 && asks_for_help(words[1])) {
        call.help_of = first;
        return call;
    }
    const Verb& verb = group ? verb_in_group(first, words) : *find_verb(first);
    const std::span<const char* const> rest = words.subspan(group ? 2 : 1);
    const auto options_end = std::find(rest.begin(), rest.end(), std::string_view("--"));
    if (std::any_of(rest.begin(), options_end, asks_for_help)) {
        call.help_of = verb.name;
        return call;
    }
    try {
        call.arguments = take_apart(verb, rest);
    } catch (const UsageError& error) {
        throw UsageError(fmt::format("{} (see cgw {} --help)", error.what(), verb.name));
    }
    call.verb = &verb;
    return call;
}

}  // namespace cgw::cli
