#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/ascii.hpp"
#include "base/utf8.hpp"
#include "emit/emitter.hpp"

namespace cgw::emit {
namespace {

constexpr std::string_view eds_ending = ".eds";
constexpr std::size_t longest_name = 64;

// Behind --eds-name a slip: "x.dcf" would become "x.dcf.eds".
constexpr std::array<std::string_view, 5> other_endings{".dcf", ".dbc", ".xdd", ".xdc", ".cdcf"};

bool is_allowed(char c) {
    constexpr std::string_view others = " ._-";
    return base::is_letter_or_digit(c) || others.find(c) != std::string_view::npos;
}

bool has_ending(std::string_view name, std::string_view ending) {
    return name.size() > ending.size() &&
           base::equal_ignoring_case(name.substr(name.size() - ending.size()), ending);
}

}  // namespace

std::string file_name(const Format& format, const Options& options) {
    if (!format.follows_eds_name) {
        return std::string(format.file_name);
    }
    if (format.file_name == eds_ending) {
        return options.eds_name;
    }
    return options.eds_name.substr(0, options.eds_name.size() - eds_ending.size()) +
           std::string(format.file_name);
}

base::Result<std::string> eds_file_name(std::string_view name) {
    const auto refuse = [name](std::string_view why) {
        return base::failure(fmt::format("'{}' is no name for a data sheet: {}", base::printable(name), why));
    };
    if (!std::all_of(name.begin(), name.end(), is_allowed)) {
        return refuse("it has letters, digits, blanks and . _ - only, and no directory");
    }
    if (name.empty() || !base::is_letter_or_digit(name.front())) {
        return refuse("it begins with a letter or digit");
    }
    for (const std::string_view ending : other_endings) {
        if (has_ending(name, ending)) {
            return refuse(fmt::format("{} names another kind of file; leave it out, or write .eds", ending));
        }
    }
    const std::string complete =
        has_ending(name, eds_ending) ? std::string(name) : std::string(name) + ".eds";
    const char last = complete[complete.size() - eds_ending.size() - 1];
    if (!base::is_letter_or_digit(last) && last != '_' && last != '-') {
        return refuse("no blank or point stands before .eds");
    }
    if (complete.size() > longest_name) {
        return refuse(fmt::format("it has at most {} characters", longest_name));
    }
    return complete;
}

}  // namespace cgw::emit
