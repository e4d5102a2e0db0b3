// E0820..E0827: an EDS or DCF as text, as checked.
#include "diagnostic/rules/eds_check.hpp"

namespace cgw::diagnostic::rules {

const Rule eds_line_length{
    .code = "E0820",
    .name = "eds-line-length",
    .level = Level::warning,
    .summary = "a line has at most 255 characters",
    .reference = "CiA 306",
    .why =
        "Readers with a buffer of that length cut the line or take its rest for a line of its own. The "
        "longest text of each key follows from this: 241 characters for a ParameterName, 243 for a "
        "Description.",
    .example = Example::data_sheet_lines,
    .bad =
        "[1000]\n"
        "ParameterName=Device Type, Device Type, Device Type, Device Type, Device Type, Device Type, Device "
        "Type, Device Type, Device Type, Device Type, Device Type, Device Type, Device Type, Device Type, "
        "Device Type, Device Type, Device Type, Device Type, Device Type, Device Type, \n",
    .good =
        "[1000]\n"
        "ParameterName=Device Type\n"};
const Rule eds_character{.code = "E0821",
                         .name = "eds-character",
                         .level = Level::warning,
                         .summary = "an EDS consists of characters of ASCII",
                         .reference = "CiA 306",
                         .why =
                             "What a byte above 127 stands for depends on the reader: one takes it for "
                             "Latin-1, another for UTF-8, and some stop there. Write ae, ue, degC.",
                         .example = Example::data_sheet_lines,
                         .bad =
                             "[1000]\n"
                             "ParameterName=Ger\xC3\xA4"
                             "t\n",
                         .good =
                             "[1000]\n"
                             "ParameterName=Geraet\n"};
const Rule eds_byte_order_mark{
    .code = "E0822",
    .name = "eds-byte-order-mark",
    .level = Level::warning,
    .summary = "an EDS begins with its first section or a comment, not with a byte order mark",
    .reference = "CiA 306",
    .why =
        "Readers that do not know the mark take it for a part of the first line, and do not find the first "
        "section.",
    .example = Example::none,
    .bad = "",
    .good = ""};
const Rule eds_comment_mark{
    .code = "E0823",
    .name = "eds-comment-mark",
    .level = Level::warning,
    .summary = "a comment begins with ; in the first column",
    .reference = "CiA 306",
    .why =
        "With another mark, or behind blanks, the line is an entry for some readers, and others stop there.",
    .example = Example::data_sheet_lines,
    .bad =
        "[1000]\n"
        "#the profile\n",
    .good =
        "[1000]\n"
        ";the profile\n"};
const Rule eds_line_ends{.code = "E0824",
                         .name = "eds-line-ends",
                         .level = Level::note,
                         .summary = "all lines end alike, with LF or CRLF",
                         .reference = "CiA 306",
                         .why =
                             "Most readers do not mind. Tools that compare or merge files show lines that "
                             "nobody changed, and a reader of CR alone is rare.",
                         .example = Example::none,
                         .bad = "",
                         .good = ""};
const Rule eds_blanks{
    .code = "E0825",
    .name = "eds-blanks",
    .level = Level::warning,
    .summary = "a section or key begins in the first column, and the equals sign follows the key at once",
    .reference = "CiA 306",
    .why = "Some readers look for the key with the blank behind it, and take the entry for a missing one.",
    .example = Example::data_sheet_lines,
    .bad =
        "[1000]\n"
        "DataType =0x0007\n",
    .good =
        "[1000]\n"
        "DataType=0x0007\n"};
const Rule eds_header_tail{.code = "E0826",
                           .name = "eds-header-tail",
                           .level = Level::note,
                           .summary = "nothing stands behind the name of a section",
                           .reference = "CiA 306",
                           .why =
                               "It is no comment: a semicolon begins one in the first column only. Some "
                               "readers do not find the section then.",
                           .example = Example::data_sheet_lines,
                           .bad =
                               "[2010] ;spare\n"
                               "ParameterName=Spare\n"
                               "ObjectType=0x7\n"
                               "DataType=0x0007\n"
                               "AccessType=ro\n"
                               "DefaultValue=0x00000000\n"
                               "[ManufacturerObjects]\n"
                               "SupportedObjects=3\n"
                               "3=0x2010\n",
                           .good =
                               "[2010]\n"
                               "ParameterName=Spare\n"
                               "ObjectType=0x7\n"
                               "DataType=0x0007\n"
                               "AccessType=ro\n"
                               "DefaultValue=0x00000000\n"
                               "[ManufacturerObjects]\n"
                               "SupportedObjects=3\n"
                               "3=0x2010\n"};
const Rule eds_semicolon{
    .code = "E0827",
    .name = "eds-semicolon",
    .level = Level::note,
    .summary = "a value has no semicolon",
    .reference = "CiA 306",
    .why = "Many readers take it for the beginning of a comment and cut the value there.",
    .example = Example::data_sheet_lines,
    .bad =
        "[1000]\n"
        "ParameterName=Device Type; profile\n",
    .good =
        "[1000]\n"
        "ParameterName=Device Type, profile\n"};

}  // namespace cgw::diagnostic::rules
