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

    // Entering or leaving Operational forgets what was received.
    void set_operational(bool operational);
    void receive(std::uint8_t rpdo, const device::PdoWords& words);

    // A switch function by its 8nn number; nothing when it does not come over CANopen. Logically 0, also when
    // low-active, while not Operational or RPDO1 was never received.
    std::optional<bool> switch_function(std::uint16_t number) const;

    struct SensorValue {
        bool carried = false;  // comes over CANopen
        bool faulty = false;
        std::uint16_t word = 0;  // as received; meaningless when faulty
    };
    // A sensor by its 9nn number.
    SensorValue sensor(std::uint16_t number) const;

  private:
    SensorValue value_of(const image::Sensor& sensor) const;

    const image::Image* image_;
    bool operational_ = false;
    static constexpr std::size_t receive_pdos = 4;
    std::array<bool, receive_pdos> received_{};
    std::array<device::PdoWords, receive_pdos> words_{};
};

}  // namespace cgw::simulation
