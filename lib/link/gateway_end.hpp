// The gateway's end of the governor link: telegrams on CAN1 to calls of the gateway, and back. It compares
// the governor's half of the configuration with the gateway's image (D56).
#pragma once

#include <array>
#include <cstdint>

#include "device/gateway.hpp"
#include "link/governor_half.hpp"
#include "link/outbox.hpp"
#include "link/protocol.hpp"
#include "link/telegram.hpp"

namespace cgw::link {

// Why a configuration was refused.
struct Refusal {
    bool incomplete = false;  // telegrams are missing; the rest means nothing then
    Item expected;            // the gateway's
    std::uint16_t received = 0;
};

class GatewayEnd final : public device::GovernorLink {
  public:
    explicit GatewayEnd(frame::FramePort& can1) : port_(&can1) {}

    void connect(device::Gateway& gateway) { gateway_ = &gateway; }
    // With every reset of the gateway, before Gateway::open; the image outlives the link. `boot` differs from
    // the number of the reset before.
    void open(const image::Image& image, std::uint8_t boot);

    void receive(const frame::Frame& frame, Time now);
    // "Clear errors" at the gateway: clears its own, and lets the governor try to initialise it again.
    void clear_errors(Time now);

    // Sends what waits; receive PDOs and changes of status at most once per main cycle of the governor, so
    // that no traffic on CAN2 takes CAN1 away from it. Returns when time alone will make something due.
    Time poll(Time now);
    bool pending() const { return outbox_.pending(); }

    Answer answer() const { return answer_; }
    const Refusal& refusal() const { return refusal_; }  // the last one
    unsigned refusals() const { return refusals_; }      // of configurations, since open()

    // Inline: without RTTI a table of virtual functions of this room's own would not do for rooms with it.
    void status_changed(const device::GatewayStatus& status) override { follow(status); }
    void process_data(std::uint8_t rpdo, const device::PdoWords& words) override { forward(rpdo, words); }

  private:
    bool is_new(std::uint8_t sequence, std::uint8_t boot);
    void obey(const Telegram& telegram, Time now);
    void obey(device::GovernorCommand command, std::uint8_t flags, Time now);
    void strike(device::Fault fault, Time now);
    void notice_duplicate(Time now);
    void forget_duplicate(Time now);
    void compare(const Telegram& telegram);
    void refuse(const Refusal& refusal);
    void conclude(const Telegram& telegram);
    void take_analogue(const Telegram& telegram);
    void take_errors(const Telegram& telegram);
    void complete_cycle(const Telegram& telegram, Time now);
    void follow(const device::GatewayStatus& status);
    void forward(std::uint8_t rpdo, const device::PdoWords& words);
    bool has_news() const { return status_news_ || error_news_ || process_data_news_ != 0; }
    void tell_news(Time now);
    void tell_status();
    void tell_process_data();
    void tell_errors();
    void tell_refusal();

    frame::FramePort* port_;
    device::Gateway* gateway_ = nullptr;
    Outbox outbox_;
    Address self_{DeviceType::gateway, 0};
    Address governor_{DeviceType::governor, 0};
    GovernorHalf half_;
    device::GatewayStatus status_;
    device::GovernorData data_;
    Time next_status_ = 0;
    std::uint8_t boot_ = 0;
    std::uint8_t own_clearings_ = 0;

    // What changed since it was told.
    Time spacing_ = 0;  // us
    Time next_news_ = 0;
    bool status_news_ = false;
    bool error_news_ = false;
    std::uint8_t process_data_news_ = 0;  // bit r - 1: RPDO r
    std::array<device::PdoWords, facts::rpdo_count> process_data_{};

    Time duplicate_until_ = canopen::never;  // another device with our number was heard

    // Of the governor, once `heard_`.
    bool heard_ = false;
    std::uint8_t governor_boot_ = 0;
    std::uint8_t clearings_ = 0;
    std::uint8_t cycles_ = 0;

    bool commanded_ = false;
    std::uint8_t sequence_ = 0;
    std::uint8_t command_boot_ = 0;
    Answer answer_ = Answer::none;
    bool configuration_fits_ = false;
    std::uint16_t next_item_ = 0;
    bool mismatch_ = false;
    Refusal refusal_;
    unsigned refusals_ = 0;
};

}  // namespace cgw::link
