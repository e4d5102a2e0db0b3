#include "cli/cgw/command.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/edit_distance.hpp"

namespace cgw::cli {

std::string_view Option::key() const {
    return names.substr(names.rfind(',') + 1);
}

void Arguments::add(const Option& option, std::string value) {
    if (option.words != nullptr && option.only_words) {
        const std::vector<Word> words = option.words();
        const std::vector<std::string_view> names = names_of(words);
        if (std::find(names.begin(), names.end(), value) == names.end()) {
            throw UsageError(fmt::format("{} {}: not one of {}{}", option.key(), value,
                                         fmt::join(names, ", "), did_you_mean(value, names)));
        }
    }
    std::vector<std::string>& values = given_[option.key()];
    if (!values.empty() && !option.repeats && !option.flag()) {
        throw UsageError(fmt::format("{} is given twice: {} and {}", option.key(), values.front(), value));
    }
    values.push_back(std::move(value));
}

const Option& Arguments::option(std::string_view key) const {
    for (const Option& option : options_) {
        if (option.key() == key) {
            return option;
        }
    }
    throw std::logic_error(fmt::format("there is no option {}", key));
}

bool Arguments::given(std::string_view key) const {
    return given_.contains(option(key).key());
}

std::string Arguments::value(std::string_view key) const {
    const Option& wanted = option(key);
    const auto found = given_.find(wanted.key());
    return found != given_.end() ? found->second.front() : std::string(wanted.default_value);
}

const std::vector<std::string>& Arguments::values(std::string_view key) const {
    static const std::vector<std::string> none;
    const auto found = given_.find(option(key).key());
    return found != given_.end() ? found->second : none;
}

std::string did_you_mean(std::string_view name, std::span<const std::string_view> known) {
    const std::string nearest = base::nearest_name(name, known);
    return nearest.empty() ? std::string() : fmt::format("; did you mean '{}'?", nearest);
}

std::vector<std::string_view> names_of(std::span<const Word> words) {
    std::vector<std::string_view> names;
    for (const Word& word : words) {
        names.push_back(word.name);
    }
    return names;
}

}  // namespace cgw::cli
