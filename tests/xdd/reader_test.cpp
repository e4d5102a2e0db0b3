// The reader: both dialects, what it tells, and where.
#include "xdd/reader.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "xdd/reading_result.hpp"

namespace cgw::xdd {
namespace {

using object::Access;
using object::DataType;
using object::ObjectCode;
using test::device_description;
using Result = test::XddResult;

std::string parameter(std::string_view attributes, std::string_view content) {
    return fmt::format(
        "<parameter uniqueID=\"P\" {}><label lang=\"en\">Named by its parameter</label>{}</parameter>\n",
        attributes, content);
}

std::string object(std::string_view attributes) {
    return fmt::format("<CANopenObject index=\"2000\" objectType=\"7\" {}/>\n", attributes);
}

}  // namespace

TEST(XddReader, reads_type_and_value_from_the_object) {
    const Result result(device_description(
        "", object("name=\"Speed\" dataType=\"0006\" accessType=\"rw\" defaultValue=\"0x10\" lowLimit=\"1\" "
                   "highLimit=\"100\" PDOmapping=\"optional\" objFlags=\"0003\" denotation=\"rpm\"")));
    EXPECT_EQ(result.told(), "");
    const dictionary::Variable& speed = result.variable(0x2000);
    EXPECT_EQ(speed.name, "Speed");
    EXPECT_EQ(speed.type, DataType::unsigned16);
    EXPECT_EQ(speed.access, Access::rw);
    EXPECT_EQ(speed.default_value.number, 0x10U);
    EXPECT_EQ(speed.low_limit->number, 1U);
    EXPECT_EQ(speed.high_limit->number, 100U);
    EXPECT_TRUE(speed.pdo_mapping);
    EXPECT_EQ(speed.flags, 3U);
    EXPECT_EQ(speed.denotation, "rpm");
}

TEST(XddReader, reads_type_and_value_from_the_parameter) {
    const Result result(device_description(
        parameter("access=\"readWriteOutput\"",
                  "<denotation><label lang=\"en\">rpm</label></denotation><UINT/><actualValue value=\"5\"/>"
                  "<defaultValue value=\"0x10\"/><allowedValues><range><minValue value=\"1\"/>"
                  "<maxValue value=\"100\"/></range></allowedValues>"),
        object("PDOmapping=\"RPDO\" uniqueIDRef=\"P\"")));
    EXPECT_EQ(result.told(), "");
    const dictionary::Variable& speed = result.variable(0x2000);
    EXPECT_EQ(speed.name, "Named by its parameter");
    EXPECT_EQ(speed.type, DataType::unsigned16);
    EXPECT_EQ(speed.access, Access::rww);
    EXPECT_EQ(speed.default_value.number, 0x10U);
    EXPECT_EQ(speed.parameter_value->number, 5U);
    EXPECT_EQ(speed.low_limit->number, 1U);
    EXPECT_EQ(speed.high_limit->number, 100U);
    EXPECT_TRUE(speed.pdo_mapping);
    EXPECT_EQ(speed.denotation, "rpm");
}

TEST(XddReader, reads_every_access) {
    const std::vector<std::tuple<std::string, std::string, Access>> expected{
        {"", "access=\"read\"", Access::ro},
        {"", "", Access::ro},
        {"", "access=\"write\"", Access::wo},
        {"", "access=\"const\"", Access::constant},
        {"", "access=\"readWriteInput\"", Access::rwr},
        {"accessType=\"rw\"", "access=\"readWriteInput\"", Access::rwr},
        {"accessType=\"rw\"", "access=\"readWriteOutput\"", Access::rww},
        {"accessType=\"rw\"", "", Access::rw},
        {"accessType=\"rw\" PDOmapping=\"TPDO\"", "", Access::rwr},
        {"accessType=\"rw\" PDOmapping=\"RPDO\"", "access=\"readWrite\"", Access::rww},
        {"accessType=\"rw\" PDOmapping=\"optional\"", "access=\"readWrite\"", Access::rw},
        {"accessType=\"const\"", "access=\"read\"", Access::constant},
        {"accessType=\"RWW\"", "access=\"readWrite\"", Access::rww},
    };
    for (const auto& [of_object, of_parameter, access] : expected) {
        const Result result(
            device_description(parameter(of_parameter, "<UINT/>"), object("uniqueIDRef=\"P\" " + of_object)));
        EXPECT_EQ(result.told(), "") << of_object << of_parameter;
        EXPECT_EQ(result.variable(0x2000).access, access) << of_object << of_parameter;
    }
}

TEST(XddReader, reads_the_types_of_iec_61131) {
    const std::vector<std::pair<std::string, DataType>> expected{
        {"BOOL", DataType::boolean},          {"BYTE", DataType::unsigned8},
        {"CHAR", DataType::integer8},         {"WORD", DataType::unsigned16},
        {"DWORD", DataType::unsigned32},      {"LWORD", DataType::unsigned64},
        {"SINT", DataType::integer8},         {"INT", DataType::integer16},
        {"DINT", DataType::integer32},        {"LINT", DataType::integer64},
        {"USINT", DataType::unsigned8},       {"UINT", DataType::unsigned16},
        {"UDINT", DataType::unsigned32},      {"ULINT", DataType::unsigned64},
        {"REAL", DataType::real32},           {"LREAL", DataType::real64},
        {"STRING", DataType::visible_string}, {"WSTRING", DataType::unicode_string}};
    for (const auto& [element, type] : expected) {
        const Result result(
            device_description(parameter("", "<" + element + "/>"), object("uniqueIDRef=\"P\"")));
        EXPECT_EQ(result.variable(0x2000).type, type) << element;
    }
    const Result bits(
        device_description(parameter("", "<BITSTRING/>"), object("uniqueIDRef=\"P\" dataType=\"000F\"")));
    EXPECT_EQ(bits.told(), "");
    EXPECT_EQ(bits.variable(0x2000).type, DataType::domain);
}

TEST(XddReader, follows_types_and_templates_by_their_names) {
    const std::string text =
        "<ISO15745ProfileContainer><ISO15745Profile><ProfileBody><ApplicationProcess>"
        "<dataTypeList><derived name=\"D\" uniqueID=\"D\"><dataTypeIDRef uniqueIDRef=\"E\"/></derived>"
        "<enum name=\"E\" uniqueID=\"E\"><USINT/></enum>"
        "<derived name=\"L\" uniqueID=\"L\"><dataTypeIDRef uniqueIDRef=\"L\"/></derived></dataTypeList>"
        "<templateList><parameterTemplate uniqueID=\"T\" access=\"readWrite\"><dataTypeIDRef "
        "uniqueIDRef=\"D\"/>"
        "<defaultValue value=\"3\"/></parameterTemplate></templateList>"
        "<parameterList><parameter uniqueID=\"P\" templateIDRef=\"T\"/><parameter uniqueID=\"Q\">"
        "<dataTypeIDRef uniqueIDRef=\"L\"/></parameter></parameterList>"
        "</ApplicationProcess></ProfileBody></"
        "ISO15745Profile><ISO15745Profile><ProfileBody><ApplicationLayers>"
        "<CANopenObjectList><CANopenObject index=\"2000\" name=\"A\" objectType=\"7\" uniqueIDRef=\"P\"/>\n"
        "<CANopenObject index=\"2001\" name=\"B\" objectType=\"7\" uniqueIDRef=\"Q\"/></CANopenObjectList>"
        "</ApplicationLayers></ProfileBody></ISO15745Profile></ISO15745ProfileContainer>";
    const Result result(text);
    EXPECT_EQ(result.told(), "2:2 xdd-absent\n") << "a type that refers to itself is none";
    EXPECT_EQ(result.variable(0x2000).type, DataType::unsigned8);
    EXPECT_EQ(result.variable(0x2000).access, Access::rw);
    EXPECT_EQ(result.variable(0x2000).default_value.number, 3U);
}

TEST(XddReader, reads_values_as_tools_write_them) {
    const std::vector<std::tuple<std::string, std::string, std::uint64_t>> expected{
        {"0001", "true", 1},  {"0001", "False", 0},
        {"0002", "-1", 0xFF}, {"0007", "$NODEID+0x180", 0x180},
        {"0007", " 12 ", 12}, {"0006", "0xFFFF", 0xFFFF},
        {"0005", "007", 7},   {"0008", "1.5", 0x3FC00000},
    };
    for (const auto& [type, text, number] : expected) {
        const Result result(device_description(
            "", object("dataType=\"" + type + "\" accessType=\"ro\" defaultValue=\"" + text + "\"")));
        EXPECT_EQ(result.told(), "") << text;
        EXPECT_EQ(result.variable(0x2000).default_value.number, number) << text;
    }
    const Result relative(
        device_description("", object("dataType=\"0007\" accessType=\"ro\" defaultValue=\"$NODEID+0x180\"")));
    EXPECT_TRUE(relative.variable(0x2000).default_value.node_id_relative);
    const Result octets(
        device_description("", object("dataType=\"000A\" accessType=\"ro\" defaultValue=\"0x00 AB\"")));
    EXPECT_EQ(octets.variable(0x2000).default_value.bytes, std::string("\0\xAB", 2));
}

TEST(XddReader, reads_zeros_in_front_as_decimal_and_says_so) {
    const Result result(
        device_description("", object("dataType=\"0005\" accessType=\"ro\" defaultValue=\"010\"")));
    EXPECT_EQ(result.told(), "3:90 xdd-number-form\n");
    EXPECT_EQ(result.variable(0x2000).default_value.number, 10U);
}

TEST(XddReader, reads_groups_of_objects) {
    const Result result(device_description(
        "",
        "<CANopenObject index=\"1018\" name=\"Identity\" objectType=\"9\" subNumber=\"2\" denotation=\"d\">"
        "<CANopenSubObject subIndex=\"01\" name=\"Vendor\" objectType=\"7\" dataType=\"0007\" "
        "accessType=\"ro\" "
        "defaultValue=\"0x15A\"/><CANopenSubObject subIndex=\"00\" name=\"Count\" objectType=\"7\" "
        "dataType=\"0005\" accessType=\"const\" defaultValue=\"1\"/></CANopenObject>"
        "<CANopenObject index=\"1000\" name=\"Type\" objectType=\"7\" dataType=\"0007\" "
        "accessType=\"ro\"/>"));
    EXPECT_EQ(result.told(), "");
    ASSERT_EQ(result.sheet.dictionary.objects.size(), 2U);
    EXPECT_EQ(result.sheet.dictionary.objects[0].index, 0x1000);
    const dictionary::Object& identity = result.sheet.dictionary.objects[1];
    EXPECT_EQ(identity.code, ObjectCode::record);
    EXPECT_EQ(identity.denotation, "d");
    ASSERT_EQ(identity.variables.size(), 2U);
    EXPECT_EQ(identity.variables[0].name, "Count");
    EXPECT_EQ(result.sheet.dictionary.device.vendor_number, 0x15AU)
        << "from 1018h, where nothing else says it";
}

TEST(XddReader, tells_of_a_device_what_it_cannot_read) {
    const std::string object =
        "<CANopenObject index=\"2000\" name=\"V\" objectType=\"7\" dataType=\"0007\" accessType=\"ro\"/>";
    const auto told = [&](const std::string& identity, const std::string& attributes = "") {
        std::string text =
            test::device_description("", object, "", "<DeviceIdentity>" + identity + "</DeviceIdentity>");
        const std::string body = "<ProfileBody>";
        text.insert(text.rfind(body) + body.size() - 1, " " + attributes);
        const Result result(text);
        EXPECT_TRUE(result.told().empty() || result.told().ends_with(" xdd-information\n")) << result.told();
        return result.told().empty() ? "" : result.message();
    };
    EXPECT_EQ(told("<vendorID>0x12</vendorID><productID/><version versionType=\"FW\">7</version>"), "");
    EXPECT_EQ(told("<vendorID>zzz</vendorID>"),
              "vendorID is `zzz`, which is no number of 32 bits; the value of 1018h:1 counts");
    EXPECT_EQ(told("<productID>0x1300000000000</productID>"),
              "productID is `0x1300000000000`, which is no number of 32 bits; the value of 1018h:2 counts");
    EXPECT_EQ(told("<version versionType=\"FW\">V1.2</version>"),
              "version is `V1.2`, which is no number of 32 bits; the value of 1018h:3 counts");
    EXPECT_EQ(told("",
                   "fileCreationDate=\"2024-12-31\" fileModificationDate=\"0001-01-01\" "
                   "fileCreationTime=\"09:30:00\""),
              "");
    EXPECT_EQ(told("", "fileCreationDate=\"2024-13-45\""),
              "fileCreationDate is `2024-13-45`, which is no date or time; it is left out");
    EXPECT_EQ(told("", "fileModificationTime=\"noon\""),
              "fileModificationTime is `noon`, which is no date or time; it is left out");
    EXPECT_EQ(told("", "fileVersion=\"1.2.3\""),
              "fileVersion is `1.2.3`, which is no version from 0 to 255.255; 1.0 counts");
}

TEST(XddReader, reads_the_device_and_its_node) {
    const std::string text =
        "\xEF\xBB\xBF<?xml version=\"1.0\"?><p:ISO15745ProfileContainer xmlns:p=\"x\"><p:ISO15745Profile>"
        "<ProfileBody fileName=\"a.xdd\" fileVersion=\"1\"><p:DeviceIdentity><p:vendorName> Maker "
        "</p:vendorName>"
        "<p:vendorID>000002BE</p:vendorID><p:productName>Thing</p:productName><p:productID>12</p:productID>"
        "<p:orderNumber>77</p:orderNumber><p:version versionType=\"HW\">9</p:version></p:DeviceIdentity>"
        "</ProfileBody></p:ISO15745Profile><p:ISO15745Profile><ProfileBody fileName=\"b.xdc\" "
        "fileVersion=\"2.7\">"
        "<ApplicationLayers><p:CANopenObjectList/><dummyUsage><dummy entry=\"Dummy0002=1\"/>"
        "<dummy "
        "entry=\"Dummy0005=0\"/></dummyUsage></ApplicationLayers><TransportLayers><PhysicalLayer><baudRate>"
        "<supportedBaudRate value=\"500 Kbps\"/><supportedBaudRate value=\"10 "
        "Kbps\"/></baudRate></PhysicalLayer>"
        "</TransportLayers><NetworkManagement><CANopenGeneralFeatures nrOfRxPDO=\"4\" nrOfTxPDO=\"16\" "
        "bootUpSlave=\"true\" granularity=\"8\" layerSettingServiceSlave=\"1\" dynamicChannels=\"2\"/>"
        "<deviceCommissioning NodeID=\"5\" nodeName=\"N\" actualBaudRate=\"250 Kbps\" networkNumber=\"1\" "
        "networkName=\"W\" CANopenManager=\"false\"/></NetworkManagement></ProfileBody></p:ISO15745Profile>"
        "</p:ISO15745ProfileContainer>";
    const Result result(text);
    EXPECT_EQ(result.told(), "");
    const dictionary::Dictionary& dictionary = result.sheet.dictionary;
    EXPECT_EQ(dictionary.file.file_name, "b.xdc");
    EXPECT_EQ(dictionary.file.file_version * 10 + dictionary.file.file_revision, 27U);
    EXPECT_EQ(dictionary.device.vendor_name, "Maker");
    EXPECT_EQ(dictionary.device.vendor_number, 0x2BEU);
    EXPECT_EQ(dictionary.device.product_number, 12U);
    EXPECT_EQ(dictionary.device.order_code, "77");
    EXPECT_EQ(dictionary.device.revision_number, 0U);
    EXPECT_EQ(dictionary.device.bit_rates_kbit, (std::vector<unsigned>{10, 500}));
    EXPECT_EQ(dictionary.supported_dummies, (std::vector<std::uint8_t>{2}));
    EXPECT_EQ(dictionary.device.transmit_pdos, 16U);
    EXPECT_TRUE(dictionary.device.simple_boot_up_slave && dictionary.device.lss_supported &&
                dictionary.device.dynamic_channels);
    ASSERT_TRUE(result.sheet.commissioning);
    EXPECT_EQ(result.sheet.commissioning->node_id, 5U);
    EXPECT_EQ(result.sheet.commissioning->bit_rate_kbit, 250U);
    EXPECT_EQ(result.sheet.commissioning->node_name + result.sheet.commissioning->network_name, "NW");
}

TEST(XddReader, tells_what_is_wrong_at_the_value) {
    const Result result(device_description(
        parameter("", "<UINT/><defaultValue value=\"7\"/>"),
        "<CANopenObject index=\"2000\" name=\"a=&quot;\" dataType='0007' objectType=\"7\" accessType = "
        "\"maybe\"/>\n"
        "<CANopenObject name=\"A\"/>\n"
        "<CANopenObject index=\"10000\"/>\n"
        "<CANopenObject index=\"2001\" objectType=\"4\" dataType=\"0007\" accessType=\"ro\"/>\n"
        "<CANopenObject index=\"2002\" objectType=\"7\" dataType=\"0006\" accessType=\"wo\" "
        "defaultValue=\"8\" "
        "PDOmapping=\"yes\" uniqueIDRef=\"P\"/>\n"
        "<CANopenObject index=\"2003\" objectType=\"7\" uniqueIDRef=\"Q\"/>\n"
        "<CANopenObject index=\"2004\" objectType=\"7\"><CANopenSubObject/></CANopenObject>\n",
        "<NetworkManagement><CANopenGeneralFeatures groupMessaging=\"perhaps\" granularity=\"x\"/>"
        "</NetworkManagement>"));
    EXPECT_EQ(result.told(),
              "4:90 xdd-access\n5:2 xdd-absent\n6:23 xdd-number-range\n7:41 xdd-object-type\n"
              "8:90 xdd-contradiction\n8:105 xdd-value\n9:2 xdd-absent\n9:57 xdd-reference\n"
              "10:41 xdd-object-type\n10:45 xdd-absent\n11:100 xdd-value\n11:122 xdd-value\n");
}

TEST(XddReader, reads_what_has_no_type_as_domain_and_says_so) {
    const test::XddResult result(test::device_description(
        "<parameter uniqueID=\"P1\"><label lang=\"en\">Store EDS</label><BITSTRING/></parameter>\n"
        "<parameter uniqueID=\"P2\" access=\"readWrite\"><label lang=\"en\">Command</label></parameter>\n",
        "<CANopenObject index=\"1021\" name=\"Store EDS\" objectType=\"7\" uniqueIDRef=\"P1\"/>\n"
        "<CANopenObject index=\"1023\" name=\"OS command\" objectType=\"9\" subNumber=\"2\">\n"
        "<CANopenSubObject subIndex=\"01\" name=\"Command\" objectType=\"7\" uniqueIDRef=\"P2\"/>\n"
        "<CANopenSubObject subIndex=\"02\" name=\"Status\" objectType=\"7\" accessType=\"ro\" "
        "dataType=\"000A\"/>\n"
        "</CANopenObject>\n"
        "<CANopenObject index=\"1025\" name=\"x\" objectType=\"2\" accessType=\"ro\"/>\n"));
    EXPECT_EQ(result.told(), "5:2 xdd-no-type\n7:2 xdd-no-type\n");
    EXPECT_FALSE(result.findings.has_errors());
    EXPECT_EQ(result.variable(0x1021).type, object::DataType::domain);
    EXPECT_EQ(result.variable(0x1021).access, object::Access::ro);
    EXPECT_EQ(result.variable(0x1023, 1).type, object::DataType::domain);
    EXPECT_EQ(result.variable(0x1023, 1).access, object::Access::rw);
    EXPECT_EQ(result.variable(0x1023, 2).type, object::DataType::octet_string);
    EXPECT_EQ(result.variable(0x1025).type, object::DataType::domain);
}

TEST(XddReader, leaves_bit_rates_out_that_canopen_does_not_have) {
    const test::XddResult result(test::device_description(
        "",
        "<CANopenObject index=\"2000\" name=\"V\" objectType=\"7\" dataType=\"0007\" accessType=\"ro\"/>\n",
        "<TransportLayers><PhysicalLayer><baudRate><supportedBaudRate value=\"100 Kbps\"/>"
        "<supportedBaudRate value=\"auto-baudRate\"/><supportedBaudRate value=\"autoBaudRate\"/>"
        "<supportedBaudRate value=\"250 Kbps\"/></baudRate></PhysicalLayer></TransportLayers>"));
    EXPECT_FALSE(result.findings.has_errors());
    EXPECT_EQ(result.findings.all().size(), 3U);
    for (const diagnostic::Diagnostic& finding : result.findings.all()) {
        EXPECT_EQ(finding.rule->code, "E0915");
    }
    EXPECT_EQ(result.sheet.dictionary.device.bit_rates_kbit, std::vector<unsigned>{250});
}

TEST(XddReader, keeps_an_empty_string_and_no_value_apart) {
    const test::XddResult result(test::device_description(
        "<parameter uniqueID=\"P\" access=\"read\"><label lang=\"en\">C</label><STRING/><defaultValue "
        "value=\"\"/></parameter>\n",
        "<CANopenObject index=\"2000\" name=\"A\" objectType=\"7\" dataType=\"0009\" accessType=\"ro\" "
        "defaultValue=\"\"/>\n"
        "<CANopenObject index=\"2001\" name=\"B\" objectType=\"7\" dataType=\"0009\" accessType=\"ro\"/>\n"
        "<CANopenObject index=\"2002\" name=\"C\" objectType=\"7\" uniqueIDRef=\"P\"/>\n"
        "<CANopenObject index=\"2003\" name=\"D\" objectType=\"7\" dataType=\"0007\" accessType=\"ro\" "
        "defaultValue=\"\"/>\n"));
    EXPECT_EQ(result.told(), "");
    EXPECT_FALSE(result.variable(0x2000).no_default);
    EXPECT_TRUE(result.variable(0x2001).no_default);
    EXPECT_FALSE(result.variable(0x2002).no_default);
    EXPECT_TRUE(result.variable(0x2003).no_default);
}

}  // namespace cgw::xdd
