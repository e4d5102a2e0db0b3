// E0901..E0918: XML device descriptions and configurations (XDD, XDC).
#include "diagnostic/rules/xdd.hpp"

namespace cgw::diagnostic::rules {

const Rule xdd_text{.code = "E0901",
                    .name = "xdd-text",
                    .level = Level::error,
                    .summary = "an XDD or XDC is well-formed XML in UTF-8",
                    .reference = "",
                    .why =
                        "Nothing can be read from another kind of file, or from one that was damaged on its "
                        "way. A document type (DOCTYPE) is refused as well: a device description has none, "
                        "and what it declares could make other files part of this one.",
                    .example = Example::none,
                    .bad = "",
                    .good = ""};
const Rule xdd_root{
    .code = "E0902",
    .name = "xdd-root",
    .level = Level::error,
    .summary = "an XDD or XDC is a container of CANopen profiles (CiA 311)",
    .reference = "",
    .why =
        "Files of other systems carry the same endings: device descriptions of Ethernet POWERLINK and of "
        "maxon, design constraints of Xilinx. Their contents mean something else.",
    .example = Example::none,
    .bad = "",
    .good = ""};
const Rule xdd_absent{
    .code = "E0903",
    .name = "xdd-absent",
    .level = Level::error,
    .summary = "each object states its index and its access, and types that it names stand in the file",
    .reference = "",
    .why =
        "What the object is cannot be told, so it is left out; a configuration tool would not know the "
        "object at all.",
    .example = Example::device_description,
    .bad = "<CANopenObject index=\"2000\" name=\"Value\" objectType=\"7\" dataType=\"0007\"/>\n",
    .good =
        "<CANopenObject index=\"2000\" name=\"Value\" objectType=\"7\" dataType=\"0007\" "
        "accessType=\"ro\"/>\n"};
const Rule xdd_value{.code = "E0904",
                     .name = "xdd-value",
                     .level = Level::error,
                     .summary = "a value is written as its data type, or its attribute, demands",
                     .reference = "",
                     .why =
                         "Numbers are decimal or 0x.. for hexadecimal, octet strings are pairs of "
                         "hexadecimal digits. Importers turn anything else into 0 without a word.",
                     .example = Example::device_description,
                     .bad =
                         "<CANopenObject index=\"2000\" name=\"Value\" objectType=\"7\" dataType=\"0007\" "
                         "accessType=\"ro\" defaultValue=\"5,0\"/>\n",
                     .good =
                         "<CANopenObject index=\"2000\" name=\"Value\" objectType=\"7\" dataType=\"0007\" "
                         "accessType=\"ro\" defaultValue=\"5\"/>\n"};
const Rule xdd_number_range{
    .code = "E0905",
    .name = "xdd-number-range",
    .level = Level::error,
    .summary = "a number fits into its data type, or into what its attribute can state",
    .reference = "",
    .why =
        "The device cannot hold the value. What a configuration tool makes of it, and writes to the device, "
        "is its own choice.",
    .example = Example::device_description,
    .bad =
        "<CANopenObject index=\"2000\" name=\"Value\" objectType=\"7\" dataType=\"0005\" accessType=\"ro\" "
        "defaultValue=\"0x1FF\"/>\n",
    .good =
        "<CANopenObject index=\"2000\" name=\"Value\" objectType=\"7\" dataType=\"0005\" accessType=\"ro\" "
        "defaultValue=\"0xFF\"/>\n"};
const Rule xdd_number_form{
    .code = "E0906",
    .name = "xdd-number-form",
    .level = Level::warning,
    .summary = "numbers have no zeros in front, and values that follow the node number are $NODEID+number",
    .reference = "",
    .why =
        "A number with zeros in front is decimal here and octal in an EDS. Of a formula in another order "
        "some importers make nothing, and give all nodes the same identifier.",
    .example = Example::device_description,
    .bad =
        "<CANopenObject index=\"2000\" name=\"Value\" objectType=\"7\" dataType=\"0007\" accessType=\"ro\" "
        "defaultValue=\"0x180+$NODEID\"/>\n",
    .good =
        "<CANopenObject index=\"2000\" name=\"Value\" objectType=\"7\" dataType=\"0007\" accessType=\"ro\" "
        "defaultValue=\"$NODEID+0x180\"/>\n"};
const Rule xdd_data_type{
    .code = "E0907",
    .name = "xdd-data-type",
    .level = Level::error,
    .summary = "a data type is one of CiA 301",
    .reference = "",
    .why = "How long the value is, and what its bytes mean, is not known; the object is left out.",
    .example = Example::device_description,
    .bad =
        "<CANopenObject index=\"2000\" name=\"Value\" objectType=\"7\" dataType=\"00FF\" "
        "accessType=\"ro\"/>\n",
    .good =
        "<CANopenObject index=\"2000\" name=\"Value\" objectType=\"7\" dataType=\"0007\" "
        "accessType=\"ro\"/>\n"};
const Rule xdd_object_type{
    .code = "E0908",
    .name = "xdd-object-type",
    .level = Level::error,
    .summary = "an object type is one of CiA 301 and allows for the sub-objects that stand in the file",
    .reference = "",
    .why = "Whether the object is one value or a group of them decides how it is read and written.",
    .example = Example::device_description,
    .bad =
        "<CANopenObject index=\"2000\" name=\"Value\" objectType=\"3\" dataType=\"0007\" "
        "accessType=\"ro\"/>\n",
    .good =
        "<CANopenObject index=\"2000\" name=\"Value\" objectType=\"7\" dataType=\"0007\" "
        "accessType=\"ro\"/>\n"};
const Rule xdd_access{.code = "E0909",
                      .name = "xdd-access",
                      .level = Level::error,
                      .summary = "an access type is one of the words of CiA 311",
                      .reference = "",
                      .why =
                          "Whether the object can be read or written is not known; an object for which no "
                          "other word says so is left out.",
                      .example = Example::device_description,
                      .bad =
                          "<parameter uniqueID=\"UID_OBJ_2000\" access=\"both\"><label "
                          "lang=\"en\">Value</label><UDINT/></parameter>\n"
                          "<CANopenObject index=\"2000\" name=\"Value\" objectType=\"7\" accessType=\"rw\" "
                          "uniqueIDRef=\"UID_OBJ_2000\"/>\n",
                      .good =
                          "<parameter uniqueID=\"UID_OBJ_2000\" access=\"readWrite\"><label "
                          "lang=\"en\">Value</label><UDINT/></parameter>\n"
                          "<CANopenObject index=\"2000\" name=\"Value\" objectType=\"7\" accessType=\"rw\" "
                          "uniqueIDRef=\"UID_OBJ_2000\"/>\n"};
const Rule xdd_no_access{
    .code = "E0910",
    .name = "xdd-no-access",
    .level = Level::warning,
    .summary = "every object can be read or written",
    .reference = "",
    .why = "An object dictionary has no word for an object without access; cgw reads it as read-only.",
    .example = Example::device_description,
    .bad =
        "<parameter uniqueID=\"UID_OBJ_2000\" access=\"noAccess\"><label "
        "lang=\"en\">Value</label><UDINT/></parameter>\n"
        "<CANopenObject index=\"2000\" name=\"Value\" objectType=\"7\" uniqueIDRef=\"UID_OBJ_2000\"/>\n",
    .good =
        "<parameter uniqueID=\"UID_OBJ_2000\" access=\"read\"><label "
        "lang=\"en\">Value</label><UDINT/></parameter>\n"
        "<CANopenObject index=\"2000\" name=\"Value\" objectType=\"7\" uniqueIDRef=\"UID_OBJ_2000\"/>\n"};
const Rule xdd_reference{.code = "E0911",
                         .name = "xdd-reference",
                         .level = Level::error,
                         .summary = "the parameter that an object names stands in the file",
                         .reference = "",
                         .why = "What the parameter says, which may be the type and the value, is missing.",
                         .example = Example::device_description,
                         .bad =
                             "<parameter uniqueID=\"UID_OBJ_2001\" access=\"read\"><label "
                             "lang=\"en\">Value</label><UDINT/></parameter>\n"
                             "<CANopenObject index=\"2000\" name=\"Value\" objectType=\"7\" "
                             "dataType=\"0007\" accessType=\"ro\" uniqueIDRef=\"UID_OBJ_2000\"/>\n",
                         .good =
                             "<parameter uniqueID=\"UID_OBJ_2000\" access=\"read\"><label "
                             "lang=\"en\">Value</label><UDINT/></parameter>\n"
                             "<CANopenObject index=\"2000\" name=\"Value\" objectType=\"7\" "
                             "dataType=\"0007\" accessType=\"ro\" uniqueIDRef=\"UID_OBJ_2000\"/>\n"};
const Rule xdd_contradiction{
    .code = "E0912",
    .name = "xdd-contradiction",
    .level = Level::warning,
    .summary = "an object and its parameter say the same",
    .reference = "",
    .why =
        "Some tools read the one, some the other: the same file describes two devices. cgw reads the object.",
    .example = Example::device_description,
    .bad =
        "<parameter uniqueID=\"UID_OBJ_2000\" access=\"read\"><label "
        "lang=\"en\">Value</label><UINT/></parameter>\n"
        "<CANopenObject index=\"2000\" name=\"Value\" objectType=\"7\" dataType=\"0007\" accessType=\"ro\" "
        "uniqueIDRef=\"UID_OBJ_2000\"/>\n",
    .good =
        "<parameter uniqueID=\"UID_OBJ_2000\" access=\"read\"><label "
        "lang=\"en\">Value</label><UDINT/></parameter>\n"
        "<CANopenObject index=\"2000\" name=\"Value\" objectType=\"7\" dataType=\"0007\" accessType=\"ro\" "
        "uniqueIDRef=\"UID_OBJ_2000\"/>\n"};
const Rule xdd_twice{
    .code = "E0913",
    .name = "xdd-twice",
    .level = Level::error,
    .summary = "an index, a sub-index and a uniqueID stand in a file once",
    .reference = "",
    .why = "Of two objects with one index some tools take the first and some the last. cgw reads the first.",
    .example = Example::device_description,
    .bad =
        "<CANopenObject index=\"2000\" name=\"Value\" objectType=\"7\" dataType=\"0007\" "
        "accessType=\"ro\"/>\n"
        "<CANopenObject index=\"2000\" name=\"Value\" objectType=\"7\" dataType=\"0005\" "
        "accessType=\"ro\"/>\n",
    .good =
        "<CANopenObject index=\"2000\" name=\"Value\" objectType=\"7\" dataType=\"0007\" "
        "accessType=\"ro\"/>\n"
        "<CANopenObject index=\"2001\" name=\"Value\" objectType=\"7\" dataType=\"0005\" "
        "accessType=\"ro\"/>\n"};

const Rule xdd_no_type{
    .code = "E0914",
    .name = "xdd-no-type",
    .level = Level::warning,
    .summary = "each object states its data type, and a BITSTRING the dataType that it stands for",
    .reference = "D74",
    .why =
        "Of a BITSTRING nobody knows how many bytes it has and what they mean. Tools write it for DOMAIN and "
        "OCTET_STRING; cgw reads it, and an object without any type, as DOMAIN.",
    .example = Example::device_description,
    .bad =
        "<parameter uniqueID=\"UID_OBJ_1021\" access=\"read\"><label "
        "lang=\"en\">Store EDS</label><BITSTRING/></parameter>\n"
        "<CANopenObject index=\"1021\" name=\"Store EDS\" objectType=\"7\" "
        "uniqueIDRef=\"UID_OBJ_1021\"/>\n",
    .good =
        "<parameter uniqueID=\"UID_OBJ_1021\" access=\"read\"><label "
        "lang=\"en\">Store EDS</label><BITSTRING/></parameter>\n"
        "<CANopenObject index=\"1021\" name=\"Store EDS\" objectType=\"7\" dataType=\"000F\" "
        "uniqueIDRef=\"UID_OBJ_1021\"/>\n"};
const Rule xdd_bit_rate{.code = "E0915",
                        .name = "xdd-bit-rate",
                        .level = Level::warning,
                        .summary = "bit rates are those of CANopen",
                        .reference = "",
                        .why =
                            "CANopen has 10, 20, 50, 125, 250, 500, 800 and 1000 kbit/s, and an EDS has no "
                            "key for others, nor for "
                            "a device that finds the rate by itself (auto-baudRate).",
                        .example = Example::device_description,
                        .bad =
                            "<CANopenObject index=\"2000\" name=\"Value\" objectType=\"7\" dataType=\"0007\" "
                            "accessType=\"ro\"/>\n"
                            "<TransportLayers><PhysicalLayer><baudRate><supportedBaudRate value=\"100 "
                            "Kbps\"/></baudRate></PhysicalLayer></TransportLayers>\n",
                        .good =
                            "<CANopenObject index=\"2000\" name=\"Value\" objectType=\"7\" dataType=\"0007\" "
                            "accessType=\"ro\"/>\n"
                            "<TransportLayers><PhysicalLayer><baudRate><supportedBaudRate value=\"125 "
                            "Kbps\"/></baudRate></PhysicalLayer></TransportLayers>\n"};
const Rule xdd_sub_number{
    .code = "E0916",
    .name = "xdd-sub-number",
    .level = Level::warning,
    .summary = "subNumber counts the sub-objects of an object",
    .reference = "CiA 311",
    .why = "A tool that trusts the number stops early, or waits for sub-objects that never come.",
    .example = Example::device_description,
    .bad =
        "<CANopenObject index=\"2000\" name=\"Values\" objectType=\"9\" subNumber=\"3\">\n"
        "<CANopenSubObject subIndex=\"00\" name=\"Highest\" objectType=\"7\" dataType=\"0005\" "
        "accessType=\"ro\" defaultValue=\"1\"/>\n"
        "<CANopenSubObject subIndex=\"01\" name=\"One\" objectType=\"7\" dataType=\"0007\" "
        "accessType=\"ro\"/>\n"
        "</CANopenObject>\n",
    .good =
        "<CANopenObject index=\"2000\" name=\"Values\" objectType=\"9\" subNumber=\"2\">\n"
        "<CANopenSubObject subIndex=\"00\" name=\"Highest\" objectType=\"7\" dataType=\"0005\" "
        "accessType=\"ro\" defaultValue=\"1\"/>\n"
        "<CANopenSubObject subIndex=\"01\" name=\"One\" objectType=\"7\" dataType=\"0007\" "
        "accessType=\"ro\"/>\n"
        "</CANopenObject>\n"};
const Rule xdd_sub_object_type{
    .code = "E0917",
    .name = "xdd-sub-object-type",
    .level = Level::warning,
    .summary = "a sub-object is one value: a VAR or a DOMAIN",
    .reference = "CiA 311",
    .why = "It is read as a VAR. A tool that takes it for an ARRAY or RECORD looks for sub-objects of it.",
    .example = Example::device_description,
    .bad =
        "<CANopenObject index=\"2000\" name=\"Values\" objectType=\"9\" subNumber=\"1\">\n"
        "<CANopenSubObject subIndex=\"00\" name=\"Highest\" objectType=\"8\" dataType=\"0005\" "
        "accessType=\"ro\" defaultValue=\"0\"/>\n"
        "</CANopenObject>\n",
    .good =
        "<CANopenObject index=\"2000\" name=\"Values\" objectType=\"9\" subNumber=\"1\">\n"
        "<CANopenSubObject subIndex=\"00\" name=\"Highest\" objectType=\"7\" dataType=\"0005\" "
        "accessType=\"ro\" defaultValue=\"0\"/>\n"
        "</CANopenObject>\n"};
const Rule xdd_information{
    .code = "E0918",
    .name = "xdd-information",
    .level = Level::warning,
    .summary = "identity, versions and dates are written as CiA 311 writes them",
    .reference = "CiA 311",
    .why =
        "What cannot be read is left out or comes from somewhere else: vendor, product and revision from "
        "1018h. Another tool may read another number.",
    .example = Example::device_description,
    .bad =
        "<DeviceIdentity><vendorID>HEINZMANN</vendorID></DeviceIdentity>\n"
        "<CANopenObject index=\"2000\" name=\"Value\" objectType=\"7\" dataType=\"0007\" "
        "accessType=\"ro\"/>\n",
    .good =
        "<DeviceIdentity><vendorID>0x0000012C</vendorID></DeviceIdentity>\n"
        "<CANopenObject index=\"2000\" name=\"Value\" objectType=\"7\" dataType=\"0007\" "
        "accessType=\"ro\"/>\n"};

}  // namespace cgw::diagnostic::rules
