// Plants with declared measurements of every kind: 8 and 16 bits, signed and not, names that collapse. The
// simulated governor lets each swing through its internal range.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>

#include "running_plant.hpp"

namespace cgw::test {
namespace {

struct Declared {
    bool is_signed = false;
    int width = 16;
    int internal_low = 0;
    int internal_high = 65535;
    double external_low = 0;  // at internal_low
    double external_high = 100;
};

constexpr std::uint16_t first_number = 5000;  // in no catalogue

using Random = std::mt19937;

int between(Random& random, int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
}

Declared declared_by(Random& random) {
    Declared row;
    row.is_signed = random() % 2 == 0;
    row.width = random() % 3 == 0 ? 8 : 16;
    const int span = row.width == 8 ? 256 : 65536;
    const int lowest = row.is_signed ? -span / 2 : 0;
    row.internal_low = between(random, lowest, lowest + span / 3);
    row.internal_high = between(random, lowest + span / 2, lowest + span - 1);
    row.external_low = between(random, -2000, 2000) / 8.0;
    row.external_high = row.external_low + between(random, 1, 100000) / 16.0;
    return row;
}

std::string text_of(const std::map<std::uint16_t, Declared>& rows) {
    std::string assigned;
    std::string declarations;
    for (const auto& [number, row] : rows) {
        assigned += (assigned.empty() ? "" : ", ") + std::to_string(number);
        declarations += "[[governor.declare]]\nnumber = " + std::to_string(number) + "\nname = \"Value" +
                        "-_:./"[number % 5] + std::to_string(number / 5) +
                        "\"\nkind = \"measurement\"\nunit = \"kW\"\nwidth = " + std::to_string(row.width) +
                        "\nsigned = " + (row.is_signed ? "true" : "false") + "\ninternal = [" +
                        std::to_string(row.internal_low) + ", " + std::to_string(row.internal_high) +
                        "]\nexternal = [" + std::to_string(row.external_low) + ", " +
                        std::to_string(row.external_high) + "]\n";
    }
    return "format = 1\n[governor.parameters]\n401 = 1\n403 = 1\n416 = 250\n4406 = 1\n16400 = [" + assigned +
           "]\n16460 = [16, 32, 48, 64, 100]\n" + declarations +
           "[gateway.parameters]\n401 = 1\n402 = 1\n416 = 250\n4400 = 1\n426 = 1000\n427 = 5\n"
           "16404 = [0x680, 0x681, 0x682, 0x683]\n";
}

// Where the simulated governor is in the range of a measurement it has no model for, at the end of its cycle.
double part_of_range(std::uint16_t number, double seconds) {
    const double phase = seconds / 8 + number * 0.137;
    return 0.25 + 0.5 * std::abs(2 * (phase - std::floor(phase)) - 1);
}

}  // namespace

class DecodedRandomPlants : public testing::TestWithParam<unsigned> {};

TEST_P(DecodedRandomPlants, show_the_declared_values) {
    Random random(GetParam());
    std::map<std::uint16_t, Declared> rows;
    for (std::uint16_t i = 0; i < 20; ++i) {
        rows[static_cast<std::uint16_t>(first_number + i)] = declared_by(random);
    }
    const std::filesystem::path path =
        std::filesystem::path(testing::TempDir()) / ("cgw-decode-" + std::to_string(GetParam()) + ".toml");
    std::ofstream(path) << text_of(rows);
    RunningPlant running(path);
    std::filesystem::remove(path);

    unsigned compared = 0;
    const std::uint64_t cycle = running.configuration().main_cycle_us;
    running.plant().can2().observe([&](const frame::Frame& frame, Time now) {
        const double seconds = static_cast<double>((now / cycle + 1) * cycle) / 1e6;
        for (const config::AnalogueOutput& output : running.configuration().analogue_outputs) {
            const config::Pdo& pdo = running.configuration().tpdo(output.tpdo);
            if (frame.id != pdo.cob_id) {
                continue;
            }
            const Declared& row = rows.at(output.parameter->number);
            const double part = part_of_range(output.parameter->number, seconds);
            const double governor = row.external_low + part * (row.external_high - row.external_low);
            const DbcSignal& signal = running.message(pdo).at(16U * (output.word - 1U));
            EXPECT_EQ(signal.is_signed, row.is_signed);
            EXPECT_NEAR(signal.decode(frame), governor,
                        std::abs(signal.factor) * 0.5 + 1e-9 * std::abs(governor))
                << output.parameter->number;
            EXPECT_GE(signal.decode(frame), signal.minimum);
            EXPECT_LE(signal.decode(frame), signal.maximum);
            ++compared;
        }
    });
    running.start();
    running.run_for(2 * second);
    EXPECT_GT(compared, 500U);
}

INSTANTIATE_TEST_SUITE_P(Seeds, DecodedRandomPlants, testing::Range(1U, 9U));

}  // namespace cgw::test
