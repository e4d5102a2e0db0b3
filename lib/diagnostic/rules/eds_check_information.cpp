// E0867..E0879: what an EDS or DCF says of itself, device and node, as checked.
#include "diagnostic/rules/eds_check.hpp"

namespace cgw::diagnostic::rules {

const Rule eds_file_name{.code = "E0867",
                         .name = "eds-file-name",
                         .level = Level::note,
                         .summary = "FileName is the name of the file",
                         .reference = "CiA 306",
                         .why =
                             "Upper and lower case do not matter. Tools that copy data sheets into a library "
                             "find them under the other name, or twice.",
                         .example = Example::data_sheet_lines,
                         .bad =
                             "[FileInfo]\n"
                             "FileName=other.eds\n",
                         .good =
                             "[FileInfo]\n"
                             "FileName=example.eds\n"};
const Rule eds_version{.code = "E0868",
                       .name = "eds-version",
                       .level = Level::warning,
                       .summary = "EDSVersion is 4.0, in old files 3.0",
                       .reference = "CiA 306, D41",
                       .why = "Importers that look at it compare the text, and refuse 4 or 4.04.",
                       .example = Example::data_sheet_lines,
                       .bad =
                           "[FileInfo]\n"
                           "EDSVersion=4\n",
                       .good =
                           "[FileInfo]\n"
                           "EDSVersion=4.0\n"};
const Rule eds_date{.code = "E0869",
                    .name = "eds-date",
                    .level = Level::note,
                    .summary = "a date is mm-dd-yyyy",
                    .reference = "CiA 306",
                    .why = "Month first, with two digits each, and a day that the month has.",
                    .example = Example::data_sheet_lines,
                    .bad =
                        "[FileInfo]\n"
                        "CreationDate=15-Jan-2024\n",
                    .good =
                        "[FileInfo]\n"
                        "CreationDate=01-15-2024\n"};
const Rule eds_time{
    .code = "E0870",
    .name = "eds-time",
    .level = Level::note,
    .summary = "a time is hh:mmAM or hh:mmPM",
    .reference = "CiA 306, D41",
    .why = "Twelve hours with two digits: midnight is 12:00AM. Strict importers refuse others.",
    .example = Example::data_sheet_lines,
    .bad =
        "[FileInfo]\n"
        "CreationTime=00:00AM\n",
    .good =
        "[FileInfo]\n"
        "CreationTime=12:00AM\n"};
const Rule eds_identity{.code = "E0871",
                        .name = "eds-identity",
                        .level = Level::warning,
                        .summary = "DeviceInfo and 1018h say the same of vendor, product and revision",
                        .reference = "CiA 306",
                        .why =
                            "Tools look for the data sheet of a device by what it answers at 1018h, and "
                            "compare that with DeviceInfo: they do not find this one.",
                        .example = Example::data_sheet_lines,
                        .bad =
                            "[DeviceInfo]\n"
                            "ProductNumber=0x00000003\n",
                        .good =
                            "[DeviceInfo]\n"
                            "ProductNumber=0x00000002\n"};
const Rule eds_bit_rates{.code = "E0872",
                         .name = "eds-bit-rates",
                         .level = Level::warning,
                         .summary = "the device supports a bit rate",
                         .reference = "CiA 306",
                         .why = "A network tool offers no bit rate for it.",
                         .example = Example::data_sheet_lines,
                         .bad =
                             "[DeviceInfo]\n"
                             "BaudRate_125=0\n"
                             "BaudRate_250=0\n"
                             "BaudRate_500=0\n",
                         .good =
                             "[DeviceInfo]\n"
                             "BaudRate_125=0\n"
                             "BaudRate_250=1\n"};
const Rule eds_granularity{
    .code = "E0873",
    .name = "eds-granularity",
    .level = Level::warning,
    .summary = "Granularity is 0 to 64",
    .reference = "CiA 306",
    .why =
        "It is the length in bits of the smallest piece that can be mapped; 0 means that mappings are fixed.",
    .example = Example::data_sheet_lines,
    .bad =
        "[DeviceInfo]\n"
        "Granularity=128\n",
    .good =
        "[DeviceInfo]\n"
        "Granularity=8\n"};
const Rule eds_pdo_count{
    .code = "E0874",
    .name = "eds-pdo-count",
    .level = Level::warning,
    .summary = "NrOfRXPDO and NrOfTXPDO are the numbers of PDOs in the file",
    .reference = "CiA 306",
    .why = "Importers make room for as many PDOs as these say, and lose the others or refuse the file.",
    .example = Example::data_sheet_lines,
    .bad =
        "[DeviceInfo]\n"
        "NrOfTXPDO=2\n",
    .good =
        "[DeviceInfo]\n"
        "NrOfTXPDO=1\n"};
const Rule eds_lss{.code = "E0875",
                   .name = "eds-lss",
                   .level = Level::warning,
                   .summary = "a device with LSS has a serial number at 1018h:4",
                   .reference = "CiA 305",
                   .why = "LSS addresses a device by all four entries of its identity object.",
                   .example = Example::data_sheet_lines,
                   .bad =
                       "[DeviceInfo]\n"
                       "LSS_Supported=1\n"
                       "; [1018sub4]\n"
                       "[1018]\n"
                       "SubNumber=4\n"
                       "[1018sub0]\n"
                       "DefaultValue=0x03\n",
                   .good =
                       "[DeviceInfo]\n"
                       "LSS_Supported=1\n"};
const Rule eds_node_id{
    .code = "E0876",
    .name = "eds-node-id",
    .level = Level::error,
    .summary = "the node id of a configuration file is 1 to 127",
    .reference = "CiA 306",
    .why = "The configuration is one of no node, and every value that follows the node id is wrong.",
    .example = Example::data_sheet_lines,
    .bad =
        "[DeviceComissioning]\n"
        "NodeID=128\n",
    .good =
        "[DeviceComissioning]\n"
        "NodeID=12\n"};
const Rule eds_node_bit_rate{
    .code = "E0877",
    .name = "eds-node-bit-rate",
    .level = Level::warning,
    .summary = "the bit rate of the node is one that the device supports",
    .reference = "CiA 306",
    .why = "Baudrate is in kbit/s. Two nodes of different bit rates stop each other.",
    .example = Example::data_sheet_lines,
    .bad =
        "[DeviceComissioning]\n"
        "NodeID=12\n"
        "Baudrate=1000\n",
    .good =
        "[DeviceComissioning]\n"
        "NodeID=12\n"
        "Baudrate=500\n"};
const Rule eds_serial_number{
    .code = "E0878",
    .name = "eds-serial-number",
    .level = Level::warning,
    .summary = "LSS_SerialNumber is the serial number at 1018h:4",
    .reference = "CiA 306",
    .why = "One of them is of another device of the series: LSS finds the wrong one or none.",
    .example = Example::data_sheet_lines,
    .bad =
        "[DeviceComissioning]\n"
        "NodeID=12\n"
        "LSS_SerialNumber=7\n"
        "[1018sub4]\n"
        "DefaultValue=0x00000008\n",
    .good =
        "[DeviceComissioning]\n"
        "NodeID=12\n"
        "LSS_SerialNumber=8\n"
        "[1018sub4]\n"
        "DefaultValue=0x00000008\n"};
const Rule eds_configured_value{.code = "E0879",
                                .name = "eds-configured-value",
                                .level = Level::note,
                                .summary = "a ParameterValue stands in a configuration file",
                                .reference = "CiA 306",
                                .why =
                                    "A data sheet has defaults only. Tools pass over the value, or take the "
                                    "file for a configuration without a node.",
                                .example = Example::data_sheet_lines,
                                .bad =
                                    "[2000]\n"
                                    "ParameterValue=5\n",
                                .good =
                                    "[2000]\n"
                                    "ParameterValue=5\n"
                                    "[DeviceComissioning]\n"
                                    "NodeID=12\n"};

}  // namespace cgw::diagnostic::rules
