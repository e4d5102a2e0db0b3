// What cgw writes passes its own checks, as strict importers would have it.
#include <gtest/gtest.h>

#include "eds/writer.hpp"
#include "eds_check/checked.hpp"
#include "profile/gateway.hpp"
#include "support/sample_configuration.hpp"

namespace cgw::eds_check {
namespace {

dictionary::Dictionary dictionary_of(const config::Configuration& configuration) {
    profile::GatewayDocument document;
    document.title = "Genset 1";
    document.configuration_id = "0123456789abcdef";
    document.tool_version = "0.1.0";
    return profile::gateway_dictionary(configuration, document);
}

const std::vector<config::Configuration> configurations{test::manual_configuration(),
                                                        test::empty_configuration()};

}  // namespace

TEST(OwnDataSheet, has_no_findings_when_checked_strictly) {
    for (const config::Configuration& configuration : configurations) {
        const dictionary::Dictionary dictionary = dictionary_of(configuration);
        const auto findings =
            test::checked(eds::write(dictionary), dictionary.file.file_name, {.strict = true});
        EXPECT_EQ(test::as_lines(findings), "");
    }
}

TEST(OwnConfigurationFile, has_no_findings_when_checked_strictly) {
    for (const config::Configuration& configuration : configurations) {
        const dictionary::Dictionary dictionary = dictionary_of(configuration);
        dictionary::Commissioning node;
        node.last_eds = dictionary.file.file_name;
        node.node_id = configuration.node_id;
        node.bit_rate_kbit = 250;
        const auto findings =
            test::checked(eds::write(dictionary, node), dictionary.file.file_name, {.strict = true});
        EXPECT_EQ(test::as_lines(findings), "");
    }
}

}  // namespace cgw::eds_check
