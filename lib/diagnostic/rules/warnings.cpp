// E03: warnings, what works but hardly as it was meant.
#include "diagnostic/rules/warnings.hpp"

namespace cgw::diagnostic::rules {

const Rule monitoring_early{
    .code = "E0301",
    .name = "monitoring-early",
    .level = Level::warning,
    .summary = "a monitoring time lasts at least as long as it says",
    .reference = "GWM 7.1.5, 7.2.3, D9",
    .why =
        "The devices count whole main cycles and round down. A sender that keeps exactly to the time in the "
        "file is then a little too slow, and its loss is reported again and again on a healthy plant.",
    .bad =
        "[gateway.parameters]\n"
        "428 = 2\n"
        "430 = 1000                          # watched for 992 ms\n",
    .good =
        "[gateway.parameters]\n"
        "428 = 2\n"
        "430 = 1008                          # 63 cycles of 16 ms\n"};
const Rule monitoring_short{
    .code = "E0302",
    .name = "monitoring-short",
    .level = Level::warning,
    .summary = "a monitoring time is at least two main cycles",
    .reference = "GWM 7.1.5, D35",
    .why =
        "A telegram may have to wait for the bus and for the gateway. A monitoring time of a single main "
        "cycle takes every such delay for a failure.",
    .bad =
        "[gateway.parameters]\n"
        "428 = 2\n"
        "430 = 16\n",
    .good =
        "[gateway.parameters]\n"
        "428 = 2\n"
        "430 = 2000\n"};
const Rule rpdo_unmonitored{
    .code = "E0303",
    .name = "rpdo-unmonitored",
    .level = Level::warning,
    .summary = "an active RPDO has a monitoring time",
    .reference = "GWM 7.1.5, D35",
    .why =
        "Without monitoring the governor keeps the last setpoint and the last switches for ever when the "
        "sender is gone. Nothing on the engine shows that they are old.",
    .bad =
        "[governor.parameters]\n"
        "900 = 1                             # AssignIn_Setp1Ext: RPDO2 word 1\n"
        "4900 = 3\n"
        "16480 = [500, 0]\n",
    .good =
        "[governor.parameters]\n"
        "900 = 1                             # AssignIn_Setp1Ext: RPDO2 word 1\n"
        "4900 = 3\n"
        "16480 = [500, 500]                  # RPDO1 carries the sensor's error flag\n"};
const Rule rpdo_inactive_monitored{
    .code = "E0304",
    .name = "rpdo-inactive-monitored",
    .level = Level::warning,
    .summary = "a monitored RPDO is active",
    .reference = "GWM 7.1.5, D27",
    .why =
        "A monitoring time says that the RPDO matters, but nothing uses it. Most often the sensor or the "
        "switch function was forgotten, or stands on a channel of another RPDO.",
    .bad =
        "[governor.parameters]\n"
        "16481 = 500                         # RPDO2\n",
    .good =
        "[governor.parameters]\n"
        "16481 = 0                           # RPDO2\n"};
const Rule decimal_for_hexadecimal{
    .code = "E0305",
    .name = "decimal-for-hexadecimal",
    .level = Level::warning,
    .summary = "a parameter that the manual prints in hexadecimal is typed with 0x",
    .reference = "GWM 7.2.4, D15",
    .why =
        "The manual and DcDesk show identifiers in hexadecimal without a prefix. Whoever copies 282 from "
        "there gets identifier 11Ah, and the receiver waits for 282h in vain.",
    .bad =
        "[gateway.parameters]\n"
        "16404 = 282\n",
    .good =
        "[gateway.parameters]\n"
        "16404 = 0x282\n"};
const Rule cob_id_restricted{
    .code = "E0306",
    .name = "cob-id-restricted",
    .level = Level::warning,
    .summary = "an active PDO stays out of the identifiers that CiA 301 restricts",
    .reference = "CiA 301, D33",
    .why =
        "The gateway takes such an identifier, and the manual's own example has one. Masters and analysers "
        "may refuse the EDS, or read the telegram as SDO, heartbeat or safety data.",
    .bad =
        "[governor.parameters]\n"
        "16404 = [2000]                      # TPDO5\n"
        "16461 = 125\n"
        "[gateway.parameters]\n"
        "16404 = 0x3\n",
    .good =
        "[governor.parameters]\n"
        "16404 = [2000]                      # TPDO5\n"
        "16461 = 125\n"
        "[gateway.parameters]\n"
        "16404 = 0x680\n"};
const Rule tpdo_empty{
    .code = "E0307",
    .name = "tpdo-empty",
    .level = Level::warning,
    .summary = "a TPDO with a cycle time has something to send",
    .reference = "GWM 7.1.2.2, 7.1.3, D35",
    .why =
        "A TPDO without a word is not sent. Either its measurements were forgotten, or the cycle time "
        "stands in the row of another TPDO.",
    .bad =
        "[governor.parameters]\n"
        "16462 = 250                         # TPDO6\n",
    .good =
        "[governor.parameters]\n"
        "16462 = 0                           # TPDO6\n"};
const Rule tpdo_unsent{
    .code = "E0308",
    .name = "tpdo-unsent",
    .level = Level::warning,
    .summary = "a TPDO with something to send has a cycle time",
    .reference = "GWM 7.1.3, D35",
    .why =
        "Cycle time 0 switches the TPDO off, whatever is assigned to it. The receiver waits for values "
        "that never come.",
    .bad =
        "[governor.parameters]\n"
        "16400 = [2000]                      # TPDO4\n"
        "16460 = 0\n",
    .good =
        "[governor.parameters]\n"
        "16400 = [2000]                      # TPDO4\n"
        "16460 = 125\n"};
const Rule switch_without_bit{
    .code = "E0309",
    .name = "switch-without-bit",
    .level = Level::warning,
    .summary = "a switch function of type 3 (CANopen) has a bit",
    .reference = "GWM 7.1.4.1, D27",
    .why =
        "The function is taken from its wire and given to CANopen, but no bit of RPDO1 carries it: it is "
        "always 0.",
    .bad =
        "[governor.parameters]\n"
        "835 = 0                             # FunctLoadEnable\n"
        "4835 = 3\n",
    .good =
        "[governor.parameters]\n"
        "835 = 1                             # FunctLoadEnable\n"
        "4835 = 3\n"
        "16480 = 500\n"};
const Rule sensor_without_channel{
    .code = "E0310",
    .name = "sensor-without-channel",
    .level = Level::warning,
    .summary = "a sensor of channel type 3 (CANopen) has a channel",
    .reference = "GWM 7.1.4.2, D27",
    .why =
        "The sensor is expected from CANopen, but no word of an RPDO carries it. The governor never gets a "
        "value for it.",
    .bad =
        "[governor.parameters]\n"
        "900 = 0                             # AssignIn_Setp1Ext\n"
        "4900 = 3\n",
    .good =
        "[governor.parameters]\n"
        "900 = 1                             # AssignIn_Setp1Ext\n"
        "4900 = 3\n"
        "16480 = [500, 500]\n"};
const Rule switch_bit_shared{
    .code = "E0311",
    .name = "switch-bit-shared",
    .level = Level::warning,
    .summary = "every switch function has a bit of its own",
    .reference = "GWM 7.1.4.1, D35",
    .why =
        "Two functions on one bit always switch together, in opposite directions if one of them is "
        "low-active. That is rarely meant and hard to see on the running plant.",
    .bad =
        "[governor.parameters]\n"
        "827 = 1                             # FunctSetpoint2Or1\n"
        "835 = 1                             # FunctLoadEnable\n"
        "4827 = 3\n"
        "4835 = 3\n"
        "16480 = 500\n",
    .good =
        "[governor.parameters]\n"
        "827 = 1                             # FunctSetpoint2Or1\n"
        "835 = 2                             # FunctLoadEnable\n"
        "4827 = 3\n"
        "4835 = 3\n"
        "16480 = 500\n"};
const Rule sensor_channel_shared{
    .code = "E0312",
    .name = "sensor-channel-shared",
    .level = Level::warning,
    .summary = "every sensor has a channel of its own",
    .reference = "GWM 7.1.4.2, D35",
    .why =
        "Two sensors on one channel always have the same value, with different meanings: a setpoint is "
        "taken for a pressure.",
    .bad =
        "[governor.parameters]\n"
        "900 = 1                             # AssignIn_Setp1Ext\n"
        "906 = 1                             # AssignIn_AmbPress\n"
        "4900 = 3\n"
        "4906 = 3\n"
        "16480 = [500, 500]\n",
    .good =
        "[governor.parameters]\n"
        "900 = 1                             # AssignIn_Setp1Ext\n"
        "906 = 2                             # AssignIn_AmbPress\n"
        "4900 = 3\n"
        "4906 = 3\n"
        "16480 = [500, 500]\n"};
const Rule start_up_delay_mismatch{
    .code = "E0313",
    .name = "start-up-delay-mismatch",
    .level = Level::warning,
    .summary = "both devices wait equally long at start-up before they miss each other",
    .reference = "GWM 7.1.1, 7.2.1, D35",
    .why =
        "The device with the shorter delay reports a failed connection while the other one still starts. "
        "The error stands there after every power-up, and people learn to ignore it.",
    .bad =
        "[governor.parameters]\n"
        "400 = 2.0\n"
        "[gateway.parameters]\n"
        "400 = 1.0\n",
    .good =
        "[governor.parameters]\n"
        "400 = 2.0\n"
        "[gateway.parameters]\n"
        "400 = 2.0\n"};
const Rule partner_unmonitored{
    .code = "E0314",
    .name = "partner-unmonitored",
    .level = Level::warning,
    .summary = "a partner is monitored by its heartbeat",
    .reference = "GWM 7.2.3, D35",
    .why =
        "The partner is named only to be monitored. Without a time nothing happens when it fails, although "
        "the parameters look as if somebody watched.",
    .bad =
        "[gateway.parameters]\n"
        "428 = 2\n"
        "430 = 0\n",
    .good =
        "[gateway.parameters]\n"
        "428 = 2\n"
        "430 = 2000\n"};
const Rule heartbeat_off{
    .code = "E0315",
    .name = "heartbeat-off",
    .level = Level::warning,
    .summary = "the gateway sends a heartbeat",
    .reference = "GWM 7.2.3, D35",
    .why =
        "TPDO1 to TPDO3 are silent while nothing changes. Without a heartbeat the master cannot tell a "
        "healthy gateway from one that is gone.",
    .bad =
        "[gateway.parameters]\n"
        "429 = 0\n",
    .good =
        "[gateway.parameters]\n"
        "429 = 1008\n"};
const Rule bit_rate_unusual{
    .code = "E0316",
    .name = "bit-rate-unusual",
    .level = Level::warning,
    .summary = "bit timing by hand makes a bit rate of CANopen",
    .reference = "CiA 301, GWM 7.2.2, D7, D77",
    .why =
        "All nodes of a bus need the same bit rate. Devices and tools offer those of CiA 301; one that is "
        "typed wrong by a single register is near none of them.",
    .bad =
        "[gateway]\n"
        "bit_timing = { can2 = { clock_hz = 16000000, family = \"mcp2515\" } }\n"
        "[gateway.parameters]\n"
        "4426 = 1                            # registers 420..425 instead of 426\n"
        "420 = 4                             # 100 kbit/s\n"
        "421 = 0\n"
        "422 = 0\n"
        "423 = 6\n"
        "424 = 1\n"
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
const Rule sample_point{
    .code = "E0317",
    .name = "sample-point",
    .level = Level::warning,
    .summary = "bit timing by hand samples a bit where other devices do",
    .reference = "CiA 301, GWM 7.2.2, D77",
    .why =
        "Nodes that sample a bit at different places disagree on long cables or with cheap oscillators, "
        "and only now and then: the worst kind of fault.",
    .bad =
        "[gateway]\n"
        "bit_timing = { can2 = { clock_hz = 16000000, family = \"mcp2515\" } }\n"
        "[gateway.parameters]\n"
        "4426 = 1                            # registers 420..425 instead of 426\n"
        "420 = 3                             # sampled at 62.5 %\n"
        "421 = 0\n"
        "422 = 0\n"
        "423 = 4\n"
        "424 = 5\n"
        "425 = 3\n",
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
