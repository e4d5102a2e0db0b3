// One run of gateway, simulated governor and, if wanted, a master: simulated time, recorded frames, printed
// lines.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <ostream>
#include <string_view>

#include "cli/canopen-gateway/options.hpp"
#include "image/image.hpp"
#include "simulation/master_node.hpp"
#include "simulation/plant.hpp"

namespace cgw::gateway_cli {

using canopen::Time;

class PlantRun {
  public:
    PlantRun(const image::Image& image, Time duration, std::ostream& out);

    const image::Image& image() const { return *image_; }
    simulation::Plant& plant() { return plant_; }
    simulation::MasterNode& node() { return node_; }
    master::Master& master() { return node_.master(); }
    std::uint8_t node_id() const { return image_->can2().own_node; }
    Time now() { return plant_.now(); }

    // Runs on for `time`, or less when the duration ends first; false then.
    bool run_for(Time time);
    bool run_until(const std::function<bool()>& reached, Time at_most);
    bool over() { return now() >= end_; }

    // A line under the time of now, and one that belongs to it.
    void say(std::string_view text);
    void detail(std::string_view text);

    // A whole SDO transfer. Nothing when time was up before it ended; failed transfers tell their abort code.
    struct Transfer {
        std::uint32_t abort_code = 0;  // 0: accepted
        std::uint32_t value = 0;
        std::uint8_t length = 0;
    };
    std::optional<Transfer> upload(std::uint16_t index, std::uint8_t sub_index);
    std::optional<Transfer> download(std::uint16_t index, std::uint8_t sub_index, std::uint32_t value,
                                     std::uint8_t length);

    // The words the master sends in RPDO1..4, often enough for their monitoring, as a PLC would.
    std::array<device::PdoWords, facts::rpdo_count>& outputs() { return outputs_; }
    void send_outputs();

  private:
    std::optional<Transfer> finish_transfer();
    void send_heartbeat();

    const image::Image* image_;
    std::ostream* out_;
    Time end_;
    simulation::Plant plant_;
    simulation::MasterNode node_;
    std::array<device::PdoWords, facts::rpdo_count> outputs_{};
};

}  // namespace cgw::gateway_cli
