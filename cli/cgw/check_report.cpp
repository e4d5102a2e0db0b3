#include "cli/cgw/check_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cli/cgw/exit_codes.hpp"
#include "cli/cgw/terminal.hpp"
#include "diagnostic/rules.hpp"
#include "driver/plant.hpp"

namespace cgw::cli {
namespace {

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

bool has_error(const diagnostic::FileReport& file) {
    return std::any_of(file.findings.begin(), file.findings.end(),
                       [](const auto& finding) { return finding.level() == diagnostic::Level::error; });
}

}  // namespace

std::vector<Word> finding_format_words() {
    std::vector<Word> words;
    for (const diagnostic::Renderer& renderer : diagnostic::all_renderers()) {
        words.push_back({renderer.name, renderer.summary});
    }
    return words;
}

// Each as NAME and as no-NAME.
std::vector<Word> finding_rule_words() {
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

const std::vector<std::string>& checked_files(const Arguments& arguments) {
    const std::vector<std::string>& paths = arguments.values("FILE");
    if (std::count(paths.begin(), paths.end(), "-") > 1) {
        throw UsageError("standard input (-) can be read only once");
    }
    return paths;
}

CheckReport::CheckReport(const Arguments& arguments) : arguments_(arguments), exit_code_(exit_fine) {
    for (const std::string& word : arguments.values("-W")) {
        apply_warning_word(word, hidden_);
    }
    input_.color = use_color(arguments, stdout);
    input_.tool_version = driver::tool_version();
}

void CheckReport::apply_options(diagnostic::Findings& findings) const {
    findings.hide(hidden_);
    if (arguments_.given("--werror")) {
        findings.promote_warnings();
    }
}

void CheckReport::add(diagnostic::FileReport file, bool unreadable,
                      std::map<std::string, std::string>&& sources) {
    const int exit_code = unreadable ? exit_environment : has_error(file) ? exit_findings : exit_fine;
    exit_code_ = worse(exit_code_, exit_code);
    if (!file.findings.empty()) {
        input_.sources.merge(std::move(sources));
    }
    input_.files.push_back(std::move(file));
}

int CheckReport::print() {
    const diagnostic::Renderer* renderer = diagnostic::find_renderer(arguments_.value("--format"));
    return cli::print(renderer->render(input_)) ? exit_code_ : exit_environment;
}

}  // namespace cgw::cli
