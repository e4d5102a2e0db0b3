// E11: the load of a CANopen bus, as cgw network judges it.
#include "diagnostic/rules/network.hpp"

namespace cgw::diagnostic::rules {

const Rule identifier_conflict{.code = "E1101",
                               .name = "identifier-conflict",
                               .level = Level::error,
                               .summary = "every identifier of the bus has one sender",
                               .reference = "CiA 301",
                               .why =
                                   "Two nodes that begin the same identifier at the same time destroy each "
                                   "other's frames, again and again. "
                                   "Receivers take the one's data for the other's.",
                               .example = Example::network,
                               .bad = "[[network.message]]\nid = 0x701\nbytes = 1\nperiod_ms = 500\n",
                               .good = "[[network.message]]\nid = 0x702\nbytes = 1\nperiod_ms = 500\n"};
const Rule bit_rates_differ{.code = "E1102",
                            .name = "bit-rates-differ",
                            .level = Level::error,
                            .summary = "all nodes of a bus have one bit rate",
                            .reference = "GWM 7.2.2",
                            .why = "A node with another bit rate destroys every frame on the bus.",
                            .example = Example::none,
                            .bad = "",
                            .good = ""};
const Rule bus_bit_rate_unknown{
    .code = "E1103",
    .name = "bus-bit-rate-unknown",
    .level = Level::error,
    .summary = "the bit rate of the bus can be told from the file",
    .reference = "D7",
    .why = "Without a bit rate there is neither a load nor a response time.",
    .example = Example::network,
    .bad = "[gateway.parameters]\n4426 = 1\n420 = 3\n423 = 6\n424 = 1\n425 = 5\n",
    .good =
        "[gateway]\nbit_timing = { can2 = { clock_hz = 16000000, family = \"mcp2515\" } }\n"
        "[gateway.parameters]\n4426 = 1\n420 = 3\n423 = 6\n424 = 1\n425 = 5\n"};
const Rule node_shared{
    .code = "E1104",
    .name = "node-shared",
    .level = Level::error,
    .summary = "no two nodes of a bus have one node id",
    .reference = "GWM 7.2.2",
    .why =
        "Both send under the same identifiers and answer the same requests; neither can be "
        "reached reliably.",
    .example = Example::none,
    .bad = "",
    .good = ""};
const Rule message_unbounded{.code = "E1105",
                             .name = "message-unbounded",
                             .level = Level::error,
                             .summary = "every message gets through in a time that can be told",
                             .reference = "D75",
                             .why =
                                 "Messages of higher or equal priority may take all the bus. What is behind "
                                 "them may then never be sent.",
                             .example = Example::network,
                             .bad = "[[network.message]]\nid = 0x10\nperiod_ms = 1\n",
                             .good = "[[network.message]]\nid = 0x10\nperiod_ms = 10\n"};
const Rule deadline_missed{.code = "E1106",
                           .name = "deadline-missed",
                           .level = Level::error,
                           .summary = "every message is through before its deadline",
                           .reference = "D75",
                           .why =
                               "What comes later than the receiver waits for it is an error there, and what "
                               "is not through when the next "
                               "is due gets lost.",
                           .example = Example::network,
                           .bad = "[[network.message]]\nid = 0x10\nperiod_ms = 10\ndeadline_ms = 2\n",
                           .good = "[[network.message]]\nid = 0x10\nperiod_ms = 10\ndeadline_ms = 3\n"};
const Rule bus_overloaded{.code = "E1107",
                          .name = "bus-overloaded",
                          .level = Level::error,
                          .summary = "the worst-case load of the bus leaves room for disturbances",
                          .reference = "D75",
                          .why =
                              "Repeated frames, SDO transfers and nodes to come need room. Above 70 % a "
                              "single fault is felt by all.",
                          .example = Example::network,
                          .bad =
                              "[network]\n"
                              "message = [{ id = 0x300, period_ms = 6.1 }, { id = 0x301, period_ms = 6.1 }, "
                              "{ id = 0x302, period_ms = 6.1 }, { id = 0x303, period_ms = 6.1 }]\n",
                          .good =
                              "[network]\n"
                              "message = [{ id = 0x300, period_ms = 20 }, { id = 0x301, period_ms = 20 }, { "
                              "id = 0x302, period_ms = 20 }, { id = 0x303, period_ms = 20 }]\n"};
const Rule bus_load_high{
    .code = "E1108",
    .name = "bus-load-high",
    .level = Level::warning,
    .summary = "the worst-case load of the bus is at most 50 %",
    .reference = "D75",
    .why = "It works, but response times grow steeply from here on, and little can be added.",
    .example = Example::network,
    .bad =
        "[network]\n"
        "message = [{ id = 0x300, period_ms = 6 }, { id = 0x301, period_ms = 6 }, { id = 0x302, period_ms = "
        "6 }]\n",
    .good =
        "[network]\n"
        "message = [{ id = 0x300, period_ms = 9 }, { id = 0x301, period_ms = 9 }, { id = 0x302, period_ms = "
        "9 }]\n"};
const Rule message_late{
    .code = "E1109",
    .name = "message-late",
    .level = Level::warning,
    .summary = "a message is through before the next one is due, and before its receiver gives up on it",
    .reference = "D75",
    .why =
        "A frame that still waits when the next is due is overwritten or delays it. One that is sent at the "
        "end "
        "of its period and then waits may come after the receiver's monitoring time.",
    .example = Example::network,
    .bad = "[[network.message]]\nid = 0x10\nperiod_ms = 10\njitter_ms = 9\ndeadline_ms = 20\n",
    .good = "[[network.message]]\nid = 0x10\nperiod_ms = 10\njitter_ms = 5\ndeadline_ms = 20\n"};
const Rule message_too_short{
    .code = "E1110",
    .name = "message-too-short",
    .level = Level::error,
    .summary = "a PDO is sent with at least the bytes that its receiver maps",
    .reference = "CiA 301",
    .why = "A receiver ignores a PDO that is shorter than its mapping.",
    .example = Example::network,
    .bad =
        "[governor.parameters]\n900 = 1\n4900 = 3\n901 = 2\n4901 = 3\n16480 = 500\n16481 = 500\n"
        "[[network.message]]\nid = 0x301\nbytes = 2\nperiod_ms = 100\n",
    .good =
        "[governor.parameters]\n900 = 1\n4900 = 3\n901 = 2\n4901 = 3\n16480 = 500\n16481 = 500\n"
        "[[network.message]]\nid = 0x301\nbytes = 4\nperiod_ms = 100\n"};
const Rule message_not_counted{.code = "E1111",
                               .name = "message-not-counted",
                               .level = Level::warning,
                               .summary = "everything that a node sends can be counted",
                               .reference = "",
                               .why = "The load is higher, and other messages may be later, than is told.",
                               .example = Example::none,
                               .bad = "",
                               .good = ""};
const Rule message_too_slow{
    .code = "E1112",
    .name = "message-too-slow",
    .level = Level::error,
    .summary = "a message that is monitored is sent more often than its receiver wants it",
    .reference = "D75",
    .why = "The monitoring trips between two of them, each time, although nothing is broken.",
    .example = Example::network,
    .bad =
        "[governor.parameters]\n900 = 1\n4900 = 3\n16480 = 500\n16481 = 500\n"
        "[[network.message]]\nid = 0x301\nbytes = 2\nperiod_ms = 600\n",
    .good =
        "[governor.parameters]\n900 = 1\n4900 = 3\n16480 = 500\n16481 = 500\n"
        "[[network.message]]\nid = 0x301\nbytes = 2\nperiod_ms = 100\n"};
const Rule message_told_twice{.code = "E1113",
                              .name = "message-told-twice",
                              .level = Level::warning,
                              .summary = "two files that tell one message agree in how often it comes",
                              .reference = "",
                              .why =
                                  "One of them is wrong or out of date. The shorter time counts, so that the "
                                  "load is not told too low.",
                              .example = Example::none,
                              .bad = "",
                              .good = ""};
const Rule bit_rate_not_offered{
    .code = "E1114",
    .name = "bit-rate-not-offered",
    .level = Level::error,
    .summary = "a node supports the bit rate of the bus, by its description",
    .reference = "CiA 306",
    .why =
        "A node with another bit rate destroys every frame on the bus. One that has not this rate cannot be "
        "set to it.",
    .example = Example::none,
    .bad = "",
    .good = ""};

}  // namespace cgw::diagnostic::rules
