// The device configuration file: what it has beyond the data sheet of the same dictionary.
#include <gtest/gtest.h>

#include "dictionary/node.hpp"
#include "eds/document.hpp"
#include "eds/writer.hpp"
#include "profile/gateway.hpp"
#include "support/sample_configuration.hpp"

namespace cgw::eds {
namespace {

using object::DataType;

std::string entry(const Document& document, std::string_view section, std::string_view key) {
    return std::string(document.value(section, key).value_or("(missing)"));
}

dictionary::Dictionary gateway() {
    return profile::gateway_dictionary(test::manual_configuration(), {});
}

dictionary::Dictionary configured_gateway() {
    return dictionary::of_node(gateway(), 12);
}

dictionary::Commissioning node_12() {
    dictionary::Commissioning node;
    node.last_eds = "plant.eds";
    node.node_id = 12;
    node.node_name = "Größe";
    node.bit_rate_kbit = 250;
    node.serial_number = 0x4A2;
    return node;
}

}  // namespace

TEST(Dcf, names_its_data_sheet_and_its_node) {
    const Document document(write(configured_gateway(), node_12()));
    EXPECT_EQ(entry(document, "FileInfo", "LastEDS"), "plant.eds");
    EXPECT_EQ(entry(document, "DeviceComissioning", "NodeID"), "12");
    EXPECT_EQ(entry(document, "DeviceComissioning", "NodeName"), "Groesse");
    EXPECT_EQ(entry(document, "DeviceComissioning", "Baudrate"), "250");
    EXPECT_EQ(entry(document, "DeviceComissioning", "NetNumber"), "0");
    EXPECT_EQ(entry(document, "DeviceComissioning", "NetworkName"), "");
    EXPECT_EQ(entry(document, "DeviceComissioning", "CANopenManager"), "0");
    EXPECT_EQ(entry(document, "DeviceComissioning", "LSS_SerialNumber"), "0x000004A2");
}

TEST(Dcf, leaves_an_unknown_bit_rate_out) {
    dictionary::Commissioning node = node_12();
    node.bit_rate_kbit.reset();
    EXPECT_EQ(entry(Document(write(configured_gateway(), node)), "DeviceComissioning", "Baudrate"),
              "(missing)");
}

TEST(Dcf, resolves_the_node_number) {
    const std::string text = write(configured_gateway(), node_12());
    EXPECT_EQ(text.find("$NODEID"), std::string::npos);
    const Document document(write(configured_gateway(), node_12()));
    EXPECT_EQ(entry(document, "1200sub1", "ParameterValue"), "0x0000060C");
    EXPECT_EQ(entry(document, "1200sub1", "DefaultValue"), "0x0000060C");
    EXPECT_EQ(entry(document, "1802sub1", "ParameterValue"), "0x8000038C");  // inactive
    EXPECT_EQ(entry(document, "180Fsub1", "ParameterValue"), "0x0000057F");  // absolute
}

TEST(Dcf, states_values_but_for_those_that_change_at_run_time) {
    const Document document(write(configured_gateway(), node_12()));
    EXPECT_EQ(entry(document, "1000", "ParameterValue"), "0x00000000");
    EXPECT_EQ(entry(document, "1A03sub1", "ParameterValue"), "0x20010110");
    EXPECT_EQ(entry(document, "2001sub0", "ParameterValue"), entry(document, "2001sub0", "DefaultValue"));
    for (const std::string section :
         {"1001", "2000sub1", "2001sub1", "2002sub1", "2003sub1", "2004sub1", "2005"}) {
        EXPECT_EQ(entry(document, section, "ParameterValue"), "(missing)") << section;
        EXPECT_NE(entry(document, section, "DefaultValue"), "(missing)") << section;
    }
}

TEST(Dcf, differs_from_the_data_sheet_in_nothing_else) {
    const Document sheet(write(gateway()));
    const Document file(write(configured_gateway(), node_12()));
    EXPECT_EQ(file.sections().size(), sheet.sections().size() + 1);
    for (const Section& section : sheet.sections()) {
        const std::string_view name = sheet.name(section);
        for (std::uint32_t line = section.header + 1; line < section.end; ++line) {
            if (sheet.lines()[line].kind == LineKind::blank) {
                continue;
            }
            const std::string_view stated = sheet.value(line);
            const std::string value = entry(file, name, sheet.key(line));
            if (stated.starts_with("$NODEID")) {
                EXPECT_NE(value, stated) << name << ' ' << sheet.key(line);
            } else {
                EXPECT_EQ(value, stated) << name << ' ' << sheet.key(line);
            }
        }
    }
}

TEST(DataSheet, has_none_of_the_configuration_files_keys) {
    const std::string text = write(gateway());
    for (const std::string key : {"ParameterValue", "LastEDS", "DeviceComissioning"}) {
        EXPECT_EQ(text.find(key), std::string::npos) << key;
    }
}

}  // namespace cgw::eds
