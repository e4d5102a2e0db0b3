// E0810..E0817: what an EDS or DCF says of objects.
#include "diagnostic/rules/eds.hpp"

namespace cgw::diagnostic::rules {

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
