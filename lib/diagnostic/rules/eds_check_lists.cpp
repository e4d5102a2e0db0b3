// E0837..E0845: lists of an EDS or DCF, as checked.
#include "diagnostic/rules/eds_check.hpp"

namespace cgw::diagnostic::rules {

const Rule eds_list_count{.code = "E0837",
                          .name = "eds-list-count",
                          .level = Level::warning,
                          .summary = "SupportedObjects is the number of entries of its list",
                          .reference = "CiA 306",
                          .why =
                              "Importers read as many entries as this says: the objects behind them are "
                              "lost, or ones that do not exist are asked for.",
                          .example = Example::data_sheet_lines,
                          .bad =
                              "[ManufacturerObjects]\n"
                              "SupportedObjects=3\n",
                          .good =
                              "[ManufacturerObjects]\n"
                              "SupportedObjects=2\n"};
const Rule eds_entry_count{
    .code = "E0838",
    .name = "eds-entry-count",
    .level = Level::warning,
    .summary = "NrOfEntries and ObjectLinks are the number of entries of their section",
    .reference = "CiA 306",
    .why = "Importers read as many entries as this says; what stands behind them is lost.",
    .example = Example::data_sheet_lines,
    .bad =
        "[2000ObjectLinks]\n"
        "ObjectLinks=2\n"
        "1=0x2001\n",
    .good =
        "[2000ObjectLinks]\n"
        "ObjectLinks=1\n"
        "1=0x2001\n"};
const Rule eds_comment_count{.code = "E0839",
                             .name = "eds-comment-count",
                             .level = Level::note,
                             .summary = "Lines is the number of lines of comment",
                             .reference = "CiA 306",
                             .why = "Tools show as many lines as this says.",
                             .example = Example::data_sheet_lines,
                             .bad =
                                 "[Comments]\n"
                                 "Lines=3\n",
                             .good =
                                 "[Comments]\n"
                                 "Lines=1\n"};
const Rule eds_list_numbers{.code = "E0840",
                            .name = "eds-list-numbers",
                            .level = Level::warning,
                            .summary = "the entries of a list are numbered from 1 without a gap",
                            .reference = "CiA 306",
                            .why = "Importers count from 1 and stop at the first number that is missing.",
                            .example = Example::data_sheet_lines,
                            .bad =
                                "[ManufacturerObjects]\n"
                                "; 2=\n"
                                "3=0x2001\n",
                            .good =
                                "[ManufacturerObjects]\n"
                                "2=0x2001\n"};
const Rule eds_listed_twice{.code = "E0841",
                            .name = "eds-listed-twice",
                            .level = Level::warning,
                            .summary = "an object is listed once",
                            .reference = "CiA 306",
                            .why = "Some importers make two objects of it, and some refuse the file.",
                            .example = Example::data_sheet_lines,
                            .bad =
                                "[ManufacturerObjects]\n"
                                "SupportedObjects=3\n"
                                "3=0x2001\n",
                            .good =
                                "[ManufacturerObjects]\n"
                                "SupportedObjects=2\n"
                                "2=0x2001\n"};
const Rule eds_listed_absent{
    .code = "E0842",
    .name = "eds-listed-absent",
    .level = Level::error,
    .summary = "an object that is listed has a section",
    .reference = "CiA 306",
    .why = "Importers look for the section and fail, or offer an object of which nothing is known.",
    .example = Example::data_sheet_lines,
    .bad =
        "[ManufacturerObjects]\n"
        "SupportedObjects=3\n"
        "3=0x2010\n",
    .good =
        "[ManufacturerObjects]\n"
        "SupportedObjects=3\n"
        "3=0x2010\n"
        "[2010]\n"
        "ParameterName=Spare\n"
        "ObjectType=0x7\n"
        "DataType=0x0006\n"
        "AccessType=ro\n"
        "DefaultValue=0x0000\n"};
const Rule eds_unlisted{
    .code = "E0843",
    .name = "eds-unlisted",
    .level = Level::warning,
    .summary = "an object that has a section is listed",
    .reference = "CiA 306",
    .why = "Importers that go by the lists do not have the object, others do: one file, two devices.",
    .example = Example::data_sheet_lines,
    .bad =
        "[2010]\n"
        "ParameterName=Spare\n"
        "ObjectType=0x7\n"
        "DataType=0x0006\n"
        "AccessType=ro\n"
        "DefaultValue=0x0000\n",
    .good =
        "[2010]\n"
        "ParameterName=Spare\n"
        "ObjectType=0x7\n"
        "DataType=0x0006\n"
        "AccessType=ro\n"
        "DefaultValue=0x0000\n"
        "[ManufacturerObjects]\n"
        "SupportedObjects=3\n"
        "3=0x2010\n"};
const Rule eds_wrong_list{
    .code = "E0844",
    .name = "eds-wrong-list",
    .level = Level::warning,
    .summary = "an object stands in the list for its index",
    .reference = "CiA 306",
    .why =
        "1000h, 1001h and 1018h are mandatory objects, 2000h to 5FFFh are the manufacturer's, all others "
        "optional. Importers that go by this do not find the object elsewhere.",
    .example = Example::data_sheet_lines,
    .bad =
        "[OptionalObjects]\n"
        "SupportedObjects=8\n"
        "8=0x2010\n"
        "[2010]\n"
        "ParameterName=Spare\n"
        "ObjectType=0x7\n"
        "DataType=0x0006\n"
        "AccessType=ro\n"
        "DefaultValue=0x0000\n",
    .good =
        "[ManufacturerObjects]\n"
        "SupportedObjects=3\n"
        "3=0x2010\n"
        "[2010]\n"
        "ParameterName=Spare\n"
        "ObjectType=0x7\n"
        "DataType=0x0006\n"
        "AccessType=ro\n"
        "DefaultValue=0x0000\n"};
const Rule eds_mandatory_object{.code = "E0845",
                                .name = "eds-mandatory-object",
                                .level = Level::error,
                                .summary = "1000h, 1001h and 1018h exist",
                                .reference = "CiA 301",
                                .why =
                                    "Every CANopen device has them. Masters identify the device by 1000h and "
                                    "1018h and refuse one that they cannot compare.",
                                .example = Example::data_sheet_lines,
                                .bad =
                                    "; [1001]\n"
                                    "[MandatoryObjects]\n"
                                    "SupportedObjects=2\n"
                                    "2=0x1018\n"
                                    "; 3=\n",
                                .good =
                                    "[MandatoryObjects]\n"
                                    "SupportedObjects=3\n"};

}  // namespace cgw::diagnostic::rules
