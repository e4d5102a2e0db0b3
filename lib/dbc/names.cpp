#include "dbc/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/ascii.hpp"
#include "dictionary/ascii.hpp"

namespace cgw::dbc {
namespace {

constexpr std::string_view nameless = "Unnamed";

// Keywords that do not end in an underscore; all others do, and no name of ours may.
constexpr std::array<std::string_view, 7> keywords{"VERSION", "FILTER", "INT", "HEX",
                                                   "FLOAT",   "STRING", "ENUM"};

void strip_underscores(std::string& name) {
    name.erase(name.find_last_not_of('_') + 1);
}

// Runs of other characters become one underscore.
std::string joined_words(std::string_view ascii) {
    std::string name;
    for (const char c : ascii) {
        if (base::is_letter_or_digit(c) || c == '_') {
            name += c;
        } else if (!name.empty() && name.back() != '_') {
            name += '_';
        }
    }
    strip_underscores(name);
    return name;
}

}  // namespace

std::string identifier(std::string_view utf8, std::string_view ending) {
    std::string name = joined_words(dictionary::to_ascii(utf8));
    if (name.empty()) {
        name = nameless;
    }
    if (base::is_digit(name.front()) || std::find(keywords.begin(), keywords.end(), name) != keywords.end()) {
        name.insert(0, "_");
    }
    name.resize(std::min(name.size(), longest_name - ending.size()));
    strip_underscores(name);
    return name.append(ending);
}

std::string Names::take(const std::string& wanted) {
    std::string name = wanted;
    for (int count = 2; std::find(taken_.begin(), taken_.end(), base::lowered(name)) != taken_.end();
         ++count) {
        const std::string ending = fmt::format("_{}", count);
        name = wanted.substr(0, longest_name - ending.size()) + ending;
    }
    taken_.push_back(base::lowered(name));
    return name;
}

}  // namespace cgw::dbc
