// E05: printed tables read in, files copied.
#include "diagnostic/rules/tables.hpp"

namespace cgw::diagnostic::rules {

const Rule table_row{
    .code = "E0501",
    .name = "table-row",
    .level = Level::error,
    .summary = "a row of a table has a parameter's number and its value",
    .reference = "GWM 7",
    .why =
        "A line that is nearly a row cannot be passed over: its parameter would be 0 in the file, and "
        "switched off in the device. So is a line that has something before the number, and a row in blanks "
        "whose name is not known: 902 Sensor 2 may end its name or hold the value 2.",
    .example = Example::table,
    .bad =
        "Number;Parameter;Value;Unit\n"
        "401;CanMyNodeNumber;1;\n"
        "4O3;CanCMNodeNumber;1;\n",
    .good =
        "Number;Parameter;Value;Unit\n"
        "401;CanMyNodeNumber;1;\n"
        "403;CanCMNodeNumber;1;\n"};
const Rule table_value_ambiguous{
    .code = "E0502",
    .name = "table-value-ambiguous",
    .level = Level::error,
    .summary = "a value in a table can be read in one way only",
    .reference = "D12, D15",
    .why =
        "1.000 is one or a thousand, depending on the country, and 282 without Hex is 282h or 11Ah. Of two "
        "columns of values, old and new, one is not meant. Each reading makes a plant that starts, and one "
        "of "
        "them is wrong.",
    .example = Example::table,
    .bad =
        "Number;Parameter;Value;Unit\n"
        "16480;CanOpRPDO1-4Cyc(0);1.000;ms\n",
    .good =
        "Number;Parameter;Value;Unit\n"
        "16480;CanOpRPDO1-4Cyc(0);1000;ms\n"};
const Rule table_ellipsis{
    .code = "E0503",
    .name = "table-ellipsis",
    .level = Level::error,
    .summary = "a table names every parameter that is not 0; no row stands for others",
    .reference = "GWM 7.1.2.2",
    .why =
        "Dots say that rows were left out, and not what they hold. A TPDO assigned in one of them would "
        "disappear without a word.",
    .example = Example::table,
    .bad =
        "Number;Parameter;Value;Unit\n"
        "16404;CanOpTPDO5Assign(0);0;\n"
        ":;:;:;\n"
        "16451;CanOpTPDO16Assign(3);0;\n",
    .good =
        "Number;Parameter;Value;Unit\n"
        "16404;CanOpTPDO5Assign(0);0;\n"
        "16451;CanOpTPDO16Assign(3);0;\n"};
const Rule table_unit{
    .code = "E0504",
    .name = "table-unit",
    .level = Level::error,
    .summary = "the unit of a row is the parameter's own",
    .reference = "GWM 7",
    .why =
        "A time of 1 s is not one of 1 ms, and 1000 Hex is no time at all. Values are read as they stand and "
        "never converted, so that the file shows what DcDesk shows.",
    .example = Example::table,
    .bad =
        "Number;Parameter;Value;Unit\n"
        "16480;CanOpRPDO1-4Cyc(0);1;s\n",
    .good =
        "Number;Parameter;Value;Unit\n"
        "16480;CanOpRPDO1-4Cyc(0);1000;ms\n"};
const Rule table_of_other_device{
    .code = "E0505",
    .name = "table-of-other-device",
    .level = Level::error,
    .summary = "each table is given for the device it was printed for",
    .reference = "D1",
    .why =
        "Numbers mean different things in the two devices: 16404 is what TPDO5 carries in the governor and "
        "the identifier of TPDO5 in the gateway.",
    .example = Example::table,
    .bad =
        "Number;Parameter;Value;Unit\n"
        "401;CanMyNodeNumber;1;\n"
        "402;CanDCNodeNumber;1;\n"
        "416;HzmCanBaudrate;250;\n",
    .good =
        "Number;Parameter;Value;Unit\n"
        "401;CanMyNodeNumber;1;\n"
        "403;CanCMNodeNumber;1;\n"
        "416;CanBaudrate;250;\n"};
const Rule table_empty{
    .code = "E0506",
    .name = "table-empty",
    .level = Level::error,
    .summary = "a table has at least one row of its device",
    .reference = "GWM 7",
    .why =
        "A file without a single row was most likely the wrong one, or its columns were lost when it was "
        "copied.",
    .example = Example::table,
    .bad = "Number;Parameter;Value;Unit\n",
    .good =
        "Number;Parameter;Value;Unit\n"
        "401;CanMyNodeNumber;1;\n"};
const Rule table_row_skipped{
    .code = "E0507",
    .name = "table-row-skipped",
    .level = Level::note,
    .summary = "rows that set nothing here are skipped: measurements, and what does not concern CANopen",
    .reference = "D16",
    .why =
        "A table printed from a running device holds measurements beside parameters. They belong to the "
        "moment of printing and not to the configuration. A print of a whole device also holds parameters "
        "that are not in the catalogue; a name or number that is nearly a known one is an error instead.",
    .example = Example::table,
    .bad =
        "Number;Parameter;Value;Unit\n"
        "401;CanMyNodeNumber;1;\n"
        "2000;Speed;1500;1/min\n",
    .good =
        "Number;Parameter;Value;Unit\n"
        "401;CanMyNodeNumber;1;\n"};
const Rule clone_identifier{
    .code = "E0508",
    .name = "clone-identifier",
    .level = Level::error,
    .summary = "a copy for the same CANopen network sends under identifiers of its own",
    .reference = "GWM 7.2.4, D30",
    .why =
        "Identifiers of TPDO5 to 16 do not follow the node id. Two gateways that send under the same one "
        "destroy each other's telegrams, and the receivers take one engine's values for the other's.",
    .example = Example::copied_file,
    .bad =
        "[governor.parameters]\n"
        "16404 = 2905                        # TPDO5\n"
        "16461 = 500\n"
        "[gateway.parameters]\n"
        "16404 = 0x6A5                       # not of the form 680h + node id: nobody can shift it\n",
    .good =
        "[governor.parameters]\n"
        "16404 = 2905\n"
        "16461 = 500\n"
        "[gateway.parameters]\n"
        "16404 = 0x681                       # 680h + 1 becomes 680h + the copy's node id\n"};
const Rule table_row_absent{
    .code = "E0509",
    .name = "table-row-absent",
    .level = Level::note,
    .summary = "a table prints every parameter that concerns CANopen; one without a row counts as 0",
    .reference = "GWM 7",
    .why =
        "The file leaves out what the table does not print, and that is 0, switched off. A print of one "
        "page, "
        "or of another user level, lacks rows that are not 0 in the device.",
    .example = Example::table_rows,
    .bad =
        "Number;Parameter;Value;Unit\n"
        "# 14401;CanOpenSendErrors;1;\n",
    .good =
        "Number;Parameter;Value;Unit\n"
        "14401;CanOpenSendErrors;1;\n"};

}  // namespace cgw::diagnostic::rules
