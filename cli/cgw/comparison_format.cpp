#include "cli/cgw/comparison_format.hpp"

#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/terminal.hpp"

namespace cgw::cli {
namespace {

struct Format {
    Word word;
    std::string (*render)(const compare::Comparison&, const compare::SideName&, const compare::SideName&);
};

constexpr Format formats[] = {
    {{"text", "for people"}, compare::render_text},
    {{"json", "one JSON document"}, compare::render_json},
};

}  // namespace

std::vector<Word> comparison_format_words() {
    std::vector<Word> words;
    for (const Format& format : formats) {
        words.push_back(format.word);
    }
    return words;
}

int print_comparison(const Arguments& arguments, const compare::Comparison& comparison,
                     const compare::SideName& a, const compare::SideName& b) {
    const std::string name = arguments.value("--format");
    for (const Format& format : formats) {
        if (format.word.name == name && !print(format.render(comparison, a, b))) {
            return exit_environment;
        }
    }
    return comparison.same() ? exit_fine : exit_findings;
}

}  // namespace cgw::cli
