// E10: CAN databases (DBC).
#include "diagnostic/rules/dbc.hpp"

namespace cgw::diagnostic::rules {

const Rule dbc_text{
    .code = "E1001",
    .name = "dbc-text",
    .level = Level::error,
    .summary = "a CAN database is text with messages in it, every quote closed",
    .reference = "",
    .why =
        "Behind a quote that is not closed everything is one long text, messages and signals as well. A file "
        "without a single message is of another kind.",
    .example = Example::database,
    .bad =
        "BO_ 396 GW12_TPDO1: 8 GW12\n"
        "CM_ \"of the starboard engine\n",
    .good =
        "BO_ 396 GW12_TPDO1: 8 GW12\n"
        "CM_ \"of the starboard engine\";\n"};
const Rule dbc_statement{
    .code = "E1002",
    .name = "dbc-statement",
    .level = Level::error,
    .summary = "messages, signals and their attributes are written as the format has them",
    .reference = "",
    .why =
        "A signal that cannot be read is missing in every tool that passes over it, and the values of others "
        "are then taken for it.",
    .example = Example::database,
    .bad =
        "BO_ 396 GW12_TPDO1: 8 GW12\n"
        " SG_ Speed : 0|16@1+ (1,0) [0|4000] rpm Vector__XXX\n",
    .good =
        "BO_ 396 GW12_TPDO1: 8 GW12\n"
        " SG_ Speed : 0|16@1+ (1,0) [0|4000] \"rpm\" Vector__XXX\n"};
const Rule dbc_twice{.code = "E1003",
                     .name = "dbc-message-twice",
                     .level = Level::error,
                     .summary = "an identifier has one message in a CAN database",
                     .reference = "",
                     .why =
                         "Of two messages with one identifier some tools show the first and some the last. "
                         "cgw reads the first.",
                     .example = Example::database,
                     .bad =
                         "BO_ 396 GW12_TPDO1: 8 GW12\n"
                         "BO_ 396 Other: 4 GW12\n",
                     .good =
                         "BO_ 396 GW12_TPDO1: 8 GW12\n"
                         "BO_ 652 Other: 4 GW12\n"};

}  // namespace cgw::diagnostic::rules
