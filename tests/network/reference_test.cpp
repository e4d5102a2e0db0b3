// 16 TPDOs and 4 RPDOs of 8 bytes at one period and a heartbeat of 1 s: what others have worked out for it.
#include <gtest/gtest.h>

#include "network/analysis.hpp"

namespace cgw::network {
namespace {

std::vector<Message> full_gateway(std::uint64_t period_us) {
    std::vector<Message> messages;
    for (std::uint32_t i = 0; i < 20; ++i) {
        messages.push_back(
            {.identifier = 0x181 + i, .bytes = 8, .kind = Kind::pdo, .name = "PDO", .period_us = period_us});
    }
    messages.push_back({.identifier = 0x701,
                        .bytes = 1,
                        .kind = Kind::heartbeat,
                        .name = "heartbeat",
                        .period_us = 1'000'000});
    return messages;
}

Analysis analysed(std::uint32_t bit_rate, std::uint64_t period_us) {
    return analyse(full_gateway(period_us), {.bit_rate = bit_rate});
}

}  // namespace

TEST(Reference, worst_case_loads) {
    struct {
        std::uint32_t bit_rate;
        std::uint64_t period_ms;
        double percent;
    } const rows[] = {{125'000, 20, 108.05}, {125'000, 50, 43.25}, {125'000, 100, 21.65},
                      {250'000, 20, 54.03},  {250'000, 50, 21.63}, {250'000, 100, 10.83},
                      {500'000, 20, 27.01},  {500'000, 50, 10.81}, {500'000, 100, 5.41}};
    for (const auto& row : rows) {
        const Analysis analysis = analysed(row.bit_rate, row.period_ms * 1'000);
        EXPECT_NEAR(analysis.load.worst * 100, row.percent, 0.0051) << row.bit_rate << " " << row.period_ms;
        EXPECT_LT(analysis.load.average, analysis.load.worst);
        EXPECT_GT(analysis.load.average, analysis.load.worst * 0.8);
    }
}

TEST(Reference, response_times) {
    struct {
        std::uint32_t bit_rate;
        std::uint64_t highest_us;
        std::uint64_t lowest_us;
    } const rows[] = {{125'000, 2'160, 22'120}, {250'000, 1'080, 11'060}, {500'000, 540, 5'530}};
    for (const auto& row : rows) {
        for (const std::uint64_t period_ms : {20U, 50U, 100U}) {
            const Analysis analysis = analysed(row.bit_rate, period_ms * 1'000);
            EXPECT_EQ(analysis.messages.front().response_us, row.highest_us);
            if (row.bit_rate == 125'000 && period_ms == 20) {
                continue;
            }
            EXPECT_EQ(analysis.messages[19].response_us, row.lowest_us);
            EXPECT_EQ(analysis.messages[20].response_us, row.lowest_us);
        }
    }
}

TEST(Reference, what_has_no_bound_is_told) {
    const Analysis analysis = analysed(125'000, 20'000);
    for (std::size_t i = 0; i < analysis.messages.size(); ++i) {
        EXPECT_EQ(analysis.messages[i].bounded(), i < 18) << i;
        EXPECT_EQ(analysis.messages[i].in_time(), i < 18) << i;
    }
}

TEST(Reference, sdo_can_be_left_out) {
    std::vector<Message> messages = full_gateway(50'000);
    messages.push_back({.identifier = 0x581,
                        .bytes = 8,
                        .kind = Kind::sdo,
                        .release = Release::event,
                        .name = "SDO",
                        .period_us = assumed::sdo_us});
    EXPECT_EQ(analyse(messages, {.bit_rate = 125'000, .sdo_interval_us = 0}).messages.size(), 21U);
    const Analysis with = analyse(messages, {.bit_rate = 125'000, .sdo_interval_us = 10'000});
    EXPECT_EQ(with.messages.size(), 22U);
    EXPECT_NEAR(with.load.worst - 0.4325, 1080.0 / 10'000, 1e-4);
    EXPECT_NEAR(with.load.average, analysed(125'000, 50'000).load.average, 1e-9);
}

TEST(Reference, an_odd_bit_rate_is_taken_for_a_slower_one) {
    const std::vector<Message> messages = full_gateway(100'000);
    EXPECT_EQ(analyse(messages, {.bit_rate = 123'456}).messages.front().response_us,
              (270 * 8'101 + 999) / 1'000);  // 8100.05 ns
    EXPECT_EQ(analyse(messages, {.bit_rate = 0}).bus.bit_rate, lowest_bit_rate);
}

}  // namespace cgw::network
