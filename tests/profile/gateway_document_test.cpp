// What the dictionary says about the file and the device.
#include <gtest/gtest.h>

#include "profile/gateway.hpp"
#include "support/sample_configuration.hpp"

namespace cgw::profile {
namespace {

dictionary::Dictionary dictionary_with(const GatewayDocument& document) {
    return gateway_dictionary(test::empty_configuration(), document);
}

}  // namespace

TEST(GatewayDocument, describes_title_and_configuration) {
    GatewayDocument document;
    document.title = "Genset 2, Größe XL";
    document.configuration_id = "0123456789abcdef";
    EXPECT_EQ(dictionary_with(document).file.description,
              "Genset 2, Groesse XL, configuration 0123456789abcdef");
}

TEST(GatewayDocument, has_a_description_without_a_title) {
    GatewayDocument document;
    document.configuration_id = "0123456789abcdef";
    EXPECT_EQ(dictionary_with(document).file.description,
              "EDS for Heinzmann CANopen Gateway, configuration 0123456789abcdef");
}

TEST(GatewayDocument, shortens_the_title_and_keeps_the_configuration_id) {
    GatewayDocument document;
    document.configuration_id = "0123456789abcdef";
    document.title = std::string(300, 'x');
    const std::string description = dictionary_with(document).file.description;
    EXPECT_EQ(description.size(), 243U);
    EXPECT_TRUE(description.ends_with("xxx..., configuration 0123456789abcdef")) << description;

    document.title = std::string(211, 'x');
    EXPECT_EQ(dictionary_with(document).file.description,
              document.title + ", configuration 0123456789abcdef");
}

TEST(GatewayDocument, names_author_or_tool) {
    GatewayDocument document;
    document.tool_version = "0.1.0";
    EXPECT_EQ(dictionary_with(document).file.created_by, "cgw 0.1.0");
    document.author = "Jörg";
    EXPECT_EQ(dictionary_with(document).file.created_by, "Joerg");
    EXPECT_EQ(dictionary_with(document).file.modified_by, "Joerg");
}

TEST(GatewayDocument, writes_dates_as_the_format_wants_them) {
    GatewayDocument document;
    EXPECT_EQ(dictionary_with(document).file.creation_date, "05-19-2004");
    document.created = {2026, 3, 1};
    document.revision = 7;
    const dictionary::FileInformation file = dictionary_with(document).file;
    EXPECT_EQ(file.creation_date, "03-01-2026");
    EXPECT_EQ(file.modification_date, "03-01-2026");
    EXPECT_EQ(file.creation_time, "12:00AM");
    EXPECT_EQ(file.file_revision, 7U);
    EXPECT_EQ(file.file_name, "CANopenGateway.eds");
}

TEST(GatewayDevice, is_the_one_of_the_printed_eds) {
    const dictionary::Dictionary dictionary = dictionary_with({});
    const dictionary::DeviceInformation& device = dictionary.device;
    EXPECT_EQ(device.vendor_name, "Heinzmann GmbH & Co. KG");
    EXPECT_EQ(device.product_name, "CANopen Gateway");
    EXPECT_EQ(device.order_code, "CANopen Gateway");
    EXPECT_EQ(device.bit_rates_kbit, (std::vector<unsigned>{125, 250, 500, 1000}));
    EXPECT_EQ(device.receive_pdos, 4U);
    EXPECT_EQ(device.transmit_pdos, 16U);
    EXPECT_TRUE(device.simple_boot_up_slave);
    EXPECT_FALSE(device.simple_boot_up_master);
    EXPECT_FALSE(device.lss_supported);
    EXPECT_EQ(dictionary.supported_dummies, (std::vector<std::uint8_t>{6}));
}

}  // namespace cgw::profile
