// The command line as a table: verbs, their options, and what was given on one call. Parser, --help, man
// pages and shell completion are derived from these rows.
#pragma once

#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace cgw::cli {

// A value that an option may have, for messages and completion.
struct Word {
    std::string_view name;
    std::string_view summary;
};

// What a shell completes as the value of an option without `words`.
enum class Completes { nothing, files, directories };

struct Option {
    std::string_view
        names;  // "-o,--output", the last is the option's key; "FILE" without dashes: by position
    std::string_view value{};    // what help calls the value: "PATH"; empty: the option is a flag
    std::string_view summary{};  // one line, no final period
    std::string_view default_value{};
    bool required = false;
    bool repeats = false;                    // may be given several times
    std::vector<Word> (*words)() = nullptr;  // the values it may have
    bool only_words = true;                  // false: `words` are proposals, other values may be right
    Completes completes = Completes::nothing;

    std::string_view key() const;  // "--output", "FILE"
    bool positional() const { return names.front() != '-'; }
    bool flag() const { return value.empty() && !positional(); }
};

// The command line does not make sense: one line for the user, exit code 2.
class UsageError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// What was given for the options of one verb, checked against its rows.
class Arguments {
  public:
    explicit Arguments(std::span<const Option> options) : options_(options) {}

    void add(const Option& option, std::string value);

    // By key; asking for an option that the verb does not have is a fault of the program (std::logic_error).
    bool given(std::string_view key) const;
    std::string value(std::string_view key) const;  // the option's default when not given
    const std::vector<std::string>& values(std::string_view key) const;

  private:
    const Option& option(std::string_view key) const;

    std::span<const Option> options_;
    std::map<std::string_view, std::vector<std::string>> given_;
};

struct Verb {
    std::string_view name;  // "check", "image verify"
    std::string_view summary;
    std::span<const Option> options;
    int (*run)(const Arguments&);  // returns the exit code, throws UsageError
    std::string_view details{};    // paragraphs for --help and the man page, at most 80 columns
};

// In the order of the help.
std::span<const Verb* const> all_verbs();

// "; did you mean 'check'?", or nothing when no name is near.
std::string did_you_mean(std::string_view name, std::span<const std::string_view> known);

std::vector<std::string_view> names_of(std::span<const Word> words);

}  // namespace cgw::cli
