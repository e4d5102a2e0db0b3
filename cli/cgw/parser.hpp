// From argv to a verb and its arguments.
#pragma once

#include <span>
#include <string_view>

#include "cli/cgw/command.hpp"

namespace cgw::cli {

struct Call {
    const Verb* verb = nullptr;  // nullptr: the help of `help_of`, or the version, is asked for
    Arguments arguments{{}};
    bool version = false;
    std::string_view help_of{};  // verb or group of verbs ("image"); "" is the program
};

// `words` are the words behind the program's name. Throws UsageError.
Call parse(std::span<const char* const> words);

}  // namespace cgw::cli
