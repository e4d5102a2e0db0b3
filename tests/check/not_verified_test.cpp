#include "check/not_verified.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/plant_builder.hpp"

namespace cgw::check {
namespace {

using test::PlantBuilder;

// The lines without the last one, which holds for every file.
std::string open_questions(PlantBuilder& plant) {
    diagnostic::Findings findings;
    const config::Configuration configuration = plant.resolve();
    std::vector<std::string> lines =
        not_verified({plant.settings(), plant.catalogue(), configuration, findings});
    EXPECT_EQ(lines.back(), "both devices: whether they hold these values; compare in DcDesk");
    lines.pop_back();
    for (const std::string& line : lines) {
        EXPECT_LE(line.size(), 76U) << line;  // with its dash within 80 columns
    }
    return fmt::format("{}", fmt::join(lines, "\n"));
}

constexpr std::string_view no_nodes = "other nodes: their ids and identifiers; [network] lists none";

}  // namespace

TEST(NotVerified, are_other_nodes_beyond_what_the_file_lists) {
    PlantBuilder plant;
    EXPECT_EQ(open_questions(plant.minimal()), no_nodes);
    EXPECT_EQ(open_questions(plant.network_node(2).network_node(3)),
              "other nodes: identifiers beyond the default ones of 2, 3");
}

TEST(NotVerified, are_nodes_in_the_same_order_however_they_are_listed) {
    PlantBuilder plant;
    EXPECT_EQ(open_questions(plant.minimal().network_node(11).network_node(2)),
              "other nodes: identifiers beyond the default ones of 2, 11");
}

TEST(NotVerified, is_the_scaling_of_a_sent_word_without_its_reference_values) {
    PlantBuilder plant;
    plant.minimal().governor_list(16400, {2905, 2908}).governor(16460, 100).network_node(2);
    const std::string rest = "other nodes: identifiers beyond the default ones of 2";
    EXPECT_EQ(open_questions(plant), "scaling of 2905: 980, 981 are not set\n" + rest);
    EXPECT_EQ(open_questions(plant.governor(980, 0)), "scaling of 2905: 981 is not set\n" + rest);
    EXPECT_EQ(open_questions(plant.governor(981, 10)), rest);
}

TEST(NotVerified, is_the_scaling_of_a_sent_word_whose_highest_value_is_0) {
    PlantBuilder plant;
    plant.minimal().governor_list(16400, {2905}).governor(16460, 100).network_node(2);
    plant.governor(980, -1).governor(981, 0);
    EXPECT_EQ(open_questions(plant),
              "scaling of 2905: 981 is not set\n"
              "other nodes: identifiers beyond the default ones of 2");
}

TEST(NotVerified, is_a_bit_rate_whose_clock_is_not_stated) {
    PlantBuilder plant;
    plant.minimal().governor(4416, 1).gateway(4416, 1).gateway(4426, 1).network_node(2);
    const std::string governor = "HEINZMANN CAN bus: the governor's bit rate, set by hand (4416 = 1)\n";
    const std::string rest = "other nodes: identifiers beyond the default ones of 2";
    EXPECT_EQ(open_questions(plant),
              governor +
                  "HEINZMANN CAN bus: the gateway's bit rate, set by hand, clock not stated\n"
                  "CANopen bus: the bit rate, set by hand (4426 = 1), clock not stated\n" +
                  rest);
    plant.settings().can1_bit_timing.emplace().clock_hz = 16000000;
    plant.settings().can2_bit_timing.emplace().clock_hz = 16000000;
    EXPECT_EQ(open_questions(plant), governor + rest);  // D17: the governor's is never known
}

TEST(NotVerified, are_switches_and_sensors_that_no_catalogue_names) {
    PlantBuilder plant;
    plant.minimal().governor(811, 1).governor(4811, 3).governor(929, 2).governor(4929, 3);
    plant.governor(812, 5).governor(4812, 1);  // a hardware input
    EXPECT_EQ(open_questions(plant),
              "switch functions 811: whether this governor has them\n"
              "sensors 929: whether this governor has them\n" +
                  std::string(no_nodes));
    for (std::uint16_t number = 820; number < 830; ++number) {
        plant.governor(number, 2).governor(static_cast<std::uint16_t>(number + 4000), 3);
    }
    EXPECT_NE(open_questions(plant).find("switch functions 811, ... (11): "), std::string::npos);
}

}  // namespace cgw::check
