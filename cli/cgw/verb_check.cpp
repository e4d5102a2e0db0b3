#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/shared_options.hpp"
#include "cli/cgw/terminal.hpp"
#include "cli/cgw/verbs.hpp"
#include "driver/check_file.hpp"
#include "driver/plant.hpp"

namespace cgw::cli {
namespace {

std::vector<Word> format_words() {
    std::vector<Word> words;
    for (const diagnostic::Renderer& renderer : diagnostic::all_renderers()) {
        words.push_back({renderer.name, renderer.summary});
    }
    return words;
}

// Each as NAME and as no-NAME.
std::vector<Word> rule_words() {
    static const std::vector<std::string> hiding = [] {
        std::vector<std::string> names;
        for (const diagnostic::Rule* rule : diagnostic::all_rules()) {
            names.push_back(fmt::format("no-{}", rule->name));
        }
        return names;
    }();
    std::vector<Word> words;
    auto hide = hiding.begin();
    for (const diagnostic::Rule* rule : diagnostic::all_rules()) {
        if (rule->level != diagnostic::Level::error) {
            words.push_back({rule->name, rule->summary});
            words.push_back({*hide, rule->summary});
        }
        ++hide;
    }
    return words;
}

// By name or by code, as findings print both.
const diagnostic::Rule* find_rule(std::string_view word) {
    const auto rules = diagnostic::all_rules();
    const auto found = std::find_if(rules.begin(), rules.end(),
                                    [word](const auto* r) { return r->name == word || r->code == word; });
    return found != rules.end() ? *found : nullptr;
}

// One word behind -W: NAME or no-NAME.
void apply_warning_word(const std::string& word, std::vector<const diagnostic::Rule*>& hidden) {
    const bool hide = word.starts_with("no-") && find_rule(word) == nullptr;
    const std::string name = hide ? word.substr(3) : word;
    const diagnostic::Rule* rule = find_rule(name);
    if (rule == nullptr) {
        std::vector<std::string_view> names;
        for (const diagnostic::Rule* known : diagnostic::all_rules()) {
            names.push_back(known->name);
            names.push_back(known->code);
        }
        throw UsageError(
            fmt::format("-W {}: there is no rule '{}'{}", word, name, did_you_mean(name, names)));
    }
    if (hide && rule->level == diagnostic::Level::error) {
        throw UsageError(fmt::format("-W {}: '{}' is an error and cannot be hidden", word, name));
    }
    std::erase(hidden, rule);
    if (hide) {
        hidden.push_back(rule);
    }
}

constexpr Option check_options[] = {
    {.names = "FILE",
     .summary = "parameter files and catalogue files; - is standard input",
     .required = true,
     .repeats = true,
     .completes = Completes::files},
    {.names = "--format",
     .value = "FORMAT",
     .summary = "how findings are printed",
     .default_value = "human",
     .words = format_words},
    {.names = "--werror", .summary = "treat warnings as errors"},
    {.names = "-W",
     .value = "NAME",
     .summary = "show (NAME) or hide (no-NAME) a warning or note, by name or code",
     .repeats = true,
     .words = rule_words,
     .only_words = false},
    color_option,
};

int run_check(const Arguments& arguments) {
    const std::vector<std::string>& paths = arguments.values("FILE");
    if (std::count(paths.begin(), paths.end(), "-") > 1) {
        throw UsageError("standard input (-) can be read only once");
    }
    std::vector<const diagnostic::Rule*> hidden;
    for (const std::string& word : arguments.values("-W")) {
        apply_warning_word(word, hidden);
    }
    int exit_code = exit_fine;
    diagnostic::RenderInput input;
    input.color = use_color(arguments, stdout);
    input.tool_version = driver::tool_version();
    for (const std::string& path : paths) {
        driver::CheckedFile file = driver::check_file_or_catalogue(path);
        file.findings.hide(hidden);
        if (arguments.given("--werror")) {
            file.findings.promote_warnings();
        }
        exit_code = worse(exit_code, exit_code_of(file));
        if (!file.valid()) {
            file.not_verified.clear();
        }
        input.files.push_back({path, file.findings.all(), std::move(file.not_verified), file.is_catalogue});
        input.sources.merge(std::move(file.sources));
    }
    const diagnostic::Renderer* renderer = diagnostic::find_renderer(arguments.value("--format"));
    return print(renderer->render(input)) ? exit_code : exit_environment;
}

}  // namespace

const Verb check_verb = {"check", "check parameter files and report every finding", check_options, run_check};

}  // namespace cgw::cli
