// A governor's end of the governor link: it initialises the gateway, sends what one main cycle delivers, and
// keeps a copy of the gateway's state. It gives up after three attempts (12412) until errors are cleared.
#pragma once

#include <cstdint>

#include "device/governor_link.hpp"
#include "link/governor_half.hpp"
#include "link/outbox.hpp"
#include "link/protocol.hpp"
#include "link/telegram.hpp"

namespace cgw::link {

// What the governor hears; no call may call back into the link.
class GovernorListener {
  public:
    virtual void gateway_status(const device::GatewayStatus& status) = 0;
    virtual void process_data(std::uint8_t rpdo, const device::PdoWords& words) = 0;
    // "Clear errors" at the gateway.
    virtual void errors_cleared() {}

  protected:
    ~GovernorListener() = default;
};

// The gateway's reason, as its refusal telegram carries it.
struct RefusalReport {
    std::uint8_t item_kind = 0;  // of ItemKind, or refusal::incomplete
    std::uint8_t position = 0;
    std::uint16_t governor_value = 0;
    std::uint16_t gateway_value = 0;
};

class GovernorEnd {
  public:
    enum class Phase : std::uint8_t {
        searching,     // the gateway is not heard
        initialising,  // Init is commanded
        configuring,   // the items of the configuration are on their way
        concluding,    // all are sent; the gateway's answer is awaited
        starting,      // Pre-Operational is commanded
        running,
        given_up,  // three attempts failed
    };

    GovernorEnd(frame::FramePort& can1, GovernorListener& listener) : port_(&can1), listener_(&listener) {}

    // With every reset of the governor; the image, whose governor half this governor has, outlives the link.
    // `boot` differs from the number of the reset before.
    void open(const image::Image& image, std::uint8_t boot);

    // Once per main cycle of the governor. `flags` are those of link::cycle; a gateway that was lost is
    // added. While CAN1 has not taken the data of the main cycle before, newer data wait for the next call.
    void main_cycle(const device::GovernorData& data, std::uint8_t flags, Time now);
    void receive(const frame::Frame& frame, Time now);
    // Offers what the port did not take before.
    void poll() { outbox_.send(*port_); }
    bool pending() const { return outbox_.pending(); }

    // "Clear errors" at the governor: clears the gateway's too, and allows three more attempts.
    void clear_errors();

    Phase phase() const { return phase_; }
    // The gateway was heard within link::silence.
    bool online(Time now) const { return heard_ && now - last_heard_ <= silence; }
    unsigned failed_attempts() const { return failed_attempts_; }
    const RefusalReport& refusal() const { return refusal_; }  // the last one

  private:
    void hear_status(const Telegram& telegram, Time now);
    void hear_refusal(const Telegram& telegram);
    void hear_process_data(const Telegram& telegram);
    void hear_boot(std::uint8_t boot, std::uint8_t clearings);
    void lose_gateway();
    void allow_attempts();
    void follow_answer(Answer answer, Time now);
    void fail(Time now);
    void begin(Time now);
    void step(Time now);
    void command(device::GovernorCommand command, std::uint8_t flags, Phase next, Time now);
    void send_items(Time now);
    frame::Frame next_items();
    void conclude(Time now);
    void send_data(const device::GovernorData& data, std::uint8_t flags);
    void send_analogue(const device::GovernorData& data);
    void send_errors(const device::GovernorData& data);

    frame::FramePort* port_;
    GovernorListener* listener_;
    Outbox outbox_;
    Address self_{DeviceType::governor, 0};
    Address gateway_{DeviceType::gateway, 0};
    GovernorHalf half_;
    Phase phase_ = Phase::searching;
    std::uint8_t boot_ = 0;
    std::uint8_t clearings_ = 0;
    std::uint8_t cycles_ = 0;
    std::uint8_t sequence_ = 0;
    std::uint16_t next_item_ = 0;
    unsigned failed_attempts_ = 0;
    Time phase_began_ = 0;
    Time next_attempt_ = 0;
    RefusalReport refusal_;

    // Of the gateway, once heard.
    bool heard_ = false;
    Time last_heard_ = 0;
    std::uint8_t gateway_boot_ = 0;
    bool gateway_was_reset_ = false;
    std::uint8_t gateway_clearings_ = 0;
    bool lost_ = false;  // heard before, and silent now
    device::GatewayStatus status_;

    device::GovernorData sent_;  // by the last telegrams
    bool send_everything_ = true;
};

}  // namespace cgw::link
