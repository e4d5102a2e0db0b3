#include <gtest/gtest.h>

#include "config/configuration.hpp"
#include "config/mapping_text.hpp"
#include "support/plant_builder.hpp"

namespace cgw::config {
namespace {

using test::decision_text;
using test::mapping_text;
using test::PlantBuilder;

TEST(BinaryTpdos, are_active_together_and_map_the_error_words_when_errors_are_sent) {
    PlantBuilder plant;
    const Configuration configuration = plant.minimal().governor(14401, 1).resolve();
    EXPECT_TRUE(configuration.send_errors);
    EXPECT_EQ(mapping_text(configuration.tpdo(1)), "2000:1 2000:2 2000:3 2000:4");
    EXPECT_EQ(mapping_text(configuration.tpdo(2)), "2000:5 2000:6");
    EXPECT_EQ(configuration.tpdo(1).length(), 8);
    EXPECT_EQ(configuration.tpdo(2).length(), 4);
    EXPECT_FALSE(configuration.tpdo(3).active);
    EXPECT_EQ(configuration.tpdo(1).time.asked_ms, 0U);
}

TEST(BinaryTpdos, send_the_engine_state_in_tpdo3) {
    PlantBuilder plant;
    const Configuration configuration = plant.minimal().governor(14402, 1).resolve();
    EXPECT_FALSE(configuration.tpdo(1).active);
    EXPECT_FALSE(configuration.tpdo(2).active);
    EXPECT_TRUE(configuration.tpdo(3).active);
    EXPECT_EQ(mapping_text(configuration.tpdo(3)), "2000:7");
    EXPECT_EQ(configuration.tpdo(3).mapping[0].kind, WordKind::engine_state);
}

TEST(AnalogueTpdos, need_a_parameter_and_a_cycle_to_be_active) {
    PlantBuilder plant;
    const Configuration configuration = plant.minimal()
                                            .governor(16400, 2000)  // TPDO4: no cycle
                                            .governor(16461, 100)   // TPDO5: no parameter
                                            .governor(16408, 2000)  // TPDO6: both
                                            .governor(16462, 500)
                                            .resolve();
    EXPECT_FALSE(configuration.tpdo(4).active);
    EXPECT_FALSE(configuration.tpdo(5).active);
    EXPECT_TRUE(configuration.tpdo(6).active);
    EXPECT_EQ(configuration.tpdo(4).length(), 0);
    EXPECT_EQ(configuration.tpdo(5).time.effective_us, 93750U) << "kept when inactive";
}

TEST(AnalogueTpdos, are_not_active_on_words_that_cannot_be_sent) {
    PlantBuilder plant;
    const Configuration configuration =
        plant.minimal().governor_list(16400, {3070, 2990, 2503}).governor(16460, 500).resolve();
    EXPECT_FALSE(configuration.tpdo(4).active);
    EXPECT_EQ(decision_text(configuration), "");
}

TEST(AnalogueTpdos, close_up_around_a_zero_and_say_so) {
    PlantBuilder plant;
    const Configuration configuration =
        plant.minimal().governor_list(16400, {2000, 0, 2031, 2300}).governor(16460, 500).resolve();
    const Pdo& pdo = configuration.tpdo(4);
    EXPECT_EQ(pdo.length(), 6);
    EXPECT_EQ(pdo.mapping[1].parameter->number, 2031);
    EXPECT_EQ(decision_text(configuration), "dropped 16401 2; moved 16402 3->2; moved 16403 4->3");
}

TEST(AnalogueTpdos, close_up_around_a_leading_zero) {
    PlantBuilder plant;
    const Configuration configuration =
        plant.minimal().governor_list(16400, {0, 2000}).governor(16460, 500).resolve();
    EXPECT_EQ(mapping_text(configuration.tpdo(4)), "2001:1");
    EXPECT_EQ(decision_text(configuration), "dropped 16400 1; moved 16401 2->1");
}

TEST(AnalogueTpdos, take_no_decision_about_trailing_zeros) {
    PlantBuilder plant;
    const Configuration configuration =
        plant.minimal().governor_list(16400, {2000, 0, 0, 0}).governor(16460, 500).resolve();
    EXPECT_EQ(configuration.tpdo(4).length(), 2);
    EXPECT_EQ(decision_text(configuration), "");
}

TEST(AnalogueTpdos, drop_bit_and_unknown_parameters_even_at_the_end) {
    PlantBuilder plant;
    const Configuration configuration =
        plant.minimal().governor_list(16400, {3070, 2000, 2990}).governor(16460, 500).resolve();
    EXPECT_EQ(mapping_text(configuration.tpdo(4)), "2001:1");
    EXPECT_EQ(decision_text(configuration), "dropped 16400 1; moved 16401 2->1; dropped 16402 3");
}

TEST(AnalogueTpdos, number_unsigned_and_signed_words_densely_over_the_active_pdos) {
    PlantBuilder plant;
    const Configuration configuration = plant.minimal()
                                            .governor_list(16400, {2000, 2500, 2501, 2502})
                                            .governor(16460, 500)
                                            .governor_list(16404, {2031, 2031})  // TPDO5: inactive
                                            .governor_list(16408, {2500, 2300})
                                            .governor(16462, 500)
                                            .resolve();
    EXPECT_EQ(mapping_text(configuration.tpdo(4)), "2001:1 2002:1 2001:2 2002:2");
    EXPECT_EQ(mapping_text(configuration.tpdo(6)), "2002:3 2001:3");
    ASSERT_EQ(configuration.analogue_outputs.size(), 6U);
    const AnalogueOutput& last = configuration.analogue_outputs.back();
    EXPECT_EQ(last.parameter->number, 2300);
    EXPECT_EQ(last.tpdo, 6);
    EXPECT_EQ(last.word, 2);
    EXPECT_EQ(last.index, 0x2001);
    EXPECT_EQ(last.sub_index, 3);
}

TEST(AnalogueTpdos, use_all_fifty_two_words) {
    PlantBuilder plant;
    plant.minimal();
    for (std::uint16_t offset = 0; offset < 52; ++offset) {
        plant.governor(static_cast<std::uint16_t>(16400 + offset), 2000);
    }
    for (std::uint16_t offset = 0; offset < 13; ++offset) {
        plant.governor(static_cast<std::uint16_t>(16460 + offset), 1000);
    }
    const Configuration configuration = plant.resolve();
    EXPECT_EQ(mapping_text(configuration.tpdo(16)), "2001:49 2001:50 2001:51 2001:52");
}

TEST(Identifiers, are_predefined_for_tpdo1_to_4_and_typed_for_5_to_16) {
    PlantBuilder plant;
    const Configuration configuration = plant.minimal().gateway(16404, 0x282).gateway(16415, 0x57F).resolve();
    EXPECT_EQ(configuration.tpdo(1).cob_id, 0x181);
    EXPECT_EQ(configuration.tpdo(2).cob_id, 0x281);
    EXPECT_EQ(configuration.tpdo(3).cob_id, 0x381);
    EXPECT_EQ(configuration.tpdo(4).cob_id, 0x481);
    EXPECT_EQ(configuration.tpdo(4).cob_id_source, CobIdSource::predefined);
    EXPECT_EQ(configuration.tpdo(5).cob_id, 0x282) << "kept when inactive";
    EXPECT_EQ(configuration.tpdo(5).cob_id_source, CobIdSource::parameter);
    EXPECT_EQ(configuration.tpdo(6).cob_id, 0);
    EXPECT_EQ(configuration.tpdo(16).cob_id, 0x57F);
    EXPECT_EQ(configuration.rpdo(1).cob_id, 0x201);
    EXPECT_EQ(configuration.rpdo(4).cob_id, 0x501);
}

TEST(Identifiers, are_not_set_while_the_node_id_is_not_known) {
    PlantBuilder plant;
    const Configuration configuration = plant.resolve();
    EXPECT_EQ(configuration.tpdo(1).cob_id, 0);
    EXPECT_EQ(configuration.rpdo(4).cob_id, 0);
}

TEST(Transmittable, takes_known_words_and_refuses_bits_and_unknown_widths) {
    PlantBuilder plant;
    const auto row = [&](std::uint16_t number) {
        return plant.catalogue().find(parameter::Device::governor, number);
    };
    EXPECT_TRUE(transmittable(row(2000)));
    EXPECT_TRUE(transmittable(row(2501)));
    EXPECT_FALSE(transmittable(row(3070)));
    EXPECT_FALSE(transmittable(row(2503)));
    EXPECT_FALSE(transmittable(nullptr));
}

}  // namespace
}  // namespace cgw::config
