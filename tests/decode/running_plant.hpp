// A parameter file compiled, its gateway running beside the simulated governor, and its CAN database read.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "base/bytes.hpp"
#include "dbc_reader.hpp"
#include "driver/check_file.hpp"
#include "image/image.hpp"
#include "simulation/master_node.hpp"
#include "simulation/plant.hpp"

namespace cgw::test {

using canopen::Time;
inline constexpr Time second = 1'000'000;

class RunningPlant {
  public:
    // Throws when the file is not valid.
    explicit RunningPlant(const std::string& path);

    const driver::CheckedFile& file() const { return file_; }
    const config::Configuration& configuration() const { return file_.configuration; }
    const image::Image& image() const { return image_; }
    simulation::Plant& plant() { return *plant_; }
    simulation::SimulatedGovernor& governor() { return plant_->governor(); }
    simulation::MasterNode& node() { return *node_; }

    const DbcMessage& message(const config::Pdo& pdo) const;
    const DbcMessage& message(const std::string& name) const { return messages_.at(name); }

    // Boots and starts the gateway. Its partner sends a heartbeat and all receive PDOs, with zeros at first;
    // or nobody else is there.
    void start();
    void start_alone();
    void run_for(Time time) { plant_->run_until(plant_->now() + time); }
    // Encoded by the caller, from now on in every period; the frame has the length of the message.
    void send(const DbcMessage& message, const frame::Frame& frame);

  private:
    static constexpr Time period = 20'000;  // shorter than any monitoring time of the samples

    driver::CheckedFile file_;
    cgw::base::Bytes bytes_;
    image::Image image_;
    std::map<std::string, DbcMessage> messages_;
    std::unique_ptr<simulation::Plant> plant_;
    std::unique_ptr<simulation::MasterNode> node_;
};

}  // namespace cgw::test
