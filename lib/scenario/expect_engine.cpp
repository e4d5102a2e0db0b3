// What is expected of the engine, its alarms, and the engine state on the bus.
#include <fmt/format.h>

#include <vector>

#include "scenario/act.hpp"
#include "scenario/engine_values.hpp"
#include "scenario/range.hpp"
#include "scenario/run.hpp"
#include "simulation/engine_state_word.hpp"
#include "wire/little_endian.hpp"

namespace cgw::scenario {
namespace {

using simulation::AlarmRow;
using simulation::EngineAlarms;

constexpr std::size_t engine_state_position = 2;  // of TPDO3 in the image

std::string alarm_list(const EngineAlarms& alarms) {
    std::vector<std::string_view> texts;
    for (const AlarmRow& row : simulation::alarm_rows()) {
        if (alarms.present(row.alarm)) {
            texts.push_back(row.text);
        }
    }
    return fmt::format("{}", fmt::join(texts, ", "));
}

const EngineAlarms& alarms_of(Run& run) {
    return run.installation().plant().governor().alarms();
}

const AlarmRow& alarm_of(const Step& step) {
    return simulation::alarm_rows()[static_cast<std::size_t>(step.subject().integer)];
}

std::vector<Word> alarm_names() {
    std::vector<Word> all;
    for (const AlarmRow& row : simulation::alarm_rows()) {
        all.push_back({row.name, row.text});
    }
    return all;
}

}  // namespace

std::span<const Word> alarm_words() {
    static const std::vector<Word> words = alarm_names();
    return words;
}

std::span<const Word> alarm_or_any_words() {
    static const std::vector<Word> words = [] {
        std::vector<Word> all = alarm_names();
        all.push_back({"any", ""});
        return all;
    }();
    return words;
}

std::span<const Word> status_words() {
    static const std::vector<Word> words = [] {
        std::vector<Word> all;
        for (const simulation::EngineStateBit& bit : simulation::engine_state_bits()) {
            all.push_back({bit.name, bit.text});
        }
        return all;
    }();
    return words;
}

Outcome expect_engine(Run& run, const Step& step) {
    const EngineValue& row = engine_values()[static_cast<std::size_t>(step.subject().integer)];
    const double value = row.value(run.installation().plant().governor().engine().state());
    return {fmt::format("engine {} {}", row.name, range_text(step, row.unit)), in_range(step, value),
            fmt::format("it is {:.{}f} {}", value, row.decimals, row.unit)};
}

Outcome expect_alarm(Run& run, const Step& step) {
    const EngineAlarms& alarms = alarms_of(run);
    return {fmt::format("alarm {}", alarm_of(step).text), alarms.present(alarm_of(step).alarm),
            alarms.any() ? fmt::format("there is only {}", alarm_list(alarms)) : "there is none"};
}

Outcome expect_no_alarm(Run& run, const Step& step) {
    const EngineAlarms& alarms = alarms_of(run);
    if (static_cast<std::size_t>(step.subject().integer) == simulation::alarm_count) {
        return {"no alarm", !alarms.any(), fmt::format("there is {}", alarm_list(alarms))};
    }
    return {fmt::format("no alarm {}", alarm_of(step).text), !alarms.present(alarm_of(step).alarm),
            "it is there"};
}

Outcome expect_status(Run& run, const Step& step) {
    const simulation::EngineStateBit& bit =
        simulation::engine_state_bits()[static_cast<std::size_t>(step.subject().integer)];
    const bool wanted = step.values[1].integer != 0;
    Outcome outcome{fmt::format("TPDO3 says {}{}", wanted ? "" : "not ", bit.name)};
    const image::Pdo pdo = run.installation().image().pdo(engine_state_position);
    const auto last = run.installation().node().received(pdo.cob_id);
    if (!last) {
        outcome.met = false;
        outcome.instead = "not received";
        return outcome;
    }
    const std::uint16_t word = wire::load_u16(last->last.data.data());
    outcome.met = ((word & bit.mask) != 0) == wanted;
    outcome.instead = fmt::format("its word is 0x{:02X}", word);
    return outcome;
}

std::string status_not_sent(const image::Image& image, const Step&) {
    return image.pdo(engine_state_position).active ? "" : "TPDO3 is not active in this plant";
}

}  // namespace cgw::scenario
