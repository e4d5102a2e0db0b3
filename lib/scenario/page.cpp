// docs/scenarios.md, made from the table of actions.
#include <fmt/format.h>

#include "base/numbers.hpp"
#include "base/text_cells.hpp"
#include "scenario/actions.hpp"
#include "simulation/alarms.hpp"

namespace cgw::scenario {
namespace {

constexpr std::string_view head =
    "<!-- Made from lib/scenario/. Changes here are lost; see ARCHITECTURE.md, \"Generated pages\". -->\n\n"
    "# Scenarios\n\n"
    "A scenario says what happens to a simulated plant, when, and what is to be seen then. `cgw simulate`\n"
    "runs it on the gateway of a parameter file, beside a simulated governor with its engine and a simple "
    "PLC:\n\n"
    "```\n"
    "cgw simulate --scenario samples/scenarios/cable-break.toml\n"
    "cgw simulate plant.toml --scenario mine.toml --log run.pcap\n"
    "```\n\n"
    "It exits 1 when something that was expected was not seen, so that a scenario can stand in a test. The\n"
    "same scenario and parameter file give the same frames at the same microsecond, at every `--speed`.\n\n"
    "```toml\n"
    "format = 1\n"
    "title = \"The PLC goes silent\"\n"
    "plant = \"../genset.toml\"\n"
    "duration = 12.0\n\n"
    "step = [\n"
    "  { at = 3.0, expect-state = \"operational\" },\n"
    "  { at = 5.0, silence = \"RPDO2\" },\n"
    "  { at = 5.6, expect-error = 12413 },\n"
    "  { at = 7.0, resume = \"RPDO2\" },\n"
    "  { at = 7.1, expect-no-error = \"any\" },\n"
    "]\n"
    "```\n\n"
    "Each step has a time and one action; further keys of the action stand beside it. Steps are written in "
    "the\n"
    "order of their times; those of the same time take place in the order of the file. `[[step]]` tables do "
    "as\n"
    "well as the list above. Findings about scenarios are E06 of [checks.md](checks.md).\n\n"
    "## What runs\n\n"
    "- The *PLC* on CAN2 sends every active RPDO at least twice within its monitoring time, and the "
    "heartbeat\n"
    "  of the partner (428) if it is watched. Its outputs are healthy until a step changes them: sensors as "
    "at\n"
    "  rated speed and 60 % load, load enabled, every other switch function off. 100 ms after each boot-up "
    "of\n"
    "  the gateway it sends NMT start.\n"
    "- The *governor* on CAN1 initialises the gateway, runs an engine and obeys switch functions and "
    "sensors.\n"
    "  It starts the engine by itself. Its engine is plausible, and no particular one.\n"
    "- The *gateway* is the one that `canopen-gateway` runs.\n\n"
    "The link between governor and gateway is our own protocol (D56,\n"
    "[governor-link.md](governor-link.md)). Bit timing that a file states by registers runs at 125 "
    "kbit/s.\n\n";

std::string code(std::string_view text) {
    return fmt::format("`{}`", text);
}

// More words than a cell can hold stand in a table of their own.
constexpr std::size_t most_words_in_a_cell = 6;

std::string words_of(const Key& key) {
    const std::span<const Word> words = key.words();
    if (words.size() > most_words_in_a_cell) {
        return "one of those below";
    }
    std::string text;
    for (const Word& word : words) {
        text += (text.empty() ? "" : ", ") + code(fmt::format("\"{}\"", word.name));
    }
    return text;
}

std::string value_text(const Key& key) {
    std::string text = key.words != nullptr ? words_of(key) : std::string(to_text(key.kind));
    if (key.minimum < key.maximum && key.maximum <= 0xFFFF) {
        text += fmt::format(", {}..{}", base::to_text(key.minimum), base::to_text(key.maximum));
    }
    return key.preset.empty() ? text : fmt::format("{}; default {}", text, code(key.preset));
}

std::string key_row(const Key& key) {
    return fmt::format("| {} | {} | {}{} |\n", code(key.name), base::markdown_cell(key.text), value_text(key),
                       key.required ? "" : "; may be left out");
}

std::string action_row(const Action& action) {
    std::string further;
    for (const Key& key : action.further) {
        further += fmt::format("{}{} {}: {}", further.empty() ? "" : "<br>", code(key.name), value_text(key),
                               base::markdown_cell(key.text));
    }
    return fmt::format("| {} | {} | {} | {} |\n", code(action.key.name), value_text(action.key),
                       base::markdown_cell(action.key.text), further);
}

std::string key_table(std::span<const Key> keys) {
    std::string table = "| key | meaning | value |\n| --- | --- | --- |\n";
    for (const Key& key : keys) {
        table += key_row(key);
    }
    return table + '\n';
}

std::string action_table(bool expects) {
    std::string table = "| action | its value | what happens | further keys |\n| --- | --- | --- | --- |\n";
    if (expects) {
        table = "| action | its value | what is expected | further keys |\n| --- | --- | --- | --- |\n";
    }
    for (const Action& action : actions()) {
        table += action.expects == expects ? action_row(action) : "";
    }
    return table + '\n';
}

std::string word_list(std::string_view action_name) {
    std::string list;
    for (const Word& word : find_action(action_name)->key.words()) {
        list += fmt::format("| {} | {} |\n", code(word.name), base::markdown_cell(word.text));
    }
    return list + '\n';
}

std::string alarm_table() {
    std::string table =
        "| alarm | meaning | rises | cause gone | stops the engine |\n| --- | --- | --- | --- | --- |\n";
    for (const simulation::AlarmRow& row : simulation::alarm_rows()) {
        const bool below = row.side == simulation::Side::below;
        table += fmt::format(
            "| {} | {} | {} {} {}{} | at {} {} | {} |\n", code(row.name), base::markdown_cell(row.text),
            below ? "below" : "above", base::to_text(row.limit), row.unit,
            row.delay == 0 ? ""
                           : fmt::format(" for {} s", base::to_text(static_cast<double>(row.delay) / 1e6)),
            base::to_text(row.released), row.unit, row.stops ? "yes" : "no");
    }
    return table + '\n';
}

}  // namespace

std::string page() {
    std::string text(head);
    text += "## The file\n\n" + key_table(file_keys());
    text += "Every step has:\n\n" + key_table(step_keys());
    text += "## Actions\n\n" + action_table(false);
    text +=
        "Sensors and switch functions are those that come over CANopen in this plant, by their number "
        "(`902`,\n"
        "`835`) or name (`\"AssignIn_Setp1Ext\"`); a sensor also by the name of its measurement. Values are "
        "in\n"
        "engineering units of the parameter file, or in % of the range where it states no scaling. A step "
        "that\n"
        "cannot be taken, such as an NMT command on a bus that is cut, counts as failed.\n\n"
        "`drop` is seen by the gateway's driver: 3070 for CAN1, 3072 for CAN2. While a bus is cut nobody "
        "can\n"
        "send on it, and the frame on the wire is lost. The fault `can1-bus` or `can2-bus` is another "
        "matter: it "
        "ends with\n"
        "`mend` only, and `mend` repairs no cable.\n\n"
        "Faults, until `mend`:\n\n| fault | meaning |\n| --- | --- |\n" +
        word_list("fault");
    text += "What they do to the gateway is in [errors.md](errors.md).\n\n";
    text += "## Expectations\n\n" + action_table(true);
    text +=
        "`expect-word` looks at what the PLC received in a TPDO, `expect-engine` at the engine itself. Its "
        "values:\n\n| value | unit |\n| --- | --- |\n" +
        word_list("expect-engine");
    text +=
        "The governor's alarms. Those of the oil pressure rise only once the engine has run for 3 s; the "
        "others "
        "end "
        "by\n"
        "themselves, but for those that stop the engine: they stay until errors are cleared while it stands "
        "and "
        "their\n"
        "cause is gone. Then it starts again.\n\n" +
        alarm_table();
    text +=
        "No manual prints an error number for them, so they are no errors (D48): they show in TPDO3, whose "
        "bits "
        "are\n"
        "those of this simulation, the least significant first:\n\n| bit | meaning |\n| --- | --- |\n" +
        word_list("expect-status");
    text.pop_back();
    return text;
}

}  // namespace cgw::scenario
