// E01: keys, parameters, values.
#include "diagnostic/rules/keys.hpp"

namespace cgw::diagnostic::rules {

const Rule key_unknown{
    .code = "E0101",
    .name = "key-unknown",
    .level = Level::error,
    .summary = "every key and table is one that cgw knows",
    .reference = "",
    .why =
        "A misspelt key would be skipped, and its value with it: the file says one thing, the plant does "
        "another.",
    .bad =
        "[gateway]\n"
        "identty = { software_version = 104 }\n",
    .good =
        "[gateway]\n"
        "identity = { software_version = 104 }\n"};
const Rule key_type{
    .code = "E0102",
    .name = "key-type",
    .level = Level::error,
    .summary = "every key has a value of its type",
    .reference = "",
    .why =
        "Text stands in quotation marks, numbers and lists do not. cgw does not guess what a value of "
        "another kind was meant to be.",
    .bad =
        "[network]\n"
        "nodes = 2\n",
    .good =
        "[network]\n"
        "nodes = [2]\n"};
const Rule key_missing{
    .code = "E0103",
    .name = "key-missing",
    .level = Level::error,
    .summary = "every required key is there",
    .reference = "",
    .why =
        "Some things only make sense together: without the controller's family a clock says nothing "
        "about the bit rate, and without a number a declaration declares nothing.",
    .bad =
        "[gateway]\n"
        "bit_timing = { can1 = { clock_hz = 16000000 } }\n",
    .good =
        "[gateway]\n"
        "bit_timing = { can1 = { clock_hz = 16000000, family = \"mcp2515\" } }\n"};
const Rule key_value{
    .code = "E0104",
    .name = "key-value",
    .level = Level::error,
    .summary = "the value of a key lies in its range",
    .reference = "",
    .why =
        "A node id beyond 127 or a date that does not exist would end up in the EDS and in the identity "
        "that the master compares.",
    .bad =
        "[network]\n"
        "nodes = [128]\n",
    .good =
        "[network]\n"
        "nodes = [127]\n"};
const Rule parameter_unknown{
    .code = "E0105",
    .name = "parameter-unknown",
    .level = Level::error,
    .summary = "every parameter exists in the catalogue of its device",
    .reference = "D1, D13",
    .why =
        "Governor and gateway use the same numbers for different things. A number that the device does "
        "not have is a slip, or a parameter typed into the other device's table.",
    .bad =
        "[gateway.parameters]\n"
        "CanOpenMyNodID = 5\n",
    .good =
        "[gateway.parameters]\n"
        "427 = 5                             # CanOpenMyNodeID\n"};
const Rule parameter_name_mismatch{
    .code = "E0106",
    .name = "parameter-name-mismatch",
    .level = Level::error,
    .summary = "number and name of a \"number name\" key belong to the same parameter",
    .reference = "D16",
    .why =
        "One of the two is wrong, and only the author knows which. Going by the number or by the name "
        "would set a parameter that nobody meant in half of the cases.",
    .bad =
        "[gateway.parameters]\n"
        "\"428 CanOpHeartBeatTxTime\" = 800\n",
    .good =
        "[gateway.parameters]\n"
        "\"428 CanOpenPartnerNodeID\" = 0\n"};
const Rule parameter_not_settable{
    .code = "E0107",
    .name = "parameter-not-settable",
    .level = Level::error,
    .summary = "only parameters, functions and curves can be set; measurements cannot",
    .reference = "D16",
    .why =
        "A measurement is what the device shows. To send one over CANopen, assign its number to a word "
        "of a TPDO.",
    .bad =
        "[governor.parameters]\n"
        "2000 = 1500                         # Speed\n",
    .good =
        "[governor.parameters]\n"
        "16400 = 2000                        # TPDO4 word 1 carries Speed\n"
        "16460 = 125                         # ... every 125 ms\n"};
const Rule parameter_duplicate{
    .code = "E0108",
    .name = "parameter-duplicate",
    .level = Level::error,
    .summary = "a parameter is set once, by any spelling",
    .reference = "",
    .why =
        "With two values for one parameter the reader of the file sees the one and the device gets the "
        "other. A list sets all the numbers it reaches, which is easily overlooked.",
    .bad =
        "[gateway.parameters]\n"
        "427 = 5\n"
        "CanOpenMyNodeID = 6\n",
    .good =
        "[gateway.parameters]\n"
        "427 = 5\n"};
const Rule parameter_missing{
    .code = "E0109",
    .name = "parameter-missing",
    .level = Level::error,
    .summary = "node numbers, node id and bit rates have no default and must be set",
    .reference = "",
    .why =
        "Two nodes with the same number or two bit rates on one bus stop everybody on that bus, not only "
        "the new device. These values are decided by the plant and never by a default.",
    .bad =
        "[gateway.parameters]\n"
        "# 427 = 5\n",
    .good =
        "[gateway.parameters]\n"
        "427 = 5\n"};
const Rule value_type{
    .code = "E0110",
    .name = "value-type",
    .level = Level::error,
    .summary = "a parameter's value is a number of its kind",
    .reference = "",
    .why =
        "Parameters are numbers as DcDesk shows them. Text, true and false are refused, and a fraction "
        "where the device counts in whole numbers would be cut off.",
    .bad =
        "[governor.parameters]\n"
        "4406 = true                         # CanCommCMOn\n",
    .good =
        "[governor.parameters]\n"
        "4406 = 1                            # CanCommCMOn\n"};
const Rule value_range{
    .code = "E0111",
    .name = "value-range",
    .level = Level::error,
    .summary = "a parameter's value lies in its range",
    .reference = "GWM 11, D6, D17",
    .why =
        "The device refuses or limits such a value when it is entered, and then runs with another one "
        "than the file, the EDS and the master's project say.",
    .bad =
        "[gateway.parameters]\n"
        "426 = 800\n",
    .good =
        "[gateway.parameters]\n"
        "426 = 500\n"};
const Rule list_too_long{
    .code = "E0112",
    .name = "list-too-long",
    .level = Level::error,
    .summary = "a list ends with its array",
    .reference = "D16",
    .why =
        "A list fills consecutive numbers. Beyond the end of the array stand parameters with another "
        "meaning, which would be overwritten.",
    .bad =
        "[governor.parameters]\n"
        "16480 = [0, 0, 0, 0, 0]\n",
    .good =
        "[governor.parameters]\n"
        "16480 = [0, 0, 0, 0]\n"};
const Rule declaration_invalid{
    .code = "E0113",
    .name = "declaration-invalid",
    .level = Level::error,
    .summary = "a declaration says what the catalogue needs to know",
    .reference = "D13",
    .why =
        "Width, sign and limits decide how the word on the bus is read. A declaration that cannot be true "
        "of any device would put a wrong value on somebody's display.",
    .bad =
        "[[governor.declare]]\n"
        "number = 2990\n"
        "name = \"TorqueActual\"\n"
        "kind = \"measurement\"\n"
        "width = 12\n"
        "signed = true\n",
    .good =
        "[[governor.declare]]\n"
        "number = 2990\n"
        "name = \"TorqueActual\"\n"
        "kind = \"measurement\"\n"
        "width = 16\n"
        "signed = true\n"};
const Rule declaration_contradiction{
    .code = "E0114",
    .name = "declaration-contradiction",
    .level = Level::error,
    .summary = "a declaration fills blanks of a known parameter and contradicts nothing",
    .reference = "D13",
    .why =
        "The shipped catalogue holds what the manuals print. If a governor really differs there, its "
        "numbers mean something else too, and it needs a catalogue of its own.",
    .bad =
        "[[governor.declare]]\n"
        "number = 2000\n"
        "name = \"BoilerLevel\"\n"
        "kind = \"measurement\"\n"
        "width = 16\n"
        "signed = false\n",
    .good =
        "[[governor.declare]]\n"
        "number = 2990\n"
        "name = \"BoilerLevel\"\n"
        "kind = \"measurement\"\n"
        "width = 16\n"
        "signed = false\n"};
const Rule network_node_duplicate{
    .code = "E0115",
    .name = "network-node-duplicate",
    .level = Level::error,
    .summary = "a node is listed once",
    .reference = "",
    .why =
        "The list says which other nodes are on the bus. A number that stands there twice is a slip for "
        "a node that is then not looked after, or two nodes share an id.",
    .bad =
        "[network]\n"
        "nodes = [2, 3, 2]\n",
    .good =
        "[network]\n"
        "nodes = [2, 3, 4]\n"};

}  // namespace cgw::diagnostic::rules
