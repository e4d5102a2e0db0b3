// E0801..E0809: electronic data sheets and configuration files (EDS, DCF) as text: sections, keys, numbers.
#include "diagnostic/rules/eds.hpp"

namespace cgw::diagnostic::rules {

const Rule eds_text{
    .code = "E0801",
    .name = "eds-text",
    .level = Level::error,
    .summary = "an EDS or DCF is text with sections of CiA 306, one byte per character",
    .reference = "",
    .why =
        "Nothing can be read from another kind of file, be it made of sections as well, or from one saved as "
        "UTF-16. A byte 0 inside an EDS means that it was damaged on its way.",
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

}  // namespace cgw::diagnostic::rules
