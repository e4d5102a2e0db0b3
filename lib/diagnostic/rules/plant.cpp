// E02: what makes the plant fail.
#include "diagnostic/rules/plant.hpp"

namespace cgw::diagnostic::rules {

const Rule hzm_node_mismatch{
    .code = "E0201",
    .name = "hzm-node-mismatch",
    .level = Level::error,
    .summary = "each device knows the other by the node number it has",
    .reference = "GWM 7.1.1, 7.2.1",
    .why =
        "Each device talks only to the node number it was given for the other. With one of the four "
        "numbers wrong the two never find each other, and nothing appears on the CANopen bus.",
    .bad =
        "[governor.parameters]\n"
        "403 = 2                             # the gateway, as the governor knows it\n"
        "[gateway.parameters]\n"
        "401 = 3                             # the gateway's own number\n",
    .good =
        "[governor.parameters]\n"
        "403 = 3\n"
        "[gateway.parameters]\n"
        "401 = 3\n"};
const Rule hzm_bit_rate_mismatch{
    .code = "E0202",
    .name = "hzm-bit-rate-mismatch",
    .level = Level::error,
    .summary = "both devices use the same bit rate on the HEINZMANN CAN bus",
    .reference = "GWM 7.1.1, 7.2.1",
    .why =
        "Two bit rates on one bus destroy each other's telegrams; both controllers end in bus-off. The "
        "CANopen bus is another bus and may run at another rate.",
    .bad =
        "[governor.parameters]\n"
        "416 = 250\n"
        "[gateway.parameters]\n"
        "416 = 500\n",
    .good =
        "[governor.parameters]\n"
        "416 = 500\n"
        "[gateway.parameters]\n"
        "416 = 500\n"};
const Rule node_id_duplicate{
    .code = "E0203",
    .name = "node-id-duplicate",
    .level = Level::error,
    .summary = "the gateway and its partner have different node ids",
    .reference = "GWM 7.3, D14",
    .why =
        "The gateway would hear its own heartbeat as its partner's. The loss of the partner would never "
        "be noticed, and two nodes would answer the same SDO requests.",
    .bad =
        "[gateway.parameters]\n"
        "427 = 5\n"
        "428 = 5\n"
        "430 = 2000\n",
    .good =
        "[gateway.parameters]\n"
        "427 = 5\n"
        "428 = 1\n"
        "430 = 2000\n"};
const Rule node_id_listed{
    .code = "E0204",
    .name = "node-id-listed",
    .level = Level::error,
    .summary = "the gateway's node id is not the one of another node in [network]",
    .reference = "GWM 7.2.2",
    .why =
        "Two nodes with one id send the same identifiers with different contents. The bus reports errors "
        "at random moments, often only under load, and takes good nodes down too.",
    .bad =
        "[gateway.parameters]\n"
        "427 = 5\n"
        "[network]\n"
        "nodes = [2, 5]\n",
    .good =
        "[gateway.parameters]\n"
        "427 = 6\n"
        "[network]\n"
        "nodes = [2, 5]\n"};
const Rule cob_id_reserved{
    .code = "E0205",
    .name = "cob-id-reserved",
    .level = Level::error,
    .summary = "an active PDO does not use an identifier reserved for NMT, SYNC, TIME, SDO or heartbeat",
    .reference = "GWM 7.3, D33",
    .why =
        "Process data under such an identifier is read as a command or an answer by every node: under "
        "000h a measured value can stop the whole network.",
    .bad =
        "[governor.parameters]\n"
        "16404 = [2000]                      # TPDO5\n"
        "16461 = 125\n"
        "[gateway.parameters]\n"
        "16404 = 0x80                        # SYNC\n",
    .good =
        "[governor.parameters]\n"
        "16404 = [2000]                      # TPDO5\n"
        "16461 = 125\n"
        "[gateway.parameters]\n"
        "16404 = 0x680\n"};
const Rule cob_id_duplicate{
    .code = "E0206",
    .name = "cob-id-duplicate",
    .level = Level::error,
    .summary = "active PDOs have different identifiers",
    .reference = "GWM 7.3, D33",
    .why =
        "Receivers tell telegrams apart by the identifier alone. Two of them under one identifier are "
        "taken for each other: oil pressure shows up as speed.",
    .bad =
        "[governor.parameters]\n"
        "16404 = [2000]                      # TPDO5\n"
        "16408 = [2031]                      # TPDO6\n"
        "16461 = [125, 125]\n"
        "[gateway.parameters]\n"
        "16404 = [0x680, 0x680]\n",
    .good =
        "[governor.parameters]\n"
        "16404 = [2000]                      # TPDO5\n"
        "16408 = [2031]                      # TPDO6\n"
        "16461 = [125, 125]\n"
        "[gateway.parameters]\n"
        "16404 = [0x680, 0x681]\n"};
const Rule cob_id_foreign{
    .code = "E0207",
    .name = "cob-id-foreign",
    .level = Level::error,
    .summary = "an active PDO does not use an identifier that a node listed in [network] owns",
    .reference = "D33",
    .why =
        "The listed node sends under this identifier itself, or takes what arrives there for a request. "
        "Both sides then read the other's data.",
    .bad =
        "[governor.parameters]\n"
        "16404 = [2000]                      # TPDO5\n"
        "16461 = 125\n"
        "[gateway.parameters]\n"
        "16404 = 0x182                       # node 2's TPDO1\n"
        "[network]\n"
        "nodes = [2]\n",
    .good =
        "[governor.parameters]\n"
        "16404 = [2000]                      # TPDO5\n"
        "16461 = 125\n"
        "[gateway.parameters]\n"
        "16404 = 0x680\n"
        "[network]\n"
        "nodes = [2]\n"};
const Rule heartbeat_partner_missing{
    .code = "E0208",
    .name = "heartbeat-partner-missing",
    .level = Level::error,
    .summary = "heartbeat monitoring names the partner it monitors",
    .reference = "GWM 7.2.3, D14",
    .why =
        "A monitoring time without a partner monitors nobody. The plant looks protected against the loss "
        "of the master and is not.",
    .bad =
        "[gateway.parameters]\n"
        "428 = 0\n"
        "430 = 2000\n",
    .good =
        "[gateway.parameters]\n"
        "428 = 2\n"
        "430 = 2000\n"};
const Rule time_too_long{
    .code = "E0209",
    .name = "time-too-long",
    .level = Level::error,
    .summary = "a cycle or monitoring time is shorter than 256 governor main cycles",
    .reference = "GWM 7.1.3, D8",
    .why =
        "The governor counts these times in its main cycles and keeps the count in one byte. What does "
        "not fit is not what it will do.",
    .bad =
        "[governor.parameters]\n"
        "16400 = [2000]                      # TPDO4\n"
        "16460 = 4000\n",
    .good =
        "[governor.parameters]\n"
        "16400 = [2000]                      # TPDO4\n"
        "16460 = 2000\n"};
const Rule switch_bit_range{
    .code = "E0210",
    .name = "switch-bit-range",
    .level = Level::error,
    .summary = "a CANopen switch function uses bit 1..16 of RPDO1 word 1, negative when low-active",
    .reference = "GWM 7.1.4.1, D27",
    .why =
        "RPDO1 has one word of switches. A function on a bit beyond it never switches, whatever the "
        "master sends.",
    .bad =
        "[governor.parameters]\n"
        "835 = 17                            # FunctLoadEnable\n"
        "4835 = 3\n"
        "16480 = 500\n",
    .good =
        "[governor.parameters]\n"
        "835 = 16                            # FunctLoadEnable\n"
        "4835 = 3\n"
        "16480 = 500\n"};
const Rule sensor_channel_range{
    .code = "E0211",
    .name = "sensor-channel-range",
    .level = Level::error,
    .summary = "a CANopen sensor uses channel 1..12, the words of RPDO2..4",
    .reference = "GWM 7.1.4.2, D27",
    .why =
        "RPDO2 to RPDO4 have twelve words together. A sensor on a channel beyond them never gets a value "
        "and the governor works with its substitute.",
    .bad =
        "[governor.parameters]\n"
        "906 = 13                            # AssignIn_AmbPress\n"
        "4906 = 3\n",
    .good =
        "[governor.parameters]\n"
        "906 = 12                            # AssignIn_AmbPress\n"
        "4906 = 3\n"
        "16480 = [500, 0, 0, 500]\n"};
const Rule engine_stop_over_canopen{
    .code = "E0212",
    .name = "engine-stop-over-canopen",
    .level = Level::error,
    .summary = "engine stop is wired and never comes over CANopen",
    .reference = "GWM 7.1.4.1, D34",
    .why =
        "A stop that travels over a bus fails with the bus, with the master and with every plug between "
        "them. The manual forbids it: engine stop is a wire.",
    .bad =
        "[governor.parameters]\n"
        "810 = 4                             # engine stop\n"
        "4810 = 3\n",
    .good =
        "[governor.parameters]\n"
        "810 = 4                             # engine stop\n"
        "4810 = 0\n"};
const Rule tpdo_parameter_unknown{
    .code = "E0213",
    .name = "tpdo-parameter-unknown",
    .level = Level::error,
    .summary = "a parameter assigned to a TPDO is known with its width and sign",
    .reference = "GWM 7.1.2.2, D13",
    .why =
        "The governor leaves out a number it does not have, without a message, and the later words of "
        "that TPDO move up by one. Numbers differ between governor types, so cgw asks for a declaration.",
    .bad =
        "[governor.parameters]\n"
        "16400 = [2000, 2301]                # TPDO4\n"
        "16460 = 125\n",
    .good =
        "[governor.parameters]\n"
        "16400 = [2000, 2300]                # TPDO4\n"
        "16460 = 125\n"};
const Rule tpdo_parameter_bit{
    .code = "E0214",
    .name = "tpdo-parameter-bit",
    .level = Level::error,
    .summary = "a parameter assigned to a TPDO is not a single bit",
    .reference = "GWM 4.1.2, D13",
    .why =
        "TPDO4 to TPDO16 carry words. A single bit is left out and the later words move up; error bits "
        "and the engine state have TPDO1 to TPDO3 to themselves.",
    .bad =
        "[governor.parameters]\n"
        "16400 = [2000, 3070]                # 3070 is an error bit\n"
        "16460 = 125\n",
    .good =
        "[governor.parameters]\n"
        "16400 = [2000]\n"
        "16460 = 125\n"
        "14401 = 1                           # TPDO1 and TPDO2 carry the error bits\n"};
const Rule communication_off{
    .code = "E0215",
    .name = "communication-off",
    .level = Level::error,
    .summary = "both devices have their communication with each other switched on",
    .reference = "GWM 7.1.1, 7.2.1, D35",
    .why =
        "With 4400 or 4406 at 0 one of the two ignores the other. Everything else can be right, and still "
        "no value reaches the CANopen bus.",
    .bad =
        "[governor.parameters]\n"
        "4406 = 0                            # CanCommCMOn\n",
    .good =
        "[governor.parameters]\n"
        "4406 = 1                            # CanCommCMOn\n"};
const Rule bit_timing_impossible{
    .code = "E0216",
    .name = "bit-timing-impossible",
    .level = Level::error,
    .summary = "bit timing by hand keeps the rules of the CAN controller",
    .reference = "GWM 7.2.2, D7, D77",
    .why =
        "A controller that is given segments it cannot make does what its data sheet leaves open: it is "
        "deaf, or disturbs the bus with error frames. Nothing tells so but a silent network.",
    .bad =
        "[gateway]\n"
        "bit_timing = { can2 = { clock_hz = 16000000, family = \"mcp2515\" } }\n"
        "[gateway.parameters]\n"
        "4426 = 1                            # registers 420..425 instead of 426\n"
        "420 = 3                             # phase segment 2 of 1 TQ\n"
        "421 = 0\n"
        "422 = 0\n"
        "423 = 6\n"
        "424 = 0\n"
        "425 = 5\n",
    .good =
        "[gateway]\n"
        "bit_timing = { can2 = { clock_hz = 16000000, family = \"mcp2515\" } }\n"
        "[gateway.parameters]\n"
        "4426 = 1                            # registers 420..425 instead of 426\n"
        "420 = 3                             # 125 kbit/s, sampled at 87.5 %\n"
        "421 = 0\n"
        "422 = 0\n"
        "423 = 6\n"
        "424 = 1\n"
        "425 = 5\n"};

}  // namespace cgw::diagnostic::rules
