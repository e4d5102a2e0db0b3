// What the governor takes from the receive PDOs: switch functions and sensors, and when they hold (D55).
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "device/governor_link.hpp"
#include "image/image.hpp"

namespace cgw::simulation {

class CanopenInputs {
  public:
    explicit CanopenInputs(const image::Image& image) : image_(&image) {}

    // What the gateway says of itself. Entering or leaving Operational forgets what was received.
    void follow(const device::GatewayStatus& gateway);
    void receive(std::uint8_t rpdo, const device::PdoWords& words);

    // A switch function by its 8nn number; nothing when it does not come over CANopen. Logically 0, also when
    // low-active, while it cannot be trusted (D55).
    std::optional<bool> switch_function(std::uint16_t number) const;

    struct SensorValue {
        bool carried = false;  // comes over CANopen
        bool faulty = false;
        bool received = false;   // since entering Operational
        std::uint16_t word = 0;  // as received
        bool usable() const { return carried && received && !faulty; }
    };
    // A sensor by its 9nn number.
    SensorValue sensor(std::uint16_t number) const;

  private:
    SensorValue value_of(const image::Sensor& sensor) const;
    bool operational() const { return gateway_.state == device::GatewayState::operational; }
    bool late(std::size_t rpdo) const;    // its monitoring has tripped
    bool absent(std::size_t rpdo) const;  // unmonitored, and never received

    const image::Image* image_;
    device::GatewayStatus gateway_;
    static constexpr std::size_t receive_pdos = 4;
    std::array<bool, receive_pdos> received_{};
    std::array<device::PdoWords, receive_pdos> words_{};
};

}  // namespace cgw::simulation
