// What a frame means, one after another: services of CiA 301, and the plant's PDOs in engineering units.
#pragma once

#include <span>
#include <string>

#include "frame/frame.hpp"
#include "traffic/sdo_listener.hpp"
#include "traffic/service.hpp"

namespace cgw::traffic {

struct Meaning {
    Owner owner{};
    std::string name;  // name_of(owner)
    std::string text;  // one line of printable text, "" where the name says it all
};

// Keeps what SDO transfers need; memory does not grow with the frames.
class Decoder {
  public:
    // Refers to the subject, which outlives it.
    explicit Decoder(const Subject& subject) : owners_(subject), sdo_(subject) {}

    // Frames in the order in which they were on the bus.
    Meaning decode(const frame::Frame& frame);

    const Owners& owners() const { return owners_; }

  private:
    std::string text_of(const Owner& owner, const frame::Frame& frame, std::span<const std::uint8_t> data);

    Owners owners_;
    SdoListener sdo_;
};

// The values of a PDO's signals: "Speed 1500.02 1/min, ActPos 40 %"; of errors those that are present.
std::string pdo_text(const signals::Frame& pdo, std::span<const std::uint8_t> data);

// "01 A0 FF"
std::string bytes_text(std::span<const std::uint8_t> data);

}  // namespace cgw::traffic
