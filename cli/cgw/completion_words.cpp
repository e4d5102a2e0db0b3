#include "cli/cgw/completion_words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace cgw::cli {

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

std::string quoted(std::string_view text) {
    std::string out(text);
    std::replace(out.begin(), out.end(), '\'', '`');
    return fmt::format("'{}'", out);
}

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

}  // namespace cgw::cli
