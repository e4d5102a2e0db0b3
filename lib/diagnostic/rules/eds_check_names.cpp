// E0828..E0836: sections and keys of an EDS or DCF, as checked.
#include "diagnostic/rules/eds_check.hpp"

namespace cgw::diagnostic::rules {

const Rule eds_section_case{
    .code = "E0828",
    .name = "eds-section-case",
    .level = Level::note,
    .summary = "sections are spelt in the case of CiA 306",
    .reference = "CiA 306",
    .why = "Upper and lower case are the same by the standard, and not for every reader.",
    .example = Example::data_sheet_lines,
    .bad =
        "[dummyusage]\n"
        "Dummy0005=1\n"
        "; [DummyUsage]\n",
    .good =
        "[DummyUsage]\n"
        "Dummy0005=1\n"};
const Rule eds_sub_zero{.code = "E0829",
                        .name = "eds-sub-zero",
                        .level = Level::warning,
                        .summary = "the sub-index in the name of a section has no leading 0",
                        .reference = "CiA 306",
                        .why =
                            "Readers that make the name from the sub-index do not find the section: the "
                            "sub-object is lost without a word.",
                        .example = Example::data_sheet_lines,
                        .bad =
                            "; [2001sub2]\n"
                            "[2001sub02]\n"
                            "ParameterName=Value 2\n"
                            "ObjectType=0x7\n"
                            "DataType=0x0003\n"
                            "AccessType=ro\n"
                            "DefaultValue=0x0000\n"
                            "PDOMapping=1\n",
                        .good =
                            "[2001sub2]\n"
                            "ParameterName=Value 2\n"};
const Rule eds_section_unknown{.code = "E0830",
                               .name = "eds-section-unknown",
                               .level = Level::note,
                               .summary = "a section is one of CiA 306",
                               .reference = "CiA 306",
                               .why =
                                   "Others are allowed and passed over. If this one was to describe the "
                                   "device, most readers do not see it.",
                               .example = Example::data_sheet_lines,
                               .bad =
                                   "[VendorExtension]\n"
                                   "Colour=blue\n",
                               .good =
                                   "[Comments]\n"
                                   "Lines=2\n"
                                   "Line2=blue\n"};
const Rule eds_key_case{.code = "E0831",
                        .name = "eds-key-case",
                        .level = Level::warning,
                        .summary = "keys are spelt in the case of CiA 306",
                        .reference = "CiA 306, D41",
                        .why =
                            "Upper and lower case are the same by the standard. A widely used importer of "
                            "another opinion passes over the entry without a word.",
                        .example = Example::data_sheet_lines,
                        .bad =
                            "[1000]\n"
                            "; DefaultValue=\n"
                            "Defaultvalue=0x00000000\n",
                        .good =
                            "[1000]\n"
                            "DefaultValue=0x00000000\n"};
const Rule eds_key_misspelt{
    .code = "E0832",
    .name = "eds-key-misspelt",
    .level = Level::warning,
    .summary = "keys are spelt as CiA 306 spells them",
    .reference = "CiA 306",
    .why = "A key that nobody knows is passed over, and the one that was meant is missing.",
    .example = Example::data_sheet_lines,
    .bad =
        "[2000]\n"
        "; DefaultValue=\n"
        "DefautValue=0x0000\n",
    .good =
        "[2000]\n"
        "DefaultValue=0x0000\n"};
const Rule eds_key_unknown{
    .code = "E0833",
    .name = "eds-key-unknown",
    .level = Level::note,
    .summary = "a key is one that CiA 306 gives to its section",
    .reference = "CiA 306",
    .why = "Keys of vendors are allowed and passed over by most tools. Strict importers refuse the file.",
    .example = Example::data_sheet_lines,
    .bad =
        "[2000]\n"
        "Unit=rpm\n",
    .good =
        "[2000]\n"
        "ParameterName=Speed in rpm\n"};
const Rule eds_section_absent{
    .code = "E0834",
    .name = "eds-section-absent",
    .level = Level::error,
    .summary = "FileInfo, DeviceInfo and MandatoryObjects stand in the file",
    .reference = "CiA 306",
    .why = "Importers refuse a file without them: they cannot tell which device it is of.",
    .example = Example::data_sheet_lines,
    .bad = "; [FileInfo]\n",
    .good =
        "[FileInfo]\n"
        "FileVersion=2\n"};
const Rule eds_keys_absent{.code = "E0835",
                           .name = "eds-keys-absent",
                           .level = Level::warning,
                           .summary = "a section has the keys that its readers rely on",
                           .reference = "CiA 306",
                           .why = "Tools take 0 or nothing for what is missing, or refuse the file.",
                           .example = Example::data_sheet_lines,
                           .bad =
                               "[DeviceInfo]\n"
                               "; ProductName=\n",
                           .good =
                               "[DeviceInfo]\n"
                               "ProductName=Example\n"};
const Rule eds_commissioning_twice{
    .code = "E0836",
    .name = "eds-commissioning-twice",
    .level = Level::error,
    .summary = "the node is described once",
    .reference = "CiA 306",
    .why =
        "The standard itself writes DeviceComissioning with one m. Where both spellings stand, some tools "
        "configure the one node and some the other.",
    .example = Example::data_sheet_lines,
    .bad =
        "[DeviceComissioning]\n"
        "NodeID=5\n"
        "[DeviceCommissioning]\n"
        "NodeID=6\n",
    .good =
        "[DeviceComissioning]\n"
        "NodeID=5\n"};

}  // namespace cgw::diagnostic::rules
