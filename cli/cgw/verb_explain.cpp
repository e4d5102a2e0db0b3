#include <fmt/format.h>

#include <cstdio>

#include "base/utf8.hpp"
#include "catalogue/catalogue.hpp"
#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"
#include "diagnostic/rules.hpp"
#include "explain/explain.hpp"

namespace cgw::cli {
namespace {

using explain::Answer;

std::vector<Word> answer_format_words() {
    return {{"text", "for people"}, {"json", "one JSON document"}};
}

// Proposals for completion, an example of each form and all findings; any question may be right.
std::vector<Word> question_words() {
    std::vector<Word> words;
    for (const explain::QuestionForm& form : explain::question_forms()) {
        words.push_back({form.example, form.meaning});
    }
    for (const diagnostic::Rule* rule : diagnostic::all_rules()) {
        for (const std::string_view name : {rule->code, rule->name}) {
            std::erase_if(words, [name](const Word& word) { return word.name == name; });
            words.push_back({name, rule->summary});
        }
    }
    return words;
}

constexpr Option explain_options[] = {
    {.names = "WHAT",
     .summary = "number, name, value, object or code",
     .required = true,
     .repeats = true,
     .words = question_words,
     .only_words = false},
    {.names = "--format",
     .value = "FORMAT",
     .summary = "form of the answer",
     .default_value = "text",
     .words = answer_format_words},
};

void print_question_forms() {
    std::fputs("What can be explained:\n", stderr);
    for (const explain::QuestionForm& form : explain::question_forms()) {
        std::fputs(fmt::format("  {:18}{}\n", form.example, form.meaning).c_str(), stderr);
    }
}

// Nothing is printed when a question is not understood: half an answer may be taken for a whole one.
int run_explain(const Arguments& arguments) {
    const parameter::Catalogue catalogue(catalogue::shipped_rows());
    std::vector<Answer> answers;
    bool understood = true;
    bool helpless = false;
    for (const std::string& question : arguments.values("WHAT")) {
        Answer answer = explain::explain(question, catalogue);
        if (!answer.understood()) {
            print_error(base::printable(answer.complaint));
            if (!answer.help.empty()) {
                print_error(answer.help);
            }
            understood = false;
            helpless = helpless || answer.help.empty();
        }
        answers.push_back(std::move(answer));
    }
    if (!understood) {
        if (helpless) {
            print_question_forms();
        }
        return exit_usage;
    }
    const bool json = arguments.value("--format") == "json";
    return print(json ? render_json(answers) : render_text(answers)) ? exit_fine : exit_environment;
}

}  // namespace

const Verb explain_verb = {"explain", "say what is behind a number, a name, a value or a code",
                           explain_options, run_explain,
                           "Questions, several at a time:\n"
                           "\n"
                           "  416, CanBaudrate, \"416 CanBaudrate\"   a parameter or measurement\n"
                           "  12412, 3074, sensor-error             an error: cause, action, how it clears\n"
                           "  2005h=0x0102, 2411=2, 3800=9          a value: which bits are set, and why\n"
                           "  827=-5, 900=6, 16400=2000             where a parameter's value leads to\n"
                           "  1018h, 2003h:1, 0x2003:1              an object of the gateway\n"
                           "  0x06010002                            an SDO abort code\n"
                           "  E0203, node-id-duplicate              a finding: why, broken and kept\n"};

}  // namespace cgw::cli
