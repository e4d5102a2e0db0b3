// E0846..E0859: objects of an EDS or DCF, as checked.
#include "diagnostic/rules/eds_check.hpp"

namespace cgw::diagnostic::rules {

const Rule eds_key_use{.code = "E0846",
                       .name = "eds-key-use",
                       .level = Level::warning,
                       .summary = "an object has the keys of its type",
                       .reference = "CiA 306",
                       .why =
                           "DataType, AccessType and the like belong to a value, SubNumber to an ARRAY or "
                           "RECORD. Which of both the object is becomes a matter of opinion.",
                       .example = Example::data_sheet_lines,
                       .bad =
                           "[2001]\n"
                           "DataType=0x0003\n",
                       .good =
                           "[2001]\n"
                           "ParameterName=Values\n"};
const Rule eds_name_absent{.code = "E0847",
                           .name = "eds-name-absent",
                           .level = Level::warning,
                           .summary = "each object and sub-object has a ParameterName",
                           .reference = "CiA 306",
                           .why = "The key must be there. Tools show a nameless object, or refuse the file.",
                           .example = Example::data_sheet_lines,
                           .bad =
                               "[2000]\n"
                               "ParameterName=\n",
                           .good =
                               "[2000]\n"
                               "ParameterName=Setpoint\n"};
const Rule eds_names_equal{
    .code = "E0848",
    .name = "eds-names-equal",
    .level = Level::note,
    .summary = "the sub-objects of one object have different names",
    .reference = "",
    .why = "Tools that make variables of the names get the same one twice, and code that does not compile.",
    .example = Example::data_sheet_lines,
    .bad =
        "[2001sub2]\n"
        "ParameterName=Value 1\n",
    .good =
        "[2001sub2]\n"
        "ParameterName=Value 2\n"};
const Rule eds_object_type_absent{.code = "E0849",
                                  .name = "eds-object-type-absent",
                                  .level = Level::note,
                                  .summary = "each object and sub-object has an ObjectType",
                                  .reference = "CiA 306",
                                  .why = "VAR is meant where it is missing. Some importers do not know that.",
                                  .example = Example::data_sheet_lines,
                                  .bad =
                                      "[2000]\n"
                                      "; ObjectType=\n",
                                  .good =
                                      "[2000]\n"
                                      "ObjectType=0x7\n"};
const Rule eds_sub_number{.code = "E0850",
                          .name = "eds-sub-number",
                          .level = Level::warning,
                          .summary = "SubNumber is the number of sub-objects",
                          .reference = "CiA 306",
                          .why =
                              "It is a count, sub-index 0 included and FFh not, and no highest sub-index: "
                              "gaps are allowed. Importers that go by it lose what is beyond it.",
                          .example = Example::data_sheet_lines,
                          .bad =
                              "[2001]\n"
                              "SubNumber=2\n",
                          .good =
                              "[2001]\n"
                              "SubNumber=3\n"};
const Rule eds_sub_number_absent{
    .code = "E0851",
    .name = "eds-sub-number-absent",
    .level = Level::warning,
    .summary = "an ARRAY or RECORD has a SubNumber",
    .reference = "CiA 306",
    .why = "The key must be there. Importers take 0 for it and find no sub-objects.",
    .example = Example::data_sheet_lines,
    .bad =
        "[2001]\n"
        "; SubNumber=\n",
    .good =
        "[2001]\n"
        "SubNumber=3\n"};
const Rule eds_sub_0_absent{.code = "E0852",
                            .name = "eds-sub-0-absent",
                            .level = Level::warning,
                            .summary = "an ARRAY or RECORD has a sub-object 0",
                            .reference = "CiA 301",
                            .why =
                                "It says which sub-index is the highest. Masters that read it first get an "
                                "abort, and so does whoever trusts the file.",
                            .example = Example::data_sheet_lines,
                            .bad =
                                "; [2001sub0]\n"
                                "[2001]\n"
                                "SubNumber=2\n",
                            .good =
                                "[2001sub0]\n"
                                "DefaultValue=0x02\n"};
const Rule eds_sub_0_type{
    .code = "E0853",
    .name = "eds-sub-0-type",
    .level = Level::warning,
    .summary = "sub-object 0 is UNSIGNED8",
    .reference = "CiA 301",
    .why = "The number of entries is one byte. A master that asks for another length gets an abort.",
    .example = Example::data_sheet_lines,
    .bad =
        "[2001sub0]\n"
        "DataType=0x0006\n",
    .good =
        "[2001sub0]\n"
        "DataType=0x0005\n"};
const Rule eds_sub_0_value{.code = "E0854",
                           .name = "eds-sub-0-value",
                           .level = Level::warning,
                           .summary = "the value of sub-object 0 is the highest sub-index",
                           .reference = "CiA 301",
                           .why =
                               "Not a count, where there are gaps. Only 1003h and mappings count the entries "
                               "in use. Masters read as many sub-objects as it says.",
                           .example = Example::data_sheet_lines,
                           .bad =
                               "[2001sub0]\n"
                               "DefaultValue=0x03\n",
                           .good =
                               "[2001sub0]\n"
                               "DefaultValue=0x02\n"};
const Rule eds_default_absent{
    .code = "E0855",
    .name = "eds-default-absent",
    .level = Level::note,
    .summary = "sub-object 0 and the identity object have a DefaultValue",
    .reference = "D43",
    .why = "Tools that make code or a configuration of the file take 0, or write code that does not compile.",
    .example = Example::data_sheet_lines,
    .bad =
        "[2001sub0]\n"
        "; DefaultValue=\n",
    .good =
        "[2001sub0]\n"
        "DefaultValue=0x02\n"};
const Rule eds_array_types{.code = "E0856",
                           .name = "eds-array-types",
                           .level = Level::note,
                           .summary = "all sub-objects of an ARRAY have one data type",
                           .reference = "CiA 301",
                           .why =
                               "An object whose entries differ is a RECORD. Tools that make an array of it "
                               "give all entries the type of the first.",
                           .example = Example::data_sheet_lines,
                           .bad =
                               "[2001sub2]\n"
                               "DataType=0x0006\n",
                           .good =
                               "[2001sub2]\n"
                               "DataType=0x0003\n"};
const Rule eds_standard_code{
    .code = "E0857",
    .name = "eds-standard-code",
    .level = Level::warning,
    .summary = "identity, SDO and PDO parameters are RECORDs",
    .reference = "CiA 301, D41",
    .why = "CiA 301 lays them out as records. Code made from an array of mixed types does not compile.",
    .example = Example::data_sheet_lines,
    .bad =
        "[1200]\n"
        "ObjectType=0x8\n",
    .good =
        "[1200]\n"
        "ObjectType=0x9\n"};
const Rule eds_standard_type{
    .code = "E0858",
    .name = "eds-standard-type",
    .level = Level::error,
    .summary = "objects of the communication profile have the data type that CiA 301 gives them",
    .reference = "CiA 301",
    .why = "Masters write them in that length and get an abort from a device that is as the file says.",
    .example = Example::data_sheet_lines,
    .bad =
        "[1017]\n"
        "DataType=0x0007\n",
    .good =
        "[1017]\n"
        "DataType=0x0006\n"};
const Rule eds_access_case{.code = "E0859",
                           .name = "eds-access-case",
                           .level = Level::warning,
                           .summary = "an access type is written in lower case",
                           .reference = "CiA 306",
                           .why = "Strict importers refuse any other spelling.",
                           .example = Example::data_sheet_lines,
                           .bad =
                               "[2000]\n"
                               "AccessType=RWW\n",
                           .good =
                               "[2000]\n"
                               "AccessType=rww\n"};

}  // namespace cgw::diagnostic::rules
