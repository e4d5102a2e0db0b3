// The gateway's EDS must pass what strict importers check; and the check must notice each of their reasons.
#include <gtest/gtest.h>

#include "eds/writer.hpp"
#include "profile/gateway.hpp"
#include "support/sample_configuration.hpp"
#include "support/strict_eds.hpp"

namespace cgw::eds {
namespace {

std::string eds_of(const config::Configuration& configuration) {
    profile::GatewayDocument document;
    document.title = "Schiffsdiesel; Größe 5 % [x] = ü";
    document.configuration_id = "0123456789abcdef";
    document.tool_version = "0.1.0";
    return write(profile::gateway_dictionary(configuration, document));
}

config::Configuration full_configuration() {
    config::Configuration configuration = test::manual_configuration();
    configuration.identity = {4711, 407, 12};
    for (const std::size_t number : {5U, 6U, 7U, 8U, 9U, 10U, 11U, 12U, 13U, 14U, 15U}) {
        for (int word = 0; word < 4; ++word) {
            test::add_output(configuration, number,
                             word % 2 == 0 ? test::row::speed : test::row::charge_air_temperature);
        }
    }
    return configuration;
}

std::string joined(const std::vector<std::string>& findings) {
    std::string text;
    for (const std::string& finding : findings) {
        text += finding + '\n';
    }
    return text;
}

struct Fault {
    std::string name;
    std::string section;  // where to look for `good`
    std::string good;
    std::string bad;
    std::string finding;
};

class StrictImport : public testing::TestWithParam<Fault> {};

const std::vector<Fault> faults{
    {"missing_data_type", "1001", "DataType=0x0005\r\n", "", "[1001] DataType is missing"},
    {"missing_access", "2000sub1", "AccessType=ro\r\n", "", "[2000sub1] AccessType is missing"},
    {"missing_default", "1018sub4", "DefaultValue=0x0197000C\r\n", "", "[1018sub4] DefaultValue is missing"},
    {"missing_name", "1016", "ParameterName=Consumer Heartbeat Time",
     "ParameterName=", "[1016] ParameterName is empty or too long"},
    {"upper_case_access", "1000", "AccessType=ro", "AccessType=RO", "[1000] AccessType is unknown: RO"},
    {"mappable_rw", "2003sub1", "AccessType=rww", "AccessType=rw",
     "[2003sub1] mappable object is rw instead of rwr or rww"},
    {"read_only_in_rpdo", "2003sub1", "AccessType=rww", "AccessType=ro",
     "[1600sub1] maps an object of unsuitable access"},
    {"revision_differs", "DeviceInfo", "RevisionNumber=0x00001267", "RevisionNumber=0x00001268",
     "[DeviceInfo] RevisionNumber differs from 1018sub3"},
    {"sub_0_too_high", "2001sub0", "DefaultValue=0x1C", "DefaultValue=0x1D",
     "[2001sub0] DefaultValue does not fit the highest sub-index"},
    {"mapping_count_too_high", "1A02sub0", "DefaultValue=0x00", "DefaultValue=0x02",
     "[1A02sub0] DefaultValue does not fit the highest sub-index"},
    {"sub_number_wrong", "1A01", "SubNumber=3", "SubNumber=1",
     "[1A01] SubNumber is not the number of sections"},
    {"rpdo_count_wrong", "DeviceInfo", "NrOfRXPDO=4", "NrOfRXPDO=3",
     "[DeviceInfo] NrOfRXPDO is not the number of PDOs"},
    {"tpdo_count_wrong", "DeviceInfo", "NrOfTXPDO=16", "NrOfTXPDO=15",
     "[DeviceInfo] NrOfTXPDO is not the number of PDOs"},
    {"mapped_object_missing", "1A03sub1", "0x20010110", "0x20013510",
     "[1A03sub1] maps an object that does not exist"},
    {"mapped_length_wrong", "1A03sub1", "0x20010110", "0x20010108",
     "[1A03sub1] maps an object of another length"},
    {"mapped_not_mappable", "2001sub1", "PDOMapping=1", "PDOMapping=0",
     "[1A03sub1] maps an object that is not mappable"},
    {"dummy_not_allowed", "DummyUsage", "Dummy0006=1", "Dummy0006=0",
     "[1600sub2] maps a dummy that DummyUsage does not allow"},
    {"unused_entry", "1A02sub1", "0x00000000", "0x20000110", "[1A02sub1] unused entry is not 0"},
    {"listed_without_section", "ManufacturerObjects", "6=0x2005", "6=0x2006",
     "[ManufacturerObjects] 2006 has no section"},
    {"section_not_listed", "ManufacturerObjects", "6=0x2005", "6=0x2006", "[2005] object is not listed"},
    {"list_count_wrong", "OptionalObjects", "SupportedObjects=43", "SupportedObjects=42",
     "[OptionalObjects] SupportedObjects is not the number of entries"},
    {"orphan_sub_object", "2001subA", "[2001subA]", "[3001subA]", "[3001subA] sub-object without its object"},
    {"node_id_last", "1400sub1", "$NODEID+0x200", "0x200+$NODEID",
     "[1400sub1] DefaultValue does not begin with $NODEID"},
    {"vendor_key", "2001sub1", "PDOMapping=1\r\n", "PDOMapping=1\r\nUnit=rpm\r\n",
     "[2001sub1] Unit is unknown"},
    {"misspelt_boot_up", "DeviceInfo", "SimpleBootUpMaster", "SimpleBoot-upMaster",
     "[DeviceInfo] SimpleBootUpMaster is missing"},
    {"double_prefix", "DeviceInfo", "0x00001B59", "0x0x00001B59",
     "[DeviceInfo] ProductNumber is no number: 0x0x00001B59"},
    {"midnight_as_zero", "FileInfo", "CreationTime=12:00AM", "CreationTime=00:00AM",
     "[FileInfo] CreationTime is malformed"},
    {"eds_version", "FileInfo", "EDSVersion=4.0", "EDSVersion=4", "[FileInfo] EDSVersion is malformed"},
    {"group_with_data_type", "1018", "SubNumber=5\r\n", "SubNumber=5\r\nDataType=0x0007\r\n",
     "[1018] DataType is unknown"},
    {"value_too_wide", "1400sub2", "0xFE", "0x1FE", "[1400sub2] DefaultValue does not fit the type"},
    {"outside_limits", "2000sub0", "LowLimit=0x06", "LowLimit=0x07",
     "[2000sub0] DefaultValue is outside the limits"},
    {"equal_names", "2001sub2", "ParameterName=SpeedSetp", "ParameterName=Speed",
     "[2001sub2] name appears twice in the object"},
    {"double_key", "1000", "DataType=0x0007\r\n", "DataType=0x0007\r\nDataType=0x0007\r\n",
     "[1000] DataType appears twice"},
    {"blank_before_equals", "1000",
     "DataType=", "DataType =", "[1000] not a line of an EDS: DataType =0x0007"},
    {"blank_after_equals", "1000",
     "DataType=", "DataType= ", "[1000] not a line of an EDS: DataType= 0x0007"},
    {"double_section", "1001", "[1001]", "[1000]", "[1000] section appears twice"},
    {"no_entry", "1001", "ParameterName=", "ParameterName ",
     "[1001] not a line of an EDS: ParameterName Error Register"},
    {"bare_line_feed", "1000", "\r\nDataType", "\nDataType", "[1000] character outside printable ASCII"},
    {"latin_1", "1000", "ParameterName=Device", "ParameterName=Ger\xE4t",
     "[1000] character outside printable ASCII"},
    {"long_line", "1000", "ParameterName=Device Type", "ParameterName=" + std::string(242, 'x'),
     "[1000] line longer than 255"},
};

}  // namespace

TEST(StrictImportOfTheGateway, accepts_the_manuals_example) {
    EXPECT_EQ(joined(test::check_strictly(eds_of(test::manual_configuration())).findings), "");
}

TEST(StrictImportOfTheGateway, accepts_a_configuration_without_pdos) {
    EXPECT_EQ(joined(test::check_strictly(eds_of(test::empty_configuration())).findings), "");
}

TEST(StrictImportOfTheGateway, accepts_every_pdo_in_use) {
    EXPECT_EQ(joined(test::check_strictly(eds_of(full_configuration())).findings), "");
}

TEST_P(StrictImport, notices) {
    const Fault& fault = GetParam();
    static const std::string good = eds_of(full_configuration());
    std::string text = good;
    const std::size_t section = text.find("[" + fault.section + "]\r\n");
    ASSERT_NE(section, std::string::npos);
    const std::size_t place = text.find(fault.good, section);
    ASSERT_NE(place, std::string::npos);
    text.replace(place, fault.good.size(), fault.bad);
    const std::vector<std::string> findings = test::check_strictly(text).findings;
    EXPECT_NE(joined(findings).find(fault.finding + '\n'), std::string::npos)
        << "expected: " << fault.finding << "\nfound:\n"
        << joined(findings);
}

INSTANTIATE_TEST_SUITE_P(Faults, StrictImport, testing::ValuesIn(faults),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace cgw::eds
