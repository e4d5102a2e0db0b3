// E0880..E0888: PDOs of an EDS or DCF, as checked.
#include "diagnostic/rules/eds_check.hpp"

namespace cgw::diagnostic::rules {

const Rule eds_mapped_absent{
    .code = "E0880",
    .name = "eds-mapped-absent",
    .level = Level::error,
    .summary = "what a PDO maps exists",
    .reference = "CiA 301",
    .why = "The device that the file describes cannot send or receive the PDO, and importers fail on it.",
    .example = Example::data_sheet_lines,
    .bad =
        "[1A00sub1]\n"
        "DefaultValue=0x20010310\n",
    .good =
        "[1A00sub1]\n"
        "DefaultValue=0x20010110\n"};
const Rule eds_mapped_length{.code = "E0881",
                             .name = "eds-mapped-length",
                             .level = Level::error,
                             .summary = "what a PDO maps has the length of its data type",
                             .reference = "CiA 301",
                             .why = "All that follows in the PDO is read from the wrong place.",
                             .example = Example::data_sheet_lines,
                             .bad =
                                 "[1A00sub1]\n"
                                 "DefaultValue=0x20010108\n",
                             .good =
                                 "[1A00sub1]\n"
                                 "DefaultValue=0x20010110\n"};
const Rule eds_mapped_refused{
    .code = "E0882",
    .name = "eds-mapped-refused",
    .level = Level::warning,
    .summary = "what a PDO maps can be mapped",
    .reference = "CiA 306",
    .why = "The object says that it cannot be. Importers drop the entry or the whole PDO.",
    .example = Example::data_sheet_lines,
    .bad =
        "[2001sub1]\n"
        "PDOMapping=0\n",
    .good =
        "[2001sub1]\n"
        "PDOMapping=1\n"};
const Rule eds_mapped_direction{
    .code = "E0883",
    .name = "eds-mapped-direction",
    .level = Level::warning,
    .summary = "a transmit PDO maps what can be read, a receive PDO what can be written",
    .reference = "CiA 306",
    .why =
        "A receive PDO maps wo, rw or rww, a transmit PDO ro, rw, rwr or const. Strict importers refuse the "
        "rest.",
    .example = Example::data_sheet_lines,
    .bad =
        "[2000]\n"
        "AccessType=ro\n",
    .good =
        "[2000]\n"
        "AccessType=rww\n"};
const Rule eds_dummy{.code = "E0884",
                     .name = "eds-dummy",
                     .level = Level::warning,
                     .summary = "a dummy is mapped into a receive PDO, and DummyUsage allows it",
                     .reference = "CiA 306",
                     .why =
                         "A data type as mapped object passes over bytes of what is received. Importers "
                         "refuse one that the device is not said to support.",
                     .example = Example::data_sheet_lines,
                     .bad =
                         "[1600sub0]\n"
                         "DefaultValue=0x02\n"
                         "[1600sub2]\n"
                         "DefaultValue=0x00060010\n",
                     .good =
                         "[1600sub0]\n"
                         "DefaultValue=0x02\n"
                         "[1600sub2]\n"
                         "DefaultValue=0x00050008\n"};
const Rule eds_mapped_bits{.code = "E0885",
                           .name = "eds-mapped-bits",
                           .level = Level::error,
                           .summary = "a PDO has at most 64 bits",
                           .reference = "CiA 301",
                           .why = "A CAN frame has no room for more, and the device refuses the mapping.",
                           .example = Example::data_sheet_lines,
                           .bad =
                               "[1A00sub0]\n"
                               "DefaultValue=0x05\n"
                               "[1A00sub3]\n"
                               "DefaultValue=0x20010110\n"
                               "[1A00sub4]\n"
                               "DefaultValue=0x20010110\n"
                               "[1A00sub5]\n"
                               "DefaultValue=0x20010110\n",
                           .good =
                               "[1A00sub0]\n"
                               "DefaultValue=0x04\n"
                               "[1A00sub3]\n"
                               "DefaultValue=0x20010110\n"
                               "[1A00sub4]\n"
                               "DefaultValue=0x20010110\n"};
const Rule eds_mapped_count{
    .code = "E0886",
    .name = "eds-mapped-count",
    .level = Level::warning,
    .summary = "as many entries of a mapping are in use as stand in the file",
    .reference = "CiA 301",
    .why = "Sub-object 0 of a mapping counts the entries in use. The others would be read from nowhere.",
    .example = Example::data_sheet_lines,
    .bad =
        "[1600sub0]\n"
        "DefaultValue=0x03\n"
        "[1600sub2]\n"
        "DefaultValue=0x00050008\n",
    .good =
        "[1600sub0]\n"
        "DefaultValue=0x02\n"
        "[1600sub2]\n"
        "DefaultValue=0x00050008\n"};
const Rule eds_pdo_pair{.code = "E0887",
                        .name = "eds-pdo-pair",
                        .level = Level::warning,
                        .summary = "a PDO has a communication and a mapping parameter",
                        .reference = "CiA 301",
                        .why =
                            "Without the one nobody knows when and under which identifier it is sent, "
                            "without the other what it carries.",
                        .example = Example::data_sheet_lines,
                        .bad =
                            "[OptionalObjects]\n"
                            "SupportedObjects=8\n"
                            "8=0x1A01\n"
                            "[1A01]\n"
                            "ParameterName=TPDO2 Mapping\n"
                            "ObjectType=0x9\n"
                            "SubNumber=1\n"
                            "[1A01sub0]\n"
                            "ParameterName=Entries\n"
                            "ObjectType=0x7\n"
                            "DataType=0x0005\n"
                            "AccessType=ro\n"
                            "DefaultValue=0x00\n",
                        .good =
                            "[OptionalObjects]\n"
                            "SupportedObjects=7\n"};
const Rule eds_transmission_type{.code = "E0888",
                                 .name = "eds-transmission-type",
                                 .level = Level::warning,
                                 .summary = "the transmission type of a PDO is not a reserved one",
                                 .reference = "CiA 301",
                                 .why =
                                     "241 to 251 are reserved, 252 and 253 are for transmit PDOs only. A "
                                     "device that keeps to CiA 301 refuses them.",
                                 .example = Example::data_sheet_lines,
                                 .bad =
                                     "[1400sub2]\n"
                                     "DefaultValue=0xFC\n",
                                 .good =
                                     "[1400sub2]\n"
                                     "DefaultValue=0xFE\n"};

}  // namespace cgw::diagnostic::rules
