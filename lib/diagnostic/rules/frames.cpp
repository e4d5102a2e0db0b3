// E12: frames and their values, typed in and recorded.
#include "diagnostic/rules/frames.hpp"

namespace cgw::diagnostic::rules {

const Rule frame_unknown{.code = "E1201",
                         .name = "frame-unknown",
                         .level = Level::error,
                         .summary = "a frame that is asked for is an active PDO of the plant",
                         .reference = "",
                         .why =
                             "Only active PDOs are on the bus and have a layout. Which they are follows from "
                             "the parameter file, not from the device.",
                         .example = Example::frame_arguments,
                         .bad = "RPDO5\n",
                         .good = "RPDO4\n"};
const Rule signal_unknown{.code = "E1202",
                          .name = "signal-unknown",
                          .level = Level::error,
                          .summary = "a value is given to one signal of the frame",
                          .reference = "",
                          .why =
                              "A frame carries what the parameter file maps into it and nothing else. A "
                              "parameter that is mapped twice has two signals, and its number means neither.",
                          .example = Example::frame_arguments,
                          .bad =
                              "RPDO2\n"
                              "Setp1Exd=50%\n",
                          .good =
                              "RPDO2\n"
                              "Setp1Ext=50%\n"};
const Rule signal_value{.code = "E1203",
                        .name = "signal-value",
                        .level = Level::error,
                        .summary = "a value is a number in the signal's unit, or a raw one marked as such",
                        .reference = "",
                        .why =
                            "The same number means different things in engineering units and as a raw word, "
                            "and a setpoint that is off by a factor of 600 is obeyed as well.",
                        .example = Example::frame_arguments,
                        .bad =
                            "RPDO2\n"
                            "Setp1Ext=0x1F40\n",
                        .good =
                            "RPDO2\n"
                            "Setp1Ext=0x1F40 raw\n"};
const Rule signal_range{.code = "E1204",
                        .name = "signal-range",
                        .level = Level::error,
                        .summary = "a value lies in the range of its signal",
                        .reference = "GWM 7.1.4.2, D38",
                        .why =
                            "A word has no room for more: what is beyond would come out at the other end of "
                            "the range.",
                        .example = Example::frame_arguments,
                        .bad =
                            "RPDO2\n"
                            "Setp1Ext=150%\n",
                        .good =
                            "RPDO2\n"
                            "Setp1Ext=100%\n"};
const Rule signal_twice{.code = "E1205",
                        .name = "signal-twice",
                        .level = Level::error,
                        .summary = "a signal is given one value",
                        .reference = "",
                        .why = "Of two values one would be lost, and which one is a guess.",
                        .example = Example::frame_arguments,
                        .bad =
                            "RPDO2\n"
                            "Setp1Ext=50%\n"
                            "900=60%\n",
                        .good =
                            "RPDO2\n"
                            "Setp1Ext=50%\n"
                            "902=60%\n"};
const Rule frame_text{
    .code = "E1206",
    .name = "frame-text",
    .level = Level::error,
    .summary = "a typed frame is an identifier of 11 bits and at most eight bytes",
    .reference = "",
    .why = "A digit too few moves all that follow, and the values then mean something else.",
    .example = Example::frame_arguments,
    .bad =
        "0x18C\n"
        "A0\n"
        "0\n",
    .good =
        "0x18C\n"
        "A0\n"
        "0F\n"};
const Rule log_record{.code = "E1207",
                      .name = "log-record",
                      .level = Level::error,
                      .summary = "a log holds frames, as candump writes them or as pcap",
                      .reference = "",
                      .why =
                          "What cannot be read may be the frame that is missing. cgw goes on with the next "
                          "line; a pcap file with an impossible length ends there.",
                      .example = Example::frame_log,
                      .bad =
                          "(1.000000) can0 70C#7F\n"
                          "(1.800000) can0 70C#7\n",
                      .good =
                          "(1.000000) can0 70C#7F\n"
                          "(1.800000) can0 70C#7F\n"};
const Rule log_time{.code = "E1208",
                    .name = "log-time",
                    .level = Level::warning,
                    .summary = "the times of a log are there and go forwards",
                    .reference = "D76",
                    .why =
                        "Periods and gaps are told by these times. They go backwards where a clock was set "
                        "during the recording, where logs were put together, or with candump -t d.",
                    .example = Example::frame_log,
                    .bad =
                        "(1.800000) can0 70C#7F\n"
                        "(1.000000) can0 70C#7F\n",
                    .good =
                        "(1.000000) can0 70C#7F\n"
                        "(1.800000) can0 70C#7F\n"};
const Rule log_empty{.code = "E1209",
                     .name = "log-empty",
                     .level = Level::error,
                     .summary = "there are frames in a log",
                     .reference = "",
                     .why =
                         "An empty log is not a silent bus: the recorder may have listened to another "
                         "interface or at another bit rate.",
                     .example = Example::frame_log,
                     .bad = "\n",
                     .good = "(1.000000) can0 70C#7F\n"};
const Rule frame_length{
    .code = "E1210",
    .name = "frame-length",
    .level = Level::error,
    .summary = "a PDO has the length of its mapping",
    .reference = "D28",
    .why =
        "An RPDO that is too short is not processed. A TPDO of another length comes from a "
        "gateway with another configuration, or from another node.",
    .example = Example::frame_log,
    .bad = "(1.000000) can0 48C#0060\n",
    .good = "(1.000000) can0 48C#0060006000800080\n"};
const Rule frame_long{.code = "E1211",
                      .name = "frame-long",
                      .level = Level::warning,
                      .summary = "a received PDO is not longer than its mapping",
                      .reference = "D28",
                      .why =
                          "Of a longer RPDO the first bytes count. Its sender believes that the gateway maps "
                          "more than it does.",
                      .example = Example::frame_log,
                      .bad = "(1.000000) can0 50C#00800080\n",
                      .good = "(1.000000) can0 50C#0080\n"};
const Rule frame_missing{.code = "E1212",
                         .name = "frame-missing",
                         .level = Level::error,
                         .summary = "what the plant sends and monitors occurs in the log",
                         .reference = "GWM 7.1, D53, D76",
                         .why =
                             "A PDO that never comes was set up in one device only, or the gateway was not "
                             "reset after its parameters were changed.",
                         .example = Example::frame_log,
                         .bad =
                             "(0.000000) can0 701#7F\n"
                             "(2.000000) can0 701#7F\n",
                         .good =
                             "(0.000000) can0 701#7F\n"
                             "(0.300000) can0 70C#7F\n"
                             "(1.100000) can0 70C#7F\n"
                             "(1.900000) can0 70C#7F\n"
                             "(2.000000) can0 701#7F\n"};
const Rule frame_not_seen{
    .code = "E1213",
    .name = "frame-not-seen",
    .level = Level::warning,
    .summary = "PDOs without a time occur in the log as well",
    .reference = "D53, D76",
    .why =
        "TPDO1 to 3 are sent on each entry into Operational and when a bit changes, and "
        "nobody misses an RPDO that is not monitored. In a log that begins later their "
        "absence may mean nothing.",
    .example = Example::frame_log,
    .bad =
        "(0.000000) can0 70C#05\n"
        "(0.010000) can0 18C#0000000000000000\n"
        "(0.020000) can0 28C#00000000\n"
        "(0.200000) can0 18C#0100000000000000\n",
    .good =
        "(0.000000) can0 70C#05\n"
        "(0.010000) can0 18C#0000000000000000\n"
        "(0.020000) can0 28C#00000000\n"
        "(0.030000) can0 38C#0100\n"
        "(0.200000) can0 18C#0100000000000000\n"};
const Rule frame_unexpected{
    .code = "E1214",
    .name = "frame-unexpected",
    .level = Level::warning,
    .summary = "every identifier in the log belongs to the plant or to a node it names",
    .reference = "GWM 7.3, D33",
    .why =
        "A node that nobody has named may collide with the gateway's identifiers "
        "tomorrow. List it under [network], or find out what it is.",
    .example = Example::frame_log,
    .bad = "(1.000000) can0 185#00\n",
    .good = "(1.000000) can0 18B#00\n"};
const Rule frame_period{
    .code = "E1215",
    .name = "frame-period",
    .level = Level::warning,
    .summary = "a cyclic frame comes at its period, on average within 5 %",
    .reference = "GWM 7.1.3, D8, D76",
    .why =
        "Another period is another cycle time or main cycle than the parameter file says: "
        "file and device differ.",
    .example = Example::frame_log,
    .bad =
        "(0.000000) can0 18C#0000000000000000\n"
        "(0.000500) can0 28C#00000000\n"
        "(0.001000) can0 38C#0100\n"
        "(0.002000) can0 48C#0060006000800080\n"
        "(0.142000) can0 48C#0060006000800080\n"
        "(0.282000) can0 48C#0060006000800080\n"
        "(0.422000) can0 48C#0060006000800080\n"
        "(0.562000) can0 48C#0060006000800080\n"
        "(0.702000) can0 48C#0060006000800080\n",
    .good =
        "(0.000000) can0 18C#0000000000000000\n"
        "(0.000500) can0 28C#00000000\n"
        "(0.001000) can0 38C#0100\n"
        "(0.002000) can0 48C#0060006000800080\n"
        "(0.127000) can0 48C#0060006000800080\n"
        "(0.252000) can0 48C#0060006000800080\n"
        "(0.377000) can0 48C#0060006000800080\n"
        "(0.502000) can0 48C#0060006000800080\n"
        "(0.627000) can0 48C#0060006000800080\n"};
const Rule frame_gap{
    .code = "E1216",
    .name = "frame-gap",
    .level = Level::warning,
    .summary = "a cyclic frame stays out for at most 1.5 periods",
    .reference = "D76",
    .why =
        "One frame was lost or kept waiting: the bus was overloaded, disturbed or off, or the "
        "recorder did not keep up.",
    .example = Example::frame_log,
    .bad =
        "(0.000000) can0 18C#0000000000000000\n"
        "(0.000500) can0 28C#00000000\n"
        "(0.001000) can0 38C#0100\n"
        "(0.002000) can0 48C#0060006000800080\n"
        "(0.127000) can0 48C#0060006000800080\n"
        "(0.252000) can0 48C#0060006000800080\n"
        "(0.502000) can0 48C#0060006000800080\n",
    .good =
        "(0.000000) can0 18C#0000000000000000\n"
        "(0.000500) can0 28C#00000000\n"
        "(0.001000) can0 38C#0100\n"
        "(0.002000) can0 48C#0060006000800080\n"
        "(0.127000) can0 48C#0060006000800080\n"
        "(0.252000) can0 48C#0060006000800080\n"
        "(0.377000) can0 48C#0060006000800080\n"};
const Rule monitoring_exceeded{
    .code = "E1217",
    .name = "monitoring-exceeded",
    .level = Level::error,
    .summary = "what is monitored comes within its monitoring time",
    .reference = "GWM 7.1.5, GWM 7.2.3, D55, D76",
    .why =
        "The gateway then reports 12413 or 12420, takes the sensors of this PDO for "
        "faulty and the switch functions for off.",
    .example = Example::frame_log,
    .bad =
        "(0.000000) can0 18C#0000000000000000\n"
        "(0.000500) can0 28C#00000000\n"
        "(0.001000) can0 38C#0100\n"
        "(0.002000) can0 48C#0060006000800080\n"
        "(0.020000) can0 20C#000000000000\n"
        "(0.127000) can0 48C#0060006000800080\n"
        "(0.252000) can0 48C#0060006000800080\n"
        "(0.377000) can0 48C#0060006000800080\n"
        "(0.502000) can0 48C#0060006000800080\n"
        "(0.600000) can0 20C#000000000000\n",
    .good =
        "(0.000000) can0 18C#0000000000000000\n"
        "(0.000500) can0 28C#00000000\n"
        "(0.001000) can0 38C#0100\n"
        "(0.002000) can0 48C#0060006000800080\n"
        "(0.020000) can0 20C#000000000000\n"
        "(0.127000) can0 48C#0060006000800080\n"
        "(0.252000) can0 48C#0060006000800080\n"
        "(0.377000) can0 48C#0060006000800080\n"
        "(0.502000) can0 48C#0060006000800080\n"
        "(0.510000) can0 20C#000000000000\n"};
const Rule frame_when_stopped{.code = "E1218",
                              .name = "frame-when-stopped",
                              .level = Level::error,
                              .summary = "the gateway sends PDOs in Operational only",
                              .reference = "GWM 3, D76",
                              .why =
                                  "After NMT stop or reset a PDO with the gateway's identifier comes from "
                                  "another node, or the command did not reach the gateway.",
                              .example = Example::frame_log,
                              .bad =
                                  "(1.000000) can0 000#020C\n"
                                  "(1.200000) can0 48C#0060006000800080\n",
                              .good =
                                  "(1.000000) can0 000#020C\n"
                                  "(1.050000) can0 48C#0060006000800080\n"};

}  // namespace cgw::diagnostic::rules
