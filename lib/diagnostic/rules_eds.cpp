// E08: electronic data sheets and configuration files (EDS, DCF), as they are read.
#include "diagnostic/rules.hpp"

namespace cgw::diagnostic::rules {

const Rule eds_text{
    .code = "E0801",
    .name = "eds-text",
    .level = Level::error,
    .summary = "an EDS or DCF is text with sections, one byte per character",
    .reference = "",
    .why =
        "Nothing can be read from another kind of file, or from one saved as UTF-16. A byte 0 inside an "
        "EDS means that it was damaged on its way.",
    .example = Example::none,
    .bad = "",
    .good = ""};
const Rule eds_line{
    .code = "E0802",
    .name = "eds-line",
    .level = Level::warning,
    .summary = "every line is a section, an entry of one, or a comment",
    .reference = "",
    .why =
        "cgw passes over any other line; some tools stop there. Most often it is the rest of a long "
        "text, or an entry that has lost its equals sign.",
    .example = Example::data_sheet,
    .bad =
        "[2000]\n"
        "ParameterName=Value\n"
        "ObjectType=0x7\n"
        "DataType=0x0007\n"
        "AccessType=ro\n"
        "DefaultValue 5\n",
    .good =
        "[2000]\n"
        "ParameterName=Value\n"
        "ObjectType=0x7\n"
        "DataType=0x0007\n"
        "AccessType=ro\n"
        "DefaultValue=5\n"};
const Rule eds_header{
    .code = "E0803",
    .name = "eds-header",
    .level = Level::error,
    .summary = "the name of a section stands between [ and ]",
    .reference = "",
    .why = "Where the name ends can only be guessed, and so can which object the entries below belong to.",
    .example = Example::data_sheet,
    .bad =
        "[2000\n"
        "ParameterName=Value\n"
        "ObjectType=0x7\n"
        "DataType=0x0007\n"
        "AccessType=ro\n",
    .good =
        "[2000]\n"
        "ParameterName=Value\n"
        "ObjectType=0x7\n"
        "DataType=0x0007\n"
        "AccessType=ro\n"};
const Rule eds_section_twice{
    .code = "E0804",
    .name = "eds-section-twice",
    .level = Level::error,
    .summary = "a section stands in a file once",
    .reference = "",
    .why =
        "Of two sections with one name some tools take the first, some the last, and some mix their "
        "entries: the same file describes two devices. cgw reads the first.",
    .example = Example::data_sheet,
    .bad =
        "[2000]\n"
        "ParameterName=Value\n"
        "ObjectType=0x7\n"
        "DataType=0x0007\n"
        "AccessType=ro\n"
        "DefaultValue=1\n"
        "[2000]\n"
        "ParameterName=Value\n"
        "ObjectType=0x7\n"
        "DataType=0x0007\n"
        "AccessType=ro\n"
        "DefaultValue=2\n",
    .good =
        "[2000]\n"
        "ParameterName=Value\n"
        "ObjectType=0x7\n"
        "DataType=0x0007\n"
        "AccessType=ro\n"
        "DefaultValue=1\n"
        "[2001]\n"
        "ParameterName=Value\n"
        "ObjectType=0x7\n"
        "DataType=0x0007\n"
        "AccessType=ro\n"
        "DefaultValue=2\n"};
const Rule eds_key_twice{
    .code = "E0805",
    .name = "eds-key-twice",
    .level = Level::error,
    .summary = "a key stands in a section once",
    .reference = "",
    .why = "Of two entries with one key some tools take the first and some the last. cgw reads the first.",
    .example = Example::data_sheet,
    .bad =
        "[2000]\n"
        "ParameterName=Value\n"
        "ObjectType=0x7\n"
        "DataType=0x0007\n"
        "AccessType=ro\n"
        "DefaultValue=1\n"
        "DefaultValue=2\n",
    .good =
        "[2000]\n"
        "ParameterName=Value\n"
        "ObjectType=0x7\n"
        "DataType=0x0007\n"
        "AccessType=ro\n"
        "DefaultValue=1\n"};
const Rule eds_value{
    .code = "E0806",
    .name = "eds-value",
    .level = Level::error,
    .summary = "a value is written as its data type demands",
    .reference = "",
    .why =
        "Numbers are decimal, 0x.. for hexadecimal or octal with a leading 0; octet strings are pairs of "
        "hexadecimal digits. Importers turn anything else into 0 without a word.",
    .example = Example::data_sheet,
    .bad =
        "[2000]\n"
        "ParameterName=Value\n"
        "ObjectType=0x7\n"
        "DataType=0x0007\n"
        "AccessType=ro\n"
        "DefaultValue=5,0\n",
    .good =
        "[2000]\n"
        "ParameterName=Value\n"
        "ObjectType=0x7\n"
        "DataType=0x0007\n"
        "AccessType=ro\n"
        "DefaultValue=5\n"};
const Rule eds_number_range{
    .code = "E0807",
    .name = "eds-number-range",
    .level = Level::error,
    .summary = "a number fits into its data type, or into what its key can state",
    .reference = "",
    .why =
        "The device cannot hold the value. What a configuration tool makes of it, and writes to the "
        "device, is its own choice.",
    .example = Example::data_sheet,
    .bad =
        "[2000]\n"
        "ParameterName=Value\n"
        "ObjectType=0x7\n"
        "DataType=0x0005\n"
        "AccessType=ro\n"
        "DefaultValue=0x1FF\n",
    .good =
        "[2000]\n"
        "ParameterName=Value\n"
        "ObjectType=0x7\n"
        "DataType=0x0005\n"
        "AccessType=ro\n"
        "DefaultValue=0xFF\n"};
const Rule eds_number_form{
    .code = "E0808",
    .name = "eds-number-form",
    .level = Level::warning,
    .summary = "numbers are written as CiA 306 has them",
    .reference = "D41",
    .why =
        "A prefix written twice, a suffix of the language C or blanks can be understood, and cgw does; a "
        "widely used reader makes 0 of them.",
    .example = Example::data_sheet,
    .bad =
        "[2000]\n"
        "ParameterName=Value\n"
        "ObjectType=0x7\n"
        "DataType=0x0007\n"
        "AccessType=ro\n"
        "DefaultValue=0x0x12\n",
    .good =
        "[2000]\n"
        "ParameterName=Value\n"
        "ObjectType=0x7\n"
        "DataType=0x0007\n"
        "AccessType=ro\n"
        "DefaultValue=0x12\n"};
const Rule eds_formula{
    .code = "E0809",
    .name = "eds-formula",
    .level = Level::warning,
    .summary = "a value that follows the node number is $NODEID+number, in capitals and without blanks",
    .reference = "",
    .why =
        "cgw understands the other orders and spellings. Some importers do not, and give all nodes the "
        "same identifier.",
    .example = Example::data_sheet,
    .bad =
        "[2000]\n"
        "ParameterName=Value\n"
        "ObjectType=0x7\n"
        "DataType=0x0007\n"
        "AccessType=ro\n"
        "DefaultValue=0x180+$NODEID\n",
    .good =
        "[2000]\n"
        "ParameterName=Value\n"
        "ObjectType=0x7\n"
        "DataType=0x0007\n"
        "AccessType=ro\n"
        "DefaultValue=$NODEID+0x180\n"};
const Rule eds_access_type{
    .code = "E0810",
    .name = "eds-access-type",
    .level = Level::error,
    .summary = "an access type is ro, wo, rw, rwr, rww or const",
    .reference = "",
    .why =
        "Nobody can say whether the object may be written, and a tool that guesses may write what must "
        "not be written.",
    .example = Example::data_sheet,
    .bad =
        "[2000]\n"
        "ParameterName=Value\n"
        "ObjectType=0x7\n"
        "DataType=0x0007\n"
        "AccessType=readonly\n",
    .good =
        "[2000]\n"
        "ParameterName=Value\n"
        "ObjectType=0x7\n"
        "DataType=0x0007\n"
        "AccessType=ro\n"};
const Rule eds_data_type{
    .code = "E0811",
    .name = "eds-data-type",
    .level = Level::error,
    .summary = "a data type is one of CiA 301",
    .reference = "",
    .why =
        "Length and meaning of the value are unknown without it. Types that a manufacturer defines stand "
        "at indices of their own and are no types of single values.",
    .example = Example::data_sheet,
    .bad =
        "[2000]\n"
        "ParameterName=Value\n"
        "ObjectType=0x7\n"
        "DataType=0x0030\n"
        "AccessType=ro\n",
    .good =
        "[2000]\n"
        "ParameterName=Value\n"
        "ObjectType=0x7\n"
        "DataType=0x0007\n"
        "AccessType=ro\n"};
const Rule eds_object_type{
    .code = "E0812",
    .name = "eds-object-type",
    .level = Level::error,
    .summary = "an object type is one of CiA 301 and allows for the sub-objects that stand in the file",
    .reference = "",
    .why =
        "Object type 7 (VAR) is one value, 8 (ARRAY) and 9 (RECORD) have sub-objects. Where the type "
        "says otherwise than the sections, some tools lose the sub-objects.",
    .example = Example::data_sheet,
    .bad =
        "[2000]\n"
        "ParameterName=Value\n"
        "ObjectType=0x7\n"
        "DataType=0x0007\n"
        "AccessType=ro\n"
        "[2000sub0]\n"
        "ParameterName=Value\n"
        "ObjectType=0x7\n"
        "DataType=0x0005\n"
        "AccessType=ro\n",
    .good =
        "[2000]\n"
        "ParameterName=Value\n"
        "ObjectType=0x9\n"
        "SubNumber=1\n"
        "[2000sub0]\n"
        "ParameterName=Value\n"
        "ObjectType=0x7\n"
        "DataType=0x0005\n"
        "AccessType=ro\n"};
const Rule eds_key_absent{
    .code = "E0813",
    .name = "eds-key-absent",
    .level = Level::error,
    .summary = "each value states its DataType and its AccessType",
    .reference = "",
    .why = "Without them nobody can read or write the value. cgw leaves such an object out.",
    .example = Example::data_sheet,
    .bad =
        "[2000]\n"
        "ParameterName=Value\n"
        "ObjectType=0x7\n"
        "DataType=0x0007\n",
    .good =
        "[2000]\n"
        "ParameterName=Value\n"
        "ObjectType=0x7\n"
        "DataType=0x0007\n"
        "AccessType=ro\n"};
const Rule eds_section_alone{
    .code = "E0814",
    .name = "eds-section-alone",
    .level = Level::error,
    .summary = "a sub-object, or a list of values, belongs to an object that stands in the file",
    .reference = "",
    .why = "Its object was removed, or the index in the name of the section is wrong.",
    .example = Example::data_sheet,
    .bad =
        "[2000sub1]\n"
        "ParameterName=Value\n"
        "ObjectType=0x7\n"
        "DataType=0x0007\n"
        "AccessType=ro\n",
    .good =
        "[2000]\n"
        "ParameterName=Value\n"
        "ObjectType=0x9\n"
        "SubNumber=1\n"
        "[2000sub1]\n"
        "ParameterName=Value\n"
        "ObjectType=0x7\n"
        "DataType=0x0007\n"
        "AccessType=ro\n"};
const Rule eds_entry_alone{.code = "E0815",
                           .name = "eds-entry-alone",
                           .level = Level::error,
                           .summary = "a name, value or denotation in a list belongs to a sub-object",
                           .reference = "",
                           .why = "The value would be lost: no object of the device takes it.",
                           .example = Example::data_sheet,
                           .bad =
                               "[2000]\n"
                               "ParameterName=Value\n"
                               "ObjectType=0x8\n"
                               "CompactSubObj=2\n"
                               "DataType=0x0007\n"
                               "AccessType=rw\n"
                               "[2000Value]\n"
                               "NrOfEntries=1\n"
                               "3=5\n",
                           .good =
                               "[2000]\n"
                               "ParameterName=Value\n"
                               "ObjectType=0x8\n"
                               "CompactSubObj=2\n"
                               "DataType=0x0007\n"
                               "AccessType=rw\n"
                               "[2000Value]\n"
                               "NrOfEntries=1\n"
                               "2=5\n"};
const Rule eds_spelling{
    .code = "E0816",
    .name = "eds-spelling",
    .level = Level::warning,
    .summary = "keys and sections are spelt as CiA 306 spells them",
    .reference = "D41",
    .why =
        "cgw knows the usual misspellings and reads them as they were meant. Other tools pass over them "
        "without a word, and what they state is lost. The standard itself writes DeviceComissioning with "
        "one m.",
    .example = Example::data_sheet,
    .bad =
        "[DeviceCommissioning]\n"
        "NodeID=5\n",
    .good =
        "[DeviceComissioning]\n"
        "NodeID=5\n"};
const Rule eds_too_much{
    .code = "E0817",
    .name = "eds-too-much",
    .level = Level::error,
    .summary = "the objects of a file have at most 1000000 sub-objects together",
    .reference = "",
    .why = "No device has so many. A file that says so is damaged, or made to exhaust whoever reads it.",
    .example = Example::none,
    .bad = "",
    .good = ""};

}  // namespace cgw::diagnostic::rules
