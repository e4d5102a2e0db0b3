#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/cgw/command.hpp"

// What the completion scripts of the three shells need from the table of verbs.
namespace cgw::cli {

// The verbs that share their first word: "image" and its verbs, or "check" alone.
struct Group {
    std::string_view name;
    std::vector<const Verb*> verbs;  // one whose name is the group's, or several in the group
};

std::vector<Group> groups();

// False for a verb of one word.
bool is_group(const Group& group);
std::string summary_of(const Group& group);

// "inspect" of "image inspect".
std::string_view second_word(const Verb& verb);

// The names of an option one by one: "-o", "--output".
std::vector<std::string_view> names_of(const Option& option);

// The words an option allows, joined by blanks; empty when it takes any value.
std::string words_of(const Option& option);

// In single quotes, for every one of the three shells; fish knows no '\'' inside quotes, so none is allowed.
std::string quoted(std::string_view text);

}  // namespace cgw::cli
