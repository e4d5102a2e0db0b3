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

}  // namespace cgw::diagnostic::rules
