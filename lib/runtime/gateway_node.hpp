// The gateway in real time: its core between two CAN connections, driven by a loop. CAN1 is a channel with a
// governor somewhere else, or simulated inside the program and run in step with the clock.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "device/gateway.hpp"
#include "image/image.hpp"
#include "link/gateway_end.hpp"
#include "media/loop.hpp"
#include "runtime/clock.hpp"
#include "runtime/diagnosis.hpp"
#include "runtime/events.hpp"
#include "runtime/simulated_can1.hpp"

namespace cgw::runtime {

// A connection and how it is called.
struct Connection {
    std::string name;
    std::unique_ptr<media::Channel> channel;  // none, for CAN1 only: a simulated governor
};

class GatewayNode final : public media::Source {
  public:
    // `boot` differs from the number of the run before, so that a governor notices the restart. Image and
    // `events` outlive the node.
    GatewayNode(const image::Image& image, Connection can1, Connection can2, std::uint8_t boot,
                Events& events);

    // Why the gateway does not take the image; ok when it runs.
    device::OpenStatus status() const { return status_; }

    device::Gateway& gateway() { return gateway_; }
    // "Clear errors", as a service tool at the gateway does (GWM 9.1); the governor's are cleared with them.
    void clear_errors(Time steady_now);
    Diagnosis diagnosis() const;
    // Bits per second, as far as the connection knows.
    std::optional<std::uint32_t> bit_rate(Side side) const;

    void watch(std::vector<pollfd>& entries) const override;
    void service(std::span<const pollfd> entries, Time steady_now) override;
    Time deadline() const override;

  private:
    // Counts what leaves; where the medium does not report it, the log hears of it here.
    struct Port final : frame::FramePort {
        Port(GatewayNode& node, Side side) : of(&node), where(side) {}
        bool send(const frame::Frame& frame) override;
        GatewayNode* of;
        Side where;
    };
    struct Listener final : media::ChannelListener {
        Listener(GatewayNode& node, Side side) : of(&node), where(side) {}
        void frame(const frame::Frame& frame, Time now) override;
        void link_changed(media::LinkState state, std::string_view reason, Time now) override;
        void frames_lost(std::uint64_t count, Time now) override;
        GatewayNode* of;
        Side where;
    };
    // Between gateway and link, to hear of every change.
    struct StatusTap final : device::GovernorLink {
        explicit StatusTap(GatewayNode& node) : of(&node) {}
        void status_changed(const device::GatewayStatus& status) override;
        void process_data(std::uint8_t rpdo, const device::PdoWords& words) override;
        GatewayNode* of;
    };
    // The gateway's place on a simulated CAN1.
    struct Can1Place final : simulation::Participant {
        explicit Can1Place(GatewayNode& node) : of(&node) {}
        Time poll(Time now) override;
        void receive(const frame::Frame& frame, Time now) override;
        GatewayNode* of;
    };
    struct End {
        Connection connection;
        BusView view;
    };

    End& end(Side side) { return ends_[static_cast<std::size_t>(side)]; }
    const End& end(Side side) const { return ends_[static_cast<std::size_t>(side)]; }
    bool channel_on(Side side) const { return end(side).connection.channel != nullptr; }
    void serve(Side side, std::span<const pollfd> entries, std::size_t& position, Time steady_now);
    void run_simulation();
    void take_can1(const frame::Frame& frame, Time now);
    void hear_refusal();

    Events* events_;
    bool started_ = false;
    RunClock clock_{0};  // begins with the first service()
    Time now_ = 0;       // the gateway's
    std::array<End, 2> ends_;
    Port can1_port_{*this, Side::can1};
    Port can2_port_{*this, Side::can2};
    std::array<Listener, 2> listeners_{{{*this, Side::can1}, {*this, Side::can2}}};
    StatusTap tap_{*this};
    Can1Place can1_place_{*this};
    link::GatewayEnd link_{can1_port_};
    device::Gateway gateway_{can2_port_, tap_};
    const image::Image* image_;
    std::optional<SimulatedCan1> simulated_;
    device::OpenStatus status_ = device::OpenStatus::ok;
    device::GatewayStatus told_;
    unsigned refusals_ = 0;  // told already
    Time gateway_deadline_ = 0;
    Time link_deadline_ = 0;
    std::array<std::optional<Time>, 32> heard_{};  // when a governor, by its node number, last talked to us
};

}  // namespace cgw::runtime
