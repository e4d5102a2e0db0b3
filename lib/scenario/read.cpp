#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "diagnostic/rules/files.hpp"
#include "diagnostic/rules/keys.hpp"
#include "diagnostic/rules/scenarios.hpp"
#include "scenario/actions.hpp"
#include "scenario/read_value.hpp"
#include "toml/document.hpp"

namespace cgw::scenario {
namespace {

namespace rules = diagnostic::rules;
using toml::Entry;
using toml::Node;

const Key* find_key(std::span<const Key> keys, std::string_view name) {
    const auto found =
        std::find_if(keys.begin(), keys.end(), [name](const Key& key) { return key.name == name; });
    return found == keys.end() ? nullptr : &*found;
}

std::vector<std::string_view> names_of(std::span<const Key> keys) {
    std::vector<std::string_view> names;
    std::transform(keys.begin(), keys.end(), std::back_inserter(names),
                   [](const Key& key) { return key.name; });
    return names;
}

std::vector<std::string_view> action_names() {
    std::vector<std::string_view> names;
    std::transform(actions().begin(), actions().end(), std::back_inserter(names),
                   [](const Action& action) { return action.key.name; });
    return names;
}

void report_unknown(const Reader& reader, const Entry& entry, std::string_view place,
                    std::span<const std::string_view> known) {
    reader.report(rules::key_unknown, entry.key_range,
                  fmt::format("unknown key {} {}", toml::quoted(entry.key), place),
                  did_you_mean(entry.key, known));
}

void report_missing(const Reader& reader, const Node& node, std::span<const Key> keys,
                    std::string_view place) {
    const std::vector<std::string_view> names = names_of(keys);
    for (const Key& key : keys) {
        const bool misspelt = std::any_of(node.entries.begin(), node.entries.end(), [&](const Entry& entry) {
            return find_key(keys, entry.key) == nullptr &&
                   did_you_mean(entry.key, names) == fmt::format("did you mean `{}`?", key.name);
        });
        if (key.required && node.find(key.name) == nullptr && !misspelt) {
            reader.report(rules::key_missing, node.range, fmt::format("`{}` is missing {}", key.name, place));
        }
    }
}

// --- one step ---

// The entry that names the action; nullptr after a finding.
const Entry* choose_action(const Reader& reader, const Node& node) {
    const Entry* chosen = nullptr;
    bool unknown = false;
    for (const Entry& entry : node.entries) {
        if (find_action(entry.key) == nullptr) {
            unknown = unknown || find_key(step_keys(), entry.key) == nullptr;
        } else if (chosen == nullptr) {
            chosen = &entry;
        } else {
            reader.findings.report({&rules::step_action,
                                    fmt::format("this step has two actions, {} and {}",
                                                toml::quoted(chosen->key), toml::quoted(entry.key)),
                                    {reader.path, entry.key_range},
                                    {{{reader.path, chosen->key_range}, "the first one is here"}},
                                    "give each action a step of its own"});
            return nullptr;
        }
    }
    if (chosen == nullptr && !unknown) {
        reader.report(rules::step_action, node.range, "this step has no action");
    }
    if (chosen == nullptr && unknown) {
        for (const Entry& entry : node.entries) {
            if (find_key(step_keys(), entry.key) == nullptr) {
                report_unknown(reader, entry, "in a step", action_names());
                break;  // what belongs to it has no meaning without it
            }
        }
    }
    return chosen;
}

bool read_time(const Reader& reader, const Node& node, Step& step) {
    const Key& key = step_keys().front();
    const Entry* at = node.find(key.name);
    if (at == nullptr) {
        reader.report(rules::key_missing, node.range, "`at` is missing in a step");
        return false;
    }
    Value value;
    step.where = at->value.range;
    const bool read = read_value(reader, *at, key, value);
    step.at = static_cast<Time>(value.integer);
    return read;
}

// False when the step cannot be run.
bool read_step(const Reader& reader, const Node& node, Step& step) {
    if (node.kind != toml::Kind::table) {
        reader.report(rules::key_type, node.range,
                      fmt::format("a step must be a table, not {}", toml::to_text(node.kind)));
        return false;
    }
    bool right = read_time(reader, node, step);
    const Entry* chosen = choose_action(reader, node);
    if (chosen == nullptr) {
        return false;
    }
    step.action = find_action(chosen->key);
    const std::span<const Key> further = step.action->further;
    right = read_value(reader, *chosen, step.action->key, step.values[0]) && right;
    for (const Entry& entry : node.entries) {
        if (&entry == chosen || find_key(step_keys(), entry.key) != nullptr) {
            continue;
        }
        const Key* key = find_key(further, entry.key);
        if (key == nullptr) {
            report_unknown(reader, entry, fmt::format("in a step with `{}`", chosen->key), names_of(further));
            right = false;
            continue;
        }
        right = read_value(reader, entry, *key,
                           step.values[1 + static_cast<std::size_t>(key - further.data())]) &&
                right;
    }
    const std::size_t before = reader.findings.all().size();
    report_missing(reader, node, further, fmt::format("in a step with `{}`", chosen->key));
    return right && reader.findings.all().size() == before;
}

// --- the file ---

bool check_format(const Reader& reader, const Node& document) {
    const Entry* format = document.find("format");
    if (format == nullptr) {
        reader.report(rules::format_missing, document.range, "the file does not say its format",
                      fmt::format("begin it with format = {}", scenario_format));
        return true;
    }
    const Node& value = format->value;
    if (value.kind != toml::Kind::integer || value.integer == scenario_format) {
        return true;
    }
    reader.report(rules::format_unsupported, value.range,
                  fmt::format("the scenario is written in format {}, and this cgw reads format {}",
                              value.text, scenario_format));
    return false;
}

void read_top(const Reader& reader, const Node& document, Scenario& scenario) {
    for (const Entry& entry : document.entries) {
        const Key* key = find_key(file_keys(), entry.key);
        if (key == nullptr) {
            report_unknown(reader, entry, "at the top of a scenario", names_of(file_keys()));
            continue;
        }
        Value value;
        if (!read_value(reader, entry, *key, value)) {
            continue;
        }
        if (key->name == "title") {
            scenario.title = value.text;
        } else if (key->name == "plant") {
            scenario.plant = value.text;
        } else if (key->name == "governor") {
            scenario.governor = value.text;
        } else if (key->name == "duration") {
            scenario.duration = static_cast<Time>(value.integer);
        }
    }
    report_missing(reader, document, file_keys(), "at the top of a scenario");
}

void check_times(const Reader& reader, const Scenario& scenario) {
    Time before = 0;
    for (const Step& step : scenario.steps) {
        if (step.at < before) {
            reader.report(rules::step_time, step.where, "this step is earlier than the one before it");
        } else if (scenario.duration != 0 && step.at > scenario.duration) {
            reader.report(rules::step_time, step.where,
                          fmt::format("this step is later than the end of the scenario, {} s",
                                      static_cast<double>(scenario.duration) / 1e6),
                          "let `duration` be longer");
        }
        before = std::max(before, step.at);
    }
}

void read_steps(const Reader& reader, const Node& document, Scenario& scenario) {
    const Entry* steps = document.find("step");
    if (steps == nullptr || steps->value.kind != toml::Kind::array) {
        return;
    }
    const std::vector<Node>& elements = steps->value.elements;
    if (elements.size() > maximum_steps) {
        reader.report(rules::key_value, elements[maximum_steps].range,
                      fmt::format("the scenario has {} steps, more than {}", elements.size(), maximum_steps));
        return;
    }
    for (const Node& element : elements) {
        Step step;
        if (read_step(reader, element, step)) {
            scenario.steps.push_back(std::move(step));
        }
    }
    check_times(reader, scenario);
}

// An answer needs a question at an earlier time.
void check_answers(const Reader& reader, const Scenario& scenario) {
    std::optional<Time> asked;
    for (const Step& step : scenario.steps) {
        const std::string_view name = step.action->key.name;
        if (name == "upload" || name == "write") {
            asked = step.at;
        } else if ((name == "expect-answer" || name == "expect-abort") && (!asked || *asked >= step.at)) {
            reader.report(
                rules::step_answer, step.where,
                fmt::format("no `upload` or `write` comes before this `{}`, at an earlier time", name));
        }
    }
}

}  // namespace

Scenario read_scenario(std::string_view text, const std::string& path, diagnostic::Findings& findings) {
    Scenario scenario;
    scenario.path = path;
    const Reader reader{path, findings};
    const std::optional<Node> document = toml::parse(text, path, findings);
    if (document && check_format(reader, *document)) {
        read_top(reader, *document, scenario);
        read_steps(reader, *document, scenario);
        if (!findings.has_errors()) {
            check_answers(reader, scenario);
        }
    }
    return scenario;
}

}  // namespace cgw::scenario
