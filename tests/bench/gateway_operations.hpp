// What a gateway does over and over, one call each, for measuring.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/bytes.hpp"
#include "device/gateway.hpp"
#include "image/image.hpp"

namespace cgw::bench {

// The image of a valid parameter file; throws when it is none.
base::Bytes image_of(const std::string& parameter_file);

struct CountingPort final : frame::FramePort {
    bool send(const frame::Frame& frame) override {
        ++frames;
        last = frame;
        return true;
    }
    std::uint64_t frames = 0;
    frame::Frame last;
};

struct SilentLink final : device::GovernorLink {
    void status_changed(const device::GatewayStatus& /*status*/) override {}
    void process_data(std::uint8_t /*rpdo*/, const device::PdoWords& words) override { last = words; }
    device::PdoWords last{};
};

// A gateway with everything a gateway can carry (tests/data/full.toml), in Operational.
class RunningGateway {
  public:
    RunningGateway();

    CountingPort port;
    SilentLink link;
    device::Gateway gateway{port, link};
    device::GovernorData data;
    canopen::Time now = 0;

  private:
    base::Bytes bytes_;
    image::Image image_;
};

struct Operation {
    std::string_view name;
    void (*run)(RunningGateway& running);
    std::uint64_t frames;   // that one run sends
    bool received = false;  // one run is one frame from the bus
};
std::span<const Operation> operations();

}  // namespace cgw::bench
