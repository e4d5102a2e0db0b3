// E06: scenario files.
#include "diagnostic/rules/scenarios.hpp"

namespace cgw::diagnostic::rules {

const Rule step_action{
    .code = "E0601",
    .name = "step-action",
    .level = Level::error,
    .summary = "a step of a scenario has exactly one action",
    .reference = "",
    .why =
        "Steps of the same time take place in the order of the file. Two actions in one step would have no "
        "order, and a step without one does nothing.",
    .example = Example::scenario,
    .bad =
        "[[step]]\n"
        "at = 2.0\n"
        "fail = 902\n"
        "silence = \"RPDO3\"\n",
    .good =
        "[[step]]\n"
        "at = 2.0\n"
        "fail = 902\n"
        "[[step]]\n"
        "at = 2.0\n"
        "silence = \"RPDO3\"\n"};
const Rule step_time{
    .code = "E0602",
    .name = "step-time",
    .level = Level::error,
    .summary = "the steps of a scenario stand in the order of their times, none after the end",
    .reference = "",
    .why =
        "A scenario is read from top to bottom. A step after its end would never take place, and what it "
        "expects would never be looked at.",
    .example = Example::scenario,
    .bad =
        "[[step]]\n"
        "at = 12.0\n"
        "expect-state = \"operational\"\n",
    .good =
        "[[step]]\n"
        "at = 2.0\n"
        "expect-state = \"operational\"\n"};
const Rule step_subject{
    .code = "E0603",
    .name = "step-subject",
    .level = Level::error,
    .summary = "a step names what this plant has on its CANopen bus",
    .reference = "D20, D25, D26",
    .why =
        "A sensor that does not come over CANopen, a PDO that is not active or a word that no TPDO carries "
        "cannot be moved or seen from the PLC's side: the step would do nothing.",
    .example = Example::scenario,
    .bad =
        "[[step]]\n"
        "at = 2.0\n"
        "set = 905\n"
        "to = 4.2\n",
    .good =
        "[[step]]\n"
        "at = 2.0\n"
        "set = 906\n"
        "to = 980\n"};
const Rule step_value{
    .code = "E0604",
    .name = "step-value",
    .level = Level::error,
    .summary = "a step's value is one that its word can hold, and a range has a least and a greatest value",
    .reference = "",
    .why =
        "What a word cannot hold would be sent as the nearest value it can, and a range whose ends are the "
        "wrong way round is never met.",
    .example = Example::scenario,
    .bad =
        "[[step]]\n"
        "at = 2.0\n"
        "expect-engine = \"speed\"\n"
        "min = 1600\n"
        "max = 1400\n",
    .good =
        "[[step]]\n"
        "at = 2.0\n"
        "expect-engine = \"speed\"\n"
        "min = 1400\n"
        "max = 1600\n"};
const Rule step_answer{
    .code = "E0605",
    .name = "step-answer",
    .level = Level::error,
    .summary = "the answer to a question is expected after the question",
    .reference = "",
    .why =
        "`expect-answer` and `expect-abort` look at what the last `upload` or `write` brought. Without one "
        "before them, at an earlier time, there is no answer.",
    .example = Example::scenario,
    .bad =
        "[[step]]\n"
        "at = 2.0\n"
        "expect-answer = 0x161\n",
    .good =
        "[[step]]\n"
        "at = 1.0\n"
        "upload = \"1018h:1\"\n"
        "[[step]]\n"
        "at = 2.0\n"
        "expect-answer = 0x161\n"};

}  // namespace cgw::diagnostic::rules
