// E04: notes, what the devices make of a setting.
#include "diagnostic/rules/notes.hpp"

namespace cgw::diagnostic::rules {

const Rule manual_misprint{
    .code = "E0401",
    .name = "manual-misprint",
    .level = Level::note,
    .summary = "a key is not one of the manual's misprints",
    .reference = "D2, D10",
    .why =
        "The manual's examples print three keys wrong. They are understood, but DcDesk shows the right "
        "number or name, and that is where it is to be entered.",
    .bad =
        "[governor.parameters]\n"
        "# 416 = 250\n"
        "\"409 CanBaudrate\" = 250\n",
    .good =
        "[governor.parameters]\n"
        "416 = 250                           # CanBaudrate\n"};
const Rule time_quantised{
    .code = "E0402",
    .name = "time-quantised",
    .level = Level::note,
    .summary = "a time is a whole number of main cycles",
    .reference = "GWM 7.1.3, 7.2.3, D8",
    .why =
        "The governor counts in cycles of 15.625 ms, the gateway in 16 ms. The telegram comes a little "
        "earlier than typed, which matters for a bus load worked out by hand. EDS and tables show the "
        "effective time.",
    .bad =
        "[gateway.parameters]\n"
        "429 = 1000                          # in effect 992 ms\n",
    .good =
        "[gateway.parameters]\n"
        "429 = 1008\n"};
const Rule tpdo_words_moved{
    .code = "E0403",
    .name = "tpdo-words-moved",
    .level = Level::note,
    .summary = "a word is sent in the place where it is typed",
    .reference = "GWM 7.1.2.2, D23",
    .why =
        "The governor leaves no gaps: words after a 0 move up. A receiver that was set up from the list of "
        "parameters reads the wrong word.",
    .bad =
        "[governor.parameters]\n"
        "16400 = [2000, 0, 2031]             # 2031 is sent as word 2\n"
        "16460 = 125\n",
    .good =
        "[governor.parameters]\n"
        "16400 = [2000, 2031]\n"
        "16460 = 125\n"};
const Rule cob_id_unlisted_owner{
    .code = "E0404",
    .name = "cob-id-unlisted-owner",
    .level = Level::note,
    .summary = "an active PDO has no identifier that another node would have by default",
    .reference = "D33",
    .why =
        "If the node exists and keeps its default identifiers, both send under the same one. The list of "
        "nodes in [network] lets cgw tell whether it exists.",
    .bad =
        "[governor.parameters]\n"
        "16404 = [2000]                      # TPDO5\n"
        "16461 = 125\n"
        "[gateway.parameters]\n"
        "16404 = 0x282                       # node 2's TPDO2\n",
    .good =
        "[governor.parameters]\n"
        "16404 = [2000]                      # TPDO5\n"
        "16461 = 125\n"
        "[gateway.parameters]\n"
        "16404 = 0x680\n"};
const Rule cob_id_default_rpdo{
    .code = "E0405",
    .name = "cob-id-default-rpdo",
    .level = Level::note,
    .summary = "an active PDO is received by no other node by default",
    .reference = "D33",
    .why =
        "A node that exists and keeps its default identifiers takes these values as its own input. PDOs are "
        "linked this way on purpose; without a purpose it is an accident.",
    .bad =
        "[governor.parameters]\n"
        "16404 = [2000]                      # TPDO5\n"
        "16461 = 125\n"
        "[gateway.parameters]\n"
        "16404 = 0x202                       # node 2's RPDO1\n",
    .good =
        "[governor.parameters]\n"
        "16404 = [2000]                      # TPDO5\n"
        "16461 = 125\n"
        "[gateway.parameters]\n"
        "16404 = 0x680\n"};
const Rule hzm_bit_rate_unverified{
    .code = "E0406",
    .name = "hzm-bit-rate-unverified",
    .level = Level::note,
    .summary = "the bit rates on the HEINZMANN CAN bus can be compared",
    .reference = "GWM 7.1.1, D17",
    .why =
        "With bit timing set by hand the rate depends on the clock of the controller, which the manual does "
        "not give for the governor. Compare both devices on the plant before the first start.",
    .bad =
        "[governor.parameters]\n"
        "4416 = 1\n",
    .good =
        "[governor.parameters]\n"
        "4416 = 0\n"};

}  // namespace cgw::diagnostic::rules
