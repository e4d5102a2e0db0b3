// E0860..E0866: values of an EDS or DCF, as checked.
#include "diagnostic/rules/eds_check.hpp"

namespace cgw::diagnostic::rules {

const Rule eds_octal{.code = "E0860",
                     .name = "eds-octal",
                     .level = Level::warning,
                     .summary = "a number that is not octal has no leading 0",
                     .reference = "CiA 306",
                     .why =
                         "By the standard a leading 0 means octal: 010 is 8. Half of the tools read 10 all "
                         "the same, and hardly anybody means 8.",
                     .example = Example::data_sheet_lines,
                     .bad =
                         "[2000]\n"
                         "DefaultValue=010\n",
                     .good =
                         "[2000]\n"
                         "DefaultValue=8\n"};
const Rule eds_leading_zero{
    .code = "E0861",
    .name = "eds-leading-zero",
    .level = Level::note,
    .summary = "a decimal number has no leading 0",
    .reference = "CiA 306",
    .why = "It is octal by the standard. This one is the same number either way, the next one may not be.",
    .example = Example::data_sheet_lines,
    .bad =
        "[2000]\n"
        "DefaultValue=005\n",
    .good =
        "[2000]\n"
        "DefaultValue=5\n"};
const Rule eds_limits{.code = "E0862",
                      .name = "eds-limits",
                      .level = Level::error,
                      .summary = "LowLimit is not above HighLimit",
                      .reference = "",
                      .why = "No value is allowed then. Configuration tools refuse whatever is entered.",
                      .example = Example::data_sheet_lines,
                      .bad =
                          "[2000]\n"
                          "LowLimit=5\n"
                          "HighLimit=3\n",
                      .good =
                          "[2000]\n"
                          "LowLimit=0\n"
                          "HighLimit=3\n"};
const Rule eds_value_limits{
    .code = "E0863",
    .name = "eds-value-limits",
    .level = Level::warning,
    .summary = "values lie within their limits, with every node id within their type; ObjFlags has two bits",
    .reference = "",
    .why = "Either the value or the limit is wrong. Tools refuse the value that the device has.",
    .example = Example::data_sheet_lines,
    .bad =
        "[2000]\n"
        "DefaultValue=9\n"
        "HighLimit=3\n",
    .good =
        "[2000]\n"
        "DefaultValue=3\n"
        "HighLimit=3\n"};
const Rule eds_signed_value{
    .code = "E0864",
    .name = "eds-signed-value",
    .level = Level::note,
    .summary = "negative numbers have a sign",
    .reference = "CiA 306",
    .why =
        "In hexadecimal they are often written as the bits that the device holds. Most tools understand it; "
        "some take 0xFFFF for 65535, which INTEGER16 does not have.",
    .example = Example::data_sheet_lines,
    .bad =
        "[2001sub1]\n"
        "DefaultValue=0xFFFF\n",
    .good =
        "[2001sub1]\n"
        "DefaultValue=-1\n"};
const Rule eds_formula_place{
    .code = "E0818",
    .name = "eds-formula-place",
    .level = Level::warning,
    .summary = "a value that is the same for every node does not follow the node number",
    .reference = "CiA 301",
    .why =
        "The device type, the identity, the number of sub-objects, what is mapped into a PDO and when it is "
        "sent are those of the device. With $NODEID in them every node would be another device.",
    .example = Example::data_sheet_lines,
    .bad =
        "[1018sub0]\n"
        "DefaultValue=$NODEID+4\n",
    .good =
        "[1018sub0]\n"
        "DefaultValue=4\n"};
const Rule eds_mappable_rw{.code = "E0865",
                           .name = "eds-mappable-rw",
                           .level = Level::note,
                           .summary = "a mappable object that can be written is rwr or rww",
                           .reference = "CiA 306",
                           .why =
                               "rw does not say whether it goes into transmit or receive PDOs. Strict "
                               "importers refuse it or offer the object for neither.",
                           .example = Example::data_sheet_lines,
                           .bad =
                               "[2000]\n"
                               "AccessType=rw\n",
                           .good =
                               "[2000]\n"
                               "AccessType=rww\n"};
const Rule eds_mappable_type{.code = "E0866",
                             .name = "eds-mappable-type",
                             .level = Level::warning,
                             .summary = "a mappable object fits into a PDO",
                             .reference = "CiA 301",
                             .why = "A PDO has 8 bytes, and a DOMAIN no length at all.",
                             .example = Example::data_sheet_lines,
                             .bad =
                                 "[ManufacturerObjects]\n"
                                 "SupportedObjects=3\n"
                                 "3=0x2010\n"
                                 "[2010]\n"
                                 "ParameterName=Program\n"
                                 "ObjectType=0x2\n"
                                 "DataType=0x000F\n"
                                 "AccessType=ro\n"
                                 "PDOMapping=1\n",
                             .good =
                                 "[ManufacturerObjects]\n"
                                 "SupportedObjects=3\n"
                                 "3=0x2010\n"
                                 "[2010]\n"
                                 "ParameterName=Program\n"
                                 "ObjectType=0x2\n"
                                 "DataType=0x000F\n"
                                 "AccessType=ro\n"
                                 "PDOMapping=0\n"};

}  // namespace cgw::diagnostic::rules
