// The table of what a step can do or expect. Reading, messages, running and docs/scenarios.md derive from it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "scenario/scenario.hpp"

namespace cgw::scenario {

class Run;

// What a value is, and how it is looked up.
enum class Kind : std::uint8_t {
    text,
    integer,
    number,
    seconds,
    boolean,
    word,             // one of `words`
    sensor,           // 9nn that comes over CANopen, by number or name
    switch_function,  // 8nn, likewise
    measurement,      // carried by an active TPDO, by number or name
    tpdo,             // active
    source,           // an RPDO that is active, the heartbeat if it is watched
    error,            // 3000..3095 or 12411..12424, by number or by the gateway's name
    error_or_any,     // or "any"
    object,           // "1018h:1", "2005h"
    steps,            // the list of steps
};

// "a sensor", "a number of seconds", for messages and docs.
std::string_view to_text(Kind kind);

struct Word {
    std::string_view name;
    std::string_view text;
};

struct Key {
    std::string_view name;
    Kind kind;
    std::string_view text;  // what it means, one line
    bool required = false;
    double minimum = 0;  // of integers, numbers and seconds, where minimum < maximum
    double maximum = 0;
    std::span<const Word> (*words)() = nullptr;
    std::string_view preset{};  // as TOML writes it: what holds when it is absent
};

// What came of a step, in words: "RPDO2 is silent", or "the gateway is Operational".
struct Outcome {
    std::string text;
    bool met = true;        // an expectation's
    std::string instead{};  // what was found when it is not
};

struct Action {
    Key key;  // its name is the action's
    std::span<const Key> further;
    bool expects;
    Outcome (*run)(Run& run, const Step& step);
    // What cannot be seen from one key alone; "" when it is right. After binding.
    std::string (*mistake)(const image::Image& image, const Step& step) = nullptr;
};

std::span<const Action> actions();
const Action* find_action(std::string_view name);

// Keys of the file itself, and those that every step has.
std::span<const Key> file_keys();
std::span<const Key> step_keys();

// docs/scenarios.md.
std::string page();

}  // namespace cgw::scenario
