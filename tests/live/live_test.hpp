// A gateway with the configuration of a parameter file on a simulated bus, and a verification of another one
// or the same beside it. Between the two stands whatever a test makes of the device's answers.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <memory>
#include <string>

#include "driver/plant.hpp"
#include "emit/emitter.hpp"
#include "live/report.hpp"
#include "live/verification.hpp"
#include "simulation/master_node.hpp"
#include "simulation/plant.hpp"

namespace cgw::test {

// Both halves of a small plant; `governor` and `gateway` are further lines of their tables.
inline std::string small_plant(const std::string& governor = "", const std::string& gateway = "") {
    return fmt::format(
        "format = 1\n"
        "[governor.parameters]\n401 = 1\n403 = 1\n416 = 250\n14401 = 1\n4406 = 1\n"
        "16404 = [2000, 2300]\n16461 = 100\n900 = 2\n4900 = 3\n811 = 1\n4811 = 3\n16481 = 500\n{}\n"
        "[gateway.parameters]\n401 = 1\n402 = 1\n416 = 250\n4400 = 1\n426 = 250\n427 = 12\n429 = 1008\n"
        "16404 = 0x282\n{}\n",
        governor, gateway);
}

// Everything that follows from a parameter file.
struct Built {
    explicit Built(const std::string& text) : file(driver::check_text("plant.toml", text)) {
        EXPECT_TRUE(file.valid()) << text;
        plant.emplace(*driver::Plant::make(file));
        bytes = emit::find_emitter("image")->emit(plant->view(), {});
        EXPECT_EQ(image::Image::open(bytes, image), image::Status::ok);
    }
    const dictionary::Dictionary& dictionary() const { return plant->view().dictionary; }

    driver::CheckedFile file;
    std::optional<driver::Plant> plant;
    base::Bytes bytes;
    image::Image image;
};

class LiveTest : public testing::Test, public simulation::Participant {
  protected:
    static constexpr canopen::Time second = 1'000'000;
    static constexpr std::uint8_t node = 12;

    // A gateway that holds `device`; the file says `file`.
    void connect(const std::string& file, const std::string& device, live::PlanOptions options = {},
                 live::Pace pace = {}) {
        file_.emplace(file);
        device_.emplace(device);
        plant_.emplace(device_->image);
        EXPECT_EQ(plant_->status(), device::OpenStatus::ok);
        port_ = &plant_->can2().attach(*this);
        plant_->can2().observe([this](const frame::Frame& frame, canopen::Time) { bus_.push_back(frame); });
        plant_->run_until(3 * second);
        options_ = options;
        verification_.emplace(live::plan(file_->dictionary(), node, options), node, *port_, pace);
    }
    const live::Result& verify(const std::string& file, const std::string& device,
                               live::PlanOptions options = {}) {
        connect(file, device, options);
        return finish();
    }
    const live::Result& finish() {
        const canopen::Time end = plant_->now() + 120 * second;
        while (!verification_->over() && plant_->now() < end) {
            plant_->run_until(plant_->now() + 1000);
        }
        EXPECT_TRUE(verification_->over());
        return verification_->result();
    }
    // "1804h:1 value", one per difference.
    std::vector<std::string> differences() const {
        std::vector<std::string> lines;
        for (const live::Difference& difference : verification_->result().differences) {
            lines.push_back(fmt::format("{} {}", verification_->plan()[difference.question].object_text(),
                                        to_text(difference.kind)));
        }
        return lines;
    }
    std::string text(const live::Connection& connection = {.up = true, .reason = "", .lost = 0}) const {
        return live::render_text(subject(), *verification_, connection);
    }
    live::Subject subject() const {
        return {.path = "plant.toml",
                .configuration_id = "0123456789abcdef",
                .channel = "hub:127.0.0.1:29536",
                .wrote = options_.write,
                .settings = file_->file.settings,
                .configuration = file_->file.configuration,
                .catalogue = *file_->file.catalogue};
    }

    canopen::Time poll(canopen::Time now) override {
        return verification_ ? std::max(verification_->poll(now), now + 1) : canopen::never;
    }
    void receive(const frame::Frame& frame, canopen::Time now) override {
        frame::Frame heard = frame;
        if (verification_ && (!lie || lie(heard))) {
            verification_->receive(heard, now);
        }
    }

    // Changes what the verification hears; false: it hears nothing.
    std::function<bool(frame::Frame&)> lie;
    std::optional<Built> file_;
    std::optional<Built> device_;
    std::optional<simulation::Plant> plant_;
    frame::FramePort* port_ = nullptr;
    live::PlanOptions options_;
    std::vector<frame::Frame> bus_;
    std::optional<live::Verification> verification_;
};

// An SDO answer of the device about this object.
inline bool answers(const frame::Frame& frame, std::uint16_t index, std::uint8_t sub_index) {
    return frame.id == 0x58CU &&
           canopen::sdo::multiplexer(frame) == canopen::sdo::Multiplexer{index, sub_index};
}

}  // namespace cgw::test
