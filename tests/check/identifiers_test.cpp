#include <gtest/gtest.h>

#include "check/findings_text.hpp"

namespace cgw::check {
namespace {

using parameter::Device;
using test::errors_of;
using test::PlantBuilder;

// Activates TPDO `number` (5..16) with the identifier.
PlantBuilder& with_tpdo(PlantBuilder& plant, int number, double identifier) {
    plant.governor(static_cast<std::uint16_t>(16400 + 4 * (number - 4)), 2000);
    plant.governor(static_cast<std::uint16_t>(16460 + number - 4), 500);
    return plant.gateway(static_cast<std::uint16_t>(16404 + number - 5), identifier);
}

// "E0205" or "E0205 E0206": the codes of all errors.
std::string codes(PlantBuilder& plant) {
    diagnostic::Findings findings;
    check({plant.settings(), plant.catalogue(), plant.resolve(), findings});
    findings.sort();
    std::string text;
    for (const diagnostic::Diagnostic& finding : findings.all()) {
        if (finding.level() != diagnostic::Level::error) {
            continue;
        }
        text += (text.empty() ? "" : " ") + std::string(finding.rule->code);
    }
    return text;
}

TEST(ReservedIdentifiers, are_those_of_7_3) {
    for (const double identifier : {0x000, 0x080, 0x100, 0x581, 0x601, 0x701, 0x770}) {
        SCOPED_TRACE(identifier);
        PlantBuilder plant;
        EXPECT_EQ(codes(with_tpdo(plant.minimal().gateway(428, 0x70), 5, identifier)), "E0205");
    }
    for (const double identifier : {0x003, 0x081, 0x582, 0x602, 0x702, 0x77F, 0x7FF, 0x680}) {
        SCOPED_TRACE(identifier);
        PlantBuilder plant;
        EXPECT_EQ(codes(with_tpdo(plant.minimal().gateway(428, 0x70), 5, identifier)), "");
    }
}

TEST(ReservedIdentifiers, name_their_purpose_and_where_the_node_id_comes_from) {
    PlantBuilder plant;
    EXPECT_EQ(errors_of(with_tpdo(plant.minimal(), 6, 0x601)),
              "22:8 E0205 cob-id-reserved: 16405 CanOpTPDO5-16ID(1) is 601h, reserved for SDO requests to "
              "the gateway "
              "(manual 7.3)\n"
              "  see 18:8: the gateway's 427 CanOpenMyNodeID is 1 here\n"
              "  help: 0x681 is free: write 16405 = 0x681\n");
}

TEST(ReservedIdentifiers, do_not_include_700h_without_a_partner) {
    PlantBuilder plant;
    EXPECT_EQ(codes(with_tpdo(plant.minimal().gateway(428, 0), 5, 0x700)), "") << "D14";
}

TEST(ReservedIdentifiers, do_not_matter_to_an_inactive_tpdo) {
    PlantBuilder plant;
    EXPECT_EQ(codes(plant.minimal().gateway(16404, 0).gateway(16405, 0x601)), "");
}

TEST(AbsentIdentifiers, are_missed_at_the_header_of_the_gateways_table) {
    PlantBuilder plant;
    with_tpdo(plant.minimal(), 16, 0x680).without(Device::gateway, 16415);
    EXPECT_EQ(errors_of(plant),
              "2:8 E0205 cob-id-reserved: TPDO16 is active, but 16415 CanOpTPDO5-16ID(11) is not set; "
              "without it the "
              "identifier is 000h, reserved for NMT commands (manual 7.3)\n"
              "  see 21:8: the governor's 16472 CanOpTPDO4-16Cyc(12) is 500 here\n"
              "  help: 0x68B is free: write 16415 = 0x68B\n");
}

TEST(AbsentIdentifiers, are_not_missed_when_their_value_is_refused_already) {
    PlantBuilder plant;
    with_tpdo(plant.minimal(), 16, 0x680).rejected(Device::gateway, 16415);
    EXPECT_EQ(codes(plant), "");
}

TEST(DuplicateIdentifiers, are_reported_once_at_the_later_pdo) {
    PlantBuilder plant;
    EXPECT_EQ(errors_of(with_tpdo(with_tpdo(plant.minimal(), 7, 0x690), 5, 0x690)),
              "22:8 E0206 cob-id-duplicate: 16406 CanOpTPDO5-16ID(2) is 690h, which TPDO5 uses already "
              "(manual 7.3)\n"
              "  see 25:8: TPDO5 has 690h from the gateway's 16404 CanOpTPDO5-16ID(0) here\n"
              "  help: 0x682 is free: write 16406 = 0x682\n");
}

TEST(DuplicateIdentifiers, include_the_predefined_ones_of_both_directions) {
    PlantBuilder transmit;
    transmit.minimal().governor(14401, 1);
    EXPECT_EQ(errors_of(with_tpdo(transmit, 5, 0x281)),
              "23:8 E0206 cob-id-duplicate: 16404 CanOpTPDO5-16ID(0) is 281h, which TPDO2 uses already "
              "(manual 7.3)\n"
              "  see 18:8: TPDO2 has 281h from the gateway's 427 CanOpenMyNodeID here\n"
              "  help: 0x680 is free: write 16404 = 0x680\n");
    PlantBuilder receive;
    receive.minimal().governor(900, 1).governor(4900, 3);
    EXPECT_EQ(codes(with_tpdo(receive, 5, 0x201)), "E0206");
    EXPECT_EQ(codes(receive.gateway(16404, 0x301)), "E0206");
}

TEST(DuplicateIdentifiers, do_not_matter_where_one_of_the_two_is_inactive) {
    PlantBuilder plant;
    EXPECT_EQ(codes(with_tpdo(plant.minimal().gateway(16405, 0x690), 5, 0x690)), "");
    EXPECT_EQ(codes(plant.gateway(16404, 0x281)), "") << "TPDO2 is off";
}

TEST(DuplicateIdentifiers, of_three_pdos_are_two_findings) {
    PlantBuilder plant;
    EXPECT_EQ(codes(with_tpdo(with_tpdo(with_tpdo(plant.minimal(), 5, 0x690), 6, 0x690), 7, 0x690)),
              "E0206 E0206");
}

TEST(ForeignIdentifiers, are_those_a_listed_node_sends_or_is_asked_on) {
    for (const double identifier : {0x082, 0x182, 0x282, 0x382, 0x482, 0x582, 0x602, 0x702}) {
        SCOPED_TRACE(identifier);
        PlantBuilder plant;
        EXPECT_EQ(codes(with_tpdo(plant.minimal().network_node(9).network_node(2), 5, identifier)), "E0207");
    }
    for (const double identifier : {0x202, 0x302, 0x402, 0x502, 0x183, 0x603}) {
        SCOPED_TRACE(identifier);
        PlantBuilder plant;
        EXPECT_EQ(codes(with_tpdo(plant.minimal().network_node(9).network_node(2), 5, identifier)), "");
    }
}

TEST(ForeignIdentifiers, name_the_node_and_its_purpose) {
    PlantBuilder plant;
    EXPECT_EQ(
        errors_of(with_tpdo(plant.minimal().network_node(2), 5, 0x282)),
        "23:8 E0207 cob-id-foreign: 16404 CanOpTPDO5-16ID(0) is 282h, which belongs to node 2 for its TPDO2\n"
        "  see 20:8: node 2 is listed here\n"
        "  help: 0x680 is free: write 16404 = 0x680\n");
}

TEST(ForeignIdentifiers, of_the_partner_count_only_when_it_is_listed) {
    PlantBuilder plant;
    EXPECT_EQ(codes(with_tpdo(plant.minimal().gateway(428, 2), 5, 0x282)), "");
}

TEST(Identifiers, are_reported_once_for_the_first_reason) {
    PlantBuilder reserved;  // the partner's heartbeat, and node 2 is listed too
    EXPECT_EQ(codes(with_tpdo(reserved.minimal().gateway(428, 2).network_node(2), 5, 0x702)), "E0205");
    PlantBuilder duplicate;
    with_tpdo(with_tpdo(duplicate.minimal().network_node(2), 5, 0x282), 6, 0x282);
    EXPECT_EQ(codes(duplicate), "E0207 E0206");
}

TEST(Identifiers, give_no_finding_while_the_node_id_is_missing) {
    PlantBuilder plant;
    plant.minimal().without(Device::gateway, 427).governor(14401, 1).governor(14402, 1).governor(900, 1);
    EXPECT_EQ(codes(with_tpdo(plant.governor(4900, 3), 5, 0x281)), "");
}

TEST(Identifiers, suggest_one_that_nobody_has) {
    PlantBuilder plant;
    plant.minimal().gateway(16406, 0x680).gateway(16407, 0x681);
    const std::string text = errors_of(with_tpdo(plant, 5, 0x080));
    EXPECT_NE(text.find("help: 0x682 is free: write 16404 = 0x682"), std::string::npos) << text;
}

}  // namespace
}  // namespace cgw::check
