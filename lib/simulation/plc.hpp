// What a simple PLC does for the gateway: it sends the active receive PDOs, often enough for their
// monitoring, and the heartbeat that the gateway watches; if asked to, it starts the gateway when it booted.
#pragma once

#include <array>
#include <map>
#include <optional>

#include "device/governor_link.hpp"
#include "facts/gateway.hpp"
#include "image/image.hpp"
#include "simulation/bus.hpp"
#include "simulation/master_node.hpp"

namespace cgw::simulation {

class Plc final : public Participant {
  public:
    // Attached to `bus` for the clock only; the frames are `node`'s. Image and node outlive the PLC.
    Plc(Bus& bus, MasterNode& node, const image::Image& image);

    using Outputs = std::array<device::PdoWords, facts::rpdo_count>;

    // The words of RPDO1..4; in effect after send_outputs().
    Outputs& outputs() { return outputs_; }
    const Outputs& outputs() const { return outputs_; }

    // Outputs that leave the plant as it is: sensors as measured at rated speed and 60 % load, load enabled,
    // every other switch off, no sensor flagged.
    void set_healthy_outputs();

    // From now on the outputs as they are, in every active RPDO that is not silent.
    void send_outputs();
    void send_heartbeat();

    // NMT start, `start_delay` after every boot-up of the gateway.
    void start_after_boot_up(bool on) { starts_ = on; }
    static constexpr Time start_delay = 100'000;  // us

    // Stops and resumes one of RPDO1..4, or the heartbeat.
    void silence_rpdo(std::uint8_t rpdo, bool silent);
    void silence_heartbeat(bool silent);
    bool silent(std::uint8_t rpdo) const { return silent_[rpdo - 1U]; }

    // A sensor or switch that comes over CANopen, by its 9nn or 8nn number; false: it does not.
    bool set_sensor(std::uint16_t number, std::uint16_t word);
    bool flag_sensor(std::uint16_t number, bool faulty);
    bool set_switch(std::uint16_t number, bool on);

    Time poll(Time now) override;

  private:
    void produce(std::uint8_t rpdo);

    MasterNode* node_;
    const image::Image* image_;
    Outputs outputs_{};
    std::array<bool, facts::rpdo_count> silent_{};
    bool starts_ = false;
    std::size_t boot_ups_seen_ = 0;
    Time start_due_ = canopen::never;
};

// What the image says of a sensor or switch that comes over CANopen, by its 9nn or 8nn number.
std::optional<image::Sensor> find_sensor(const image::Image& image, std::uint16_t number);
std::optional<image::SwitchFunction> find_switch(const image::Image& image, std::uint16_t number);

// The active transmit PDO that carries a parameter, and where.
struct WordPlace {
    image::Pdo pdo;
    std::size_t word = 0;  // 0..3
};
std::optional<WordPlace> find_word(const image::Image& image, std::uint16_t parameter);

// Words by parameter, of all transmit PDOs that `node` has received.
std::map<std::uint16_t, std::uint16_t> received_words(const MasterNode& node, const image::Image& image);

// `node` listens to the active transmit PDOs.
void subscribe_transmit_pdos(MasterNode& node, const image::Image& image);

}  // namespace cgw::simulation
