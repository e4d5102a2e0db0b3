// What the steps name, looked up in the image of the plant they are for.
#include <fmt/format.h>

#include <utility>
#include <vector>

#include "base/ascii.hpp"
#include "diagnostic/rules/scenarios.hpp"
#include "facts/gateway.hpp"
#include "scenario/actions.hpp"
#include "scenario/read_value.hpp"
#include "simulation/plc.hpp"

namespace cgw::scenario {
namespace {

namespace rules = diagnostic::rules;

// Something that has a number and names by which people call it.
struct Candidate {
    std::uint16_t number = 0;
    std::string_view name;
    std::string_view other_name{};  // of a sensor: its measurement's
};

std::string_view name_of(const image::Image& image, std::uint16_t number) {
    image::Label label;
    return image.find_label(number, label) ? label.name : "";
}

std::vector<Candidate> sensors(const image::Image& image) {
    std::vector<Candidate> all;
    for (std::size_t i = 0; i < image.sensor_count(); ++i) {
        const std::uint16_t number = image.sensor(i).number;
        all.push_back({number, name_of(image, number), name_of(image, facts::measurement_of(number))});
    }
    return all;
}

std::vector<Candidate> switches(const image::Image& image) {
    std::vector<Candidate> all;
    for (std::size_t i = 0; i < image.switch_count(); ++i) {
        const std::uint16_t number = image.switch_function(i).number;
        all.push_back({number, name_of(image, number)});
    }
    return all;
}

std::vector<Candidate> measurements(const image::Image& image) {
    std::vector<Candidate> all;
    for (std::size_t position = 0; position < facts::tpdo_count; ++position) {
        const image::Pdo pdo = image.pdo(position);
        for (std::size_t word = 0; pdo.active && word < pdo.word_count; ++word) {
            if (const std::uint16_t number = pdo.mapping[word].parameter; number != 0) {
                all.push_back({number, name_of(image, number)});
            }
        }
    }
    return all;
}

// A kind of thing that a plant has or has not.
struct Family {
    Kind kind;
    std::vector<Candidate> (*candidates)(const image::Image&);
    std::string_view missing;  // behind its number or name
    std::string_view advice;
};

constexpr Family families[] = {
    {Kind::sensor, sensors, "is no sensor that comes over CANopen in this plant", "sensors"},
    {Kind::switch_function, switches, "is no switch function that comes over CANopen in this plant",
     "switch functions"},
    {Kind::measurement, measurements, "is in no active TPDO of this plant", "words of TPDOs"},
};

std::string list_of(const std::vector<Candidate>& candidates) {
    std::vector<std::string> texts;
    texts.reserve(candidates.size());
    for (const Candidate& candidate : candidates) {
        texts.push_back(candidate.name.empty() ? fmt::format("{}", candidate.number)
                                               : fmt::format("{} {}", candidate.number, candidate.name));
    }
    return fmt::format("{}", fmt::join(texts, ", "));
}

void bind_named(const Reader& reader, const Family& family, const image::Image& image, Value& value) {
    const std::vector<Candidate> candidates = family.candidates(image);
    const std::string wanted = base::lowered(value.text);
    std::vector<std::string_view> names;
    names.reserve(2 * candidates.size());
    for (const Candidate& candidate : candidates) {
        const std::string number = fmt::format("{}", candidate.number);
        const std::string name = base::lowered(candidate.name);
        const bool called_so = wanted == name || wanted == number ||
                               wanted == fmt::format("{} {}", number, name) ||
                               wanted == base::lowered(candidate.other_name);
        if (value.text.empty() ? candidate.number == value.integer : called_so) {
            value.integer = candidate.number;
            return;
        }
        names.push_back(candidate.name);
        names.push_back(candidate.other_name);
    }
    std::erase(names, "");
    std::string help = value.text.empty() ? "" : did_you_mean(value.text, names);
    if (help.empty()) {
        help = candidates.empty() ? fmt::format("it has no {}", family.advice)
                                  : fmt::format("its {} are {}", family.advice, list_of(candidates));
    }
    const std::string what = value.text.empty() ? fmt::format("{}", value.integer) : toml::quoted(value.text);
    reader.report(rules::step_subject, value.where, fmt::format("{} {}", what, family.missing),
                  std::move(help));
}

void bind_tpdo(const Reader& reader, const image::Image& image, const Value& value) {
    if (!image.pdo(static_cast<std::size_t>(value.integer - 1)).active) {
        reader.report(rules::step_subject, value.where,
                      fmt::format("TPDO{} is not active in this plant", value.integer));
    }
}

// Position in the list of words: RPDO1..4, the heartbeat, all.
void bind_source(const Reader& reader, const image::Image& image, const Value& value) {
    const auto source = static_cast<std::size_t>(value.integer);
    if (source < facts::rpdo_count && !image.pdo(facts::tpdo_count + source).active) {
        reader.report(rules::step_subject, value.where,
                      fmt::format("RPDO{} is not active in this plant", source + 1));
    } else if (source == facts::rpdo_count && image.heartbeat().consumer_us == 0) {
        reader.report(rules::step_subject, value.where, "the gateway watches no heartbeat in this plant");
    }
}

void bind_value(const Reader& reader, const image::Image& image, Kind kind, Value& value) {
    if (!value.given) {
        return;
    }
    for (const Family& family : families) {
        if (family.kind == kind) {
            bind_named(reader, family, image, value);
        }
    }
    if (kind == Kind::tpdo) {
        bind_tpdo(reader, image, value);
    } else if (kind == Kind::source) {
        bind_source(reader, image, value);
    }
}

}  // namespace

void bind(Scenario& scenario, const image::Image& image, diagnostic::Findings& findings) {
    const Reader reader{scenario.path, findings};
    for (Step& step : scenario.steps) {
        const Action& action = *step.action;
        const std::size_t before = findings.all().size();
        bind_value(reader, image, action.key.kind, step.values[0]);
        for (std::size_t i = 0; i < action.further.size(); ++i) {
            bind_value(reader, image, action.further[i].kind, step.values[i + 1]);
        }
        if (action.mistake == nullptr || findings.all().size() != before) {
            continue;
        }
        if (std::string mistake = action.mistake(image, step); !mistake.empty()) {
            const Value& last = step.values[1].given ? step.values[1] : step.values[2];
            reader.report(rules::step_value, last.where, std::move(mistake));
        }
    }
}

}  // namespace cgw::scenario
