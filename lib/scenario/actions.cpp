#include "scenario/actions.hpp"

#include <algorithm>
#include <array>

#include "facts/gateway.hpp"
#include "scenario/act.hpp"

namespace cgw::scenario {
namespace {

constexpr double longest = longest_duration;
constexpr double greatest_u32 = 4294967295.0;
constexpr double greatest_identifier = 0x1FFFFFFF;

constexpr Key top_keys[] = {
    {.name = "format",
     .kind = Kind::integer,
     .text = "version of this file format, 1",
     .required = true,
     .minimum = scenario_format,
     .maximum = scenario_format},
    {.name = "title", .kind = Kind::text, .text = "what the scenario shows, one line"},
    {.name = "plant",
     .kind = Kind::text,
     .text = "parameter file of the plant, relative to this file; used when none is given"},
    {.name = "governor",
     .kind = Kind::text,
     .text = "parameter file that the governor was set up with, if it is another than the gateway's"},
    {.name = "duration",
     .kind = Kind::seconds,
     .text = "how long the scenario lasts",
     .required = true,
     .minimum = 0.001,
     .maximum = longest},
    {.name = "step", .kind = Kind::steps, .text = "what happens, in the order of time"},
};

constexpr Key every_step[] = {
    {.name = "at",
     .kind = Kind::seconds,
     .text = "when the step takes place, since power-up",
     .required = true,
     .minimum = 0,
     .maximum = longest},
};

constexpr Key set_keys[] = {
    {.name = "to",
     .kind = Kind::number,
     .text = "value in the sensor's unit, without scaling in % of its range",
     .required = true},
};
constexpr Key switch_keys[] = {
    {.name = "on",
     .kind = Kind::boolean,
     .text = "whether the function is active; low-active bits are inverted",
     .required = true},
};
constexpr Key nmt_keys[] = {
    {.name = "to",
     .kind = Kind::word,
     .text = "whom the command is for",
     .words = addressee_words,
     .preset = "\"gateway\""},
};
constexpr Key write_keys[] = {
    {.name = "value",
     .kind = Kind::integer,
     .text = "what is written",
     .required = true,
     .minimum = 0,
     .maximum = greatest_u32},
    {.name = "bytes",
     .kind = Kind::integer,
     .text = "length of the value: 1, 2 or 4",
     .minimum = 1,
     .maximum = 4,
     .preset = "2"},
};
constexpr Key saturate_keys[] = {
    {.name = "id",
     .kind = Kind::integer,
     .text = "identifier of the frames; 29 bits above 0x7FF",
     .required = true,
     .minimum = 0,
     .maximum = greatest_identifier},
    {.name = "for",
     .kind = Kind::seconds,
     .text = "how long",
     .required = true,
     .minimum = 0.001,
     .maximum = longest},
};
constexpr Key range_keys[] = {
    {.name = "min", .kind = Kind::number, .text = "least value; without it there is none"},
    {.name = "max", .kind = Kind::number, .text = "greatest value; without it there is none"},
};
constexpr Key status_keys[] = {
    {.name = "on", .kind = Kind::boolean, .text = "whether the bit is set", .required = true},
};
constexpr Key within_keys[] = {
    {.name = "within",
     .kind = Kind::seconds,
     .text = "in how long a time before the step",
     .required = true,
     .minimum = 0.001,
     .maximum = longest},
};

constexpr std::array table{
    // What the PLC does
    Action{{.name = "set", .kind = Kind::sensor, .text = "the PLC sends another value of a sensor"},
           set_keys,
           false,
           set_sensor,
           sensor_cannot_be},
    Action{{.name = "switch", .kind = Kind::switch_function, .text = "the PLC switches a function on or off"},
           switch_keys,
           false,
           set_switch},
    Action{{.name = "fail",
            .kind = Kind::sensor,
            .text = "the PLC flags a sensor as faulty, in word 3 of RPDO1"},
           {},
           false,
           fail_sensor},
    Action{{.name = "repair", .kind = Kind::sensor, .text = "the PLC takes the flag back"},
           {},
           false,
           repair_sensor},
    Action{{.name = "silence",
            .kind = Kind::source,
            .text = "the PLC stops sending this",
            .words = source_words},
           {},
           false,
           silence},
    Action{
        {.name = "resume", .kind = Kind::source, .text = "the PLC sends this again", .words = source_words},
        {},
        false,
        resume},
    Action{
        {.name = "nmt", .kind = Kind::word, .text = "the PLC gives an NMT command", .words = command_words},
        nmt_keys,
        false,
        command},
    Action{{.name = "upload", .kind = Kind::object, .text = "the PLC reads an object by SDO"},
           {},
           false,
           upload},
    Action{{.name = "write", .kind = Kind::object, .text = "the PLC writes an object by SDO"},
           write_keys,
           false,
           write,
           value_too_long},
    // What happens to the plant
    Action{{.name = "drop",
            .kind = Kind::word,
            .text = "a bus is cut: nothing goes through, and the gateway's controller says so",
            .words = bus_words},
           {},
           false,
           drop},
    Action{{.name = "restore", .kind = Kind::word, .text = "the bus is mended", .words = bus_words},
           {},
           false,
           restore},
    Action{{.name = "reset",
            .kind = Kind::word,
            .text = "the supply of a device is interrupted",
            .words = device_words},
           {},
           false,
           reset},
    Action{{.name = "saturate",
            .kind = Kind::word,
            .text = "somebody sends one frame as fast as the bus carries it",
            .words = bus_words},
           saturate_keys,
           false,
           saturate},
    Action{{.name = "fault", .kind = Kind::word, .text = "a fault appears at a device", .words = fault_words},
           {},
           false,
           report_fault},
    Action{{.name = "mend", .kind = Kind::word, .text = "the fault is gone", .words = fault_words},
           {},
           false,
           mend_fault},
    Action{{.name = "clear",
            .kind = Kind::word,
            .text = "errors are cleared at a device, which tells the other one",
            .words = device_words},
           {},
           false,
           clear_errors},
    // What is expected
    Action{{.name = "expect-state", .kind = Kind::word, .text = "state of the gateway", .words = state_words},
           {},
           true,
           expect_state},
    Action{{.name = "expect-error", .kind = Kind::error, .text = "an error that the gateway shows"},
           {},
           true,
           expect_error},
    Action{{.name = "expect-no-error",
            .kind = Kind::error_or_any,
            .text = "an error that it does not show; \"any\": it shows none at all"},
           {},
           true,
           expect_no_error},
    Action{{.name = "expect-word",
            .kind = Kind::measurement,
            .text = "a measurement as the PLC received it last, in its unit"},
           range_keys,
           true,
           expect_word,
           range_is_empty},
    Action{{.name = "expect-engine",
            .kind = Kind::word,
            .text = "a value of the engine itself",
            .words = engine_words},
           range_keys,
           true,
           expect_engine,
           range_is_empty},
    Action{{.name = "expect-alarm",
            .kind = Kind::word,
            .text = "an alarm of the engine, at the governor",
            .words = alarm_words},
           {},
           true,
           expect_alarm},
    Action{{.name = "expect-no-alarm",
            .kind = Kind::word,
            .text = "an alarm that is not there; \"any\": there is none at all",
            .words = alarm_or_any_words},
           {},
           true,
           expect_no_alarm},
    Action{{.name = "expect-status",
            .kind = Kind::word,
            .text = "a bit of the engine state as the PLC received it last in TPDO3",
            .words = status_words},
           status_keys,
           true,
           expect_status,
           status_not_sent},
    Action{{.name = "expect-tpdo",
            .kind = Kind::tpdo,
            .text = "the PLC received this TPDO",
            .minimum = 1,
            .maximum = facts::tpdo_count},
           within_keys,
           true,
           expect_tpdo},
    Action{{.name = "expect-no-tpdo",
            .kind = Kind::tpdo,
            .text = "it did not receive it",
            .minimum = 1,
            .maximum = facts::tpdo_count},
           within_keys,
           true,
           expect_no_tpdo},
    Action{{.name = "expect-heartbeat",
            .kind = Kind::word,
            .text = "the gateway's last heartbeat tells this state",
            .words = node_state_words},
           within_keys,
           true,
           expect_heartbeat},
    Action{{.name = "expect-boot-ups",
            .kind = Kind::integer,
            .text = "how often the PLC has heard the gateway's boot-up",
            .minimum = 0,
            .maximum = 1e6},
           {},
           true,
           expect_boot_ups},
    Action{{.name = "expect-answer",
            .kind = Kind::integer,
            .text = "the value that the last upload brought",
            .minimum = 0,
            .maximum = greatest_u32},
           {},
           true,
           expect_answer},
    Action{{.name = "expect-abort",
            .kind = Kind::integer,
            .text = "the abort code that the last upload or write brought",
            .minimum = 1,
            .maximum = greatest_u32},
           {},
           true,
           expect_abort},
};

static_assert(std::all_of(table.begin(), table.end(),
                          [](const Action& action) { return action.further.size() < maximum_values; }));

}  // namespace

std::string_view to_text(Kind kind) {
    switch (kind) {
        case Kind::text:
            return "a text";
        case Kind::integer:
            return "an integer";
        case Kind::number:
            return "a number";
        case Kind::seconds:
            return "a number of seconds";
        case Kind::boolean:
            return "true or false";
        case Kind::word:
        case Kind::source:
            return "a word in quotes";
        case Kind::sensor:
            return "a sensor, by number or name";
        case Kind::switch_function:
            return "a switch function, by number or name";
        case Kind::measurement:
            return "a measurement, by number or name";
        case Kind::tpdo:
            return "the number of a TPDO";
        case Kind::error:
            return "an error, by number or name";
        case Kind::error_or_any:
            return "an error, by number or name, or \"any\"";
        case Kind::object:
            return "an object, such as \"1018h:1\"";
        case Kind::steps:
            return "a list of steps";
    }
    return "";
}

std::span<const Action> actions() {
    return table;
}

const Action* find_action(std::string_view name) {
    const auto* const found = std::find_if(table.begin(), table.end(),
                                           [name](const Action& action) { return action.key.name == name; });
    return found == table.end() ? nullptr : &*found;
}

std::span<const Key> file_keys() {
    return top_keys;
}

std::span<const Key> step_keys() {
    return every_step;
}

}  // namespace cgw::scenario
