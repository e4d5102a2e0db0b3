// A soak whose rules cannot be broken proves nothing: each rule is broken here once, in a log that is sound
// but for that.
#pragma once

#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "canopen/nmt.hpp"
#include "simulation/soak/rules.hpp"
#include "simulation/soak/world.hpp"
#include "wire/little_endian.hpp"

namespace cgw::simulation::soak {

inline constexpr Time cycle = 15'625;

class SoakRules : public testing::Test {
  protected:
    // A gateway that has been initialised and started.
    SoakRules() {
        state(GatewayState::undefined);
        state(GatewayState::init);
        pass(cycle);
        begin(GatewayState::pre_operational);
        offer(boot_up());
        look();
        look_.binary[6] = 4;  // as tpdo() says
        state(GatewayState::operational);
        for (std::size_t number = 1; number <= facts::binary_tpdos; ++number) {
            offer(tpdo(number, {}));
        }
    }

    void TearDown() override {
        EXPECT_EQ(fmt::format("{}", fmt::join(rules_.broken(), "\n")).substr(0, expected_.size()), expected_);
        EXPECT_EQ(rules_.broken().size(), expected_.empty() ? 0U : 1U);
    }
    // The one rule that the test breaks.
    void expect_broken(const std::string& rule) { expected_ = rule + " at "; }

    void begin(GatewayState state) { look_.state = state; }
    void look() {
        look_.now = now_;
        rules_.look(look_);
    }
    void command(canopen::NmtCommand command) {
        rules_.carry(canopen::nmt_frame(command, image_.can2().own_node), now_);
    }
    // Enters it, commanded where a command leads there.
    void state(GatewayState state) {
        if (state == GatewayState::operational) {
            command(canopen::NmtCommand::start);
        } else if (state == GatewayState::stopped) {
            command(canopen::NmtCommand::stop);
        } else if (state == GatewayState::pre_operational) {
            command(canopen::NmtCommand::enter_pre_operational);
        }
        begin(state);
        look();
    }
    void pass(Time time) {
        for (Time passed = 0; passed < time; passed += 1'000) {
            now_ += 1'000;
            look();
        }
    }
    void offer(const frame::Frame& frame, bool taken = true) {
        rules_.offer(frame, taken, {now_, look_.state, false});
        if (taken) {
            rules_.carry(frame, now_);
        }
    }

    frame::Frame life_sign(std::uint8_t value) const {
        frame::Frame frame;
        frame.id = canopen::cob::heartbeat + image_.can2().own_node;
        frame.length = 1;
        frame.data[0] = value;
        return frame;
    }
    frame::Frame boot_up() const { return life_sign(0); }
    frame::Frame sdo_answer() const {
        frame::Frame frame;
        frame.id = canopen::cob::sdo_answer + image_.can2().own_node;
        frame.length = 8;
        return frame;
    }
    // TPDO number 1..16 with the words of these data.
    frame::Frame tpdo(std::size_t number, const device::GovernorData& data) const {
        const image::Pdo pdo = image_.pdo(number - 1);
        frame::Frame frame;
        frame.id = pdo.cob_id;
        frame.length = static_cast<std::uint8_t>(2 * pdo.word_count);
        for (std::size_t word = 0; word < pdo.word_count; ++word) {
            const std::uint16_t value = number >= device::first_analogue_tpdo
                                            ? data.analogue[number - device::first_analogue_tpdo][word]
                                            : data.errors[word];
            wire::store_u16(&frame.data[2 * word], number == 3 ? std::uint16_t{4} : value);
        }
        return frame;
    }
    device::GovernorData deliver(bool flicker = false) {
        now_ += cycle;
        ++cycles_;
        device::GovernorData data;
        rules_.mark(data, flicker);
        std::copy(data.errors.begin(), data.errors.end(), look_.binary.begin());
        look();
        return data;
    }
    // RPDO2 of the genset has three words.
    frame::Frame rpdo2(std::uint16_t first) const {
        frame::Frame frame;
        frame.id = image_.pdo(facts::tpdo_count + 1U).cob_id;
        frame.length = 6;
        for (std::size_t word = 0; word < 3; ++word) {
            wire::store_u16(&frame.data[2 * word], static_cast<std::uint16_t>(first + word));
        }
        return frame;
    }
    Settled sound() const {
        Settled settled;
        settled.now = now_;
        for (std::size_t position = 0; position < facts::tpdo_count; ++position) {
            settled.tpdos[position] = {now_, position < facts::binary_tpdos ? std::uint16_t{4} : cycles_};
        }
        settled.engine_state = 4;
        settled.sent = settled.obeyed = {1, 2, 3};
        return settled;
    }

    const image::Image& image_ = fast_genset();
    Rules rules_{image_};
    Look look_;
    Time now_ = 1'000'000;
    std::uint16_t cycles_ = 0;  // of the governor
    std::string expected_;
};

}  // namespace cgw::simulation::soak
