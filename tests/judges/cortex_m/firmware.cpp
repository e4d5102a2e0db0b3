// The smallest firmware with everything a gateway needs: two CAN controllers, a clock, the embedded image.
// The controllers are memory-mapped mailboxes of no particular chip, so that nothing but the gateway counts
// when the linked program is measured.
#include "device/gateway.hpp"
#include "link/gateway_end.hpp"

extern "C" {
extern const unsigned char cgw_config_image[];
extern const unsigned int cgw_config_image_size;
}

namespace {

using namespace cgw;

struct Mailbox {
    std::uint32_t ready;
    std::uint32_t id;
    std::uint32_t length;
    std::uint32_t data[2];
};

struct Controller {
    Mailbox received;
    Mailbox to_send;  // ready: it may be filled
};

Controller volatile& can1_registers = *reinterpret_cast<Controller volatile*>(0x4000'0000);
Controller volatile& can2_registers = *reinterpret_cast<Controller volatile*>(0x4000'1000);
std::uint32_t const volatile& microseconds = *reinterpret_cast<std::uint32_t const volatile*>(0x4000'2000);
std::uint32_t volatile& halted = *reinterpret_cast<std::uint32_t volatile*>(0x4000'2004);

class Can final : public frame::FramePort {
  public:
    explicit Can(Controller volatile& registers) : registers_(registers) {}

    bool send(const frame::Frame& frame) override {
        Mailbox volatile& box = registers_.to_send;
        if (box.ready == 0) {
            return false;
        }
        box.id = frame.id;
        box.length = frame.length;
        box.data[0] = wire::load_u32(&frame.data[0]);
        box.data[1] = wire::load_u32(&frame.data[4]);
        box.ready = 0;
        return true;
    }

    bool receive(frame::Frame& frame) {
        Mailbox volatile& box = registers_.received;
        if (box.ready == 0) {
            return false;
        }
        frame.id = box.id;
        frame.length = static_cast<std::uint8_t>(box.length);
        wire::store_u32(&frame.data[0], box.data[0]);
        wire::store_u32(&frame.data[4], box.data[1]);
        box.ready = 0;
        return true;
    }

  private:
    Controller volatile& registers_;
};

canopen::Time now() {
    static canopen::Time time = 0;
    time += microseconds - static_cast<std::uint32_t>(time);
    return time;
}

image::Image configuration;
Can can1(can1_registers);
Can can2(can2_registers);
link::GatewayEnd governor(can1);
device::Gateway gateway(can2, governor);

}  // namespace

int main() {
    const image::Status status = image::Image::open({cgw_config_image, cgw_config_image_size}, configuration);
    if (status != image::Status::ok) {
        halted = static_cast<std::uint32_t>(status);
        return 1;
    }
    governor.connect(gateway);
    governor.open(configuration, 1);
    gateway.open(configuration, now());
    while (true) {
        frame::Frame frame;
        if (can1.receive(frame)) {
            governor.receive(frame, now());
        }
        if (can2.receive(frame)) {
            gateway.receive(frame, now());
        }
        governor.poll(now());
        gateway.poll(now());
    }
}
