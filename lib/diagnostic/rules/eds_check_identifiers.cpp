// E0889..E0894: CAN identifiers (COB-IDs) in an EDS or DCF, as checked.
#include "diagnostic/rules/eds_check.hpp"

namespace cgw::diagnostic::rules {

const Rule eds_cob_id_restricted{
    .code = "E0889",
    .name = "eds-cob-id-restricted",
    .level = Level::warning,
    .summary = "no PDO, SYNC, TIME, EMCY or further SDO has an identifier that CiA 301 keeps for others",
    .reference = "CiA 301 version 4.2",
    .why = "A frame of this device is taken for another service: for an SDO, a heartbeat or a command.",
    .example = Example::data_sheet_lines,
    .bad =
        "[1800sub1]\n"
        "DefaultValue=$NODEID+0x700\n",
    .good =
        "[1800sub1]\n"
        "DefaultValue=$NODEID+0x180\n"};
const Rule eds_cob_id_twice{.code = "E0890",
                            .name = "eds-cob-id-twice",
                            .level = Level::error,
                            .summary = "two services of one device have different identifiers",
                            .reference = "CiA 301",
                            .why =
                                "Nobody can tell their frames apart, and two senders of one identifier "
                                "disturb each other on the bus.",
                            .example = Example::data_sheet_lines,
                            .bad =
                                "[1800sub1]\n"
                                "DefaultValue=$NODEID+0x200\n",
                            .good =
                                "[1800sub1]\n"
                                "DefaultValue=$NODEID+0x180\n"};
const Rule eds_cob_id_form{
    .code = "E0891",
    .name = "eds-cob-id-form",
    .level = Level::error,
    .summary = "an identifier of more than 11 bits has bit 29 set",
    .reference = "CiA 301",
    .why = "Without bit 29 the frame has 11 bits, and the device refuses the value or cuts it.",
    .example = Example::data_sheet_lines,
    .bad =
        "[1800sub1]\n"
        "DefaultValue=$NODEID+0x1980\n",
    .good =
        "[1800sub1]\n"
        "DefaultValue=$NODEID+0x180\n"};
const Rule eds_node_id_absent{
    .code = "E0892",
    .name = "eds-node-id-absent",
    .level = Level::warning,
    .summary = "an identifier that is made of a base and the node id follows $NODEID",
    .reference = "CiA 306",
    .why = "The base alone is the identifier of no node: all devices of this kind would share it.",
    .example = Example::data_sheet_lines,
    .bad =
        "[1800sub1]\n"
        "DefaultValue=0x180\n",
    .good =
        "[1800sub1]\n"
        "DefaultValue=$NODEID+0x180\n"};
const Rule eds_sdo_server{
    .code = "E0893",
    .name = "eds-sdo-server",
    .level = Level::warning,
    .summary = "the first SDO server has the identifiers 600h and 580h with the node id",
    .reference = "CiA 301",
    .why = "They are fixed. A master that believes the file does not reach the device.",
    .example = Example::data_sheet_lines,
    .bad =
        "[1200sub1]\n"
        "DefaultValue=$NODEID+0x640\n",
    .good =
        "[1200sub1]\n"
        "DefaultValue=$NODEID+0x600\n"};
const Rule eds_heartbeat_consumer{
    .code = "E0894",
    .name = "eds-heartbeat-consumer",
    .level = Level::warning,
    .summary = "a heartbeat is watched of a node from 1 to 127, once, and not of the own one",
    .reference = "CiA 301",
    .why =
        "The node stands in bits 16 to 23 of 1016h, the time in ms below. The device refuses the value, or a "
        "second one for the same node, or waits for a node that does not exist.",
    .example = Example::data_sheet_lines,
    .bad =
        "[1016sub1]\n"
        "DefaultValue=0x00C803E8\n",
    .good =
        "[1016sub1]\n"
        "DefaultValue=0x000503E8\n"};

}  // namespace cgw::diagnostic::rules
